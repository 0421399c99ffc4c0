#include "app/gui/view/scene_view.h"

#include <vtkCamera.h>
#include <vtkLight.h>
#include <vtkNew.h>
#include <vtkRenderer.h>

#include <QEvent>
#include <QPainter>
#include <QVBoxLayout>
#include <algorithm>
#include <utility>

#include "app/gui/view/scene_view_impl.h"
#include "core/base/units.h"
#include "core/scene/edit.h"

namespace underact::gui {
namespace {

constexpr int kLook_ms = 200, kGhost_ms = 800;
const QMarginsF kRoom_px(52.0, 60.0, 52.0, 44.0);  // the hint stands at the top

/// From the front, a little from the right and above: the sphere, the stylus and the arm behind it stand apart.
OrbitCamera firstLook() {
  OrbitCamera camera;
  camera.azimuth_rad = 32.0 * kRadPerDegree;
  camera.elevation_rad = 20.0 * kRadPerDegree;
  return camera;
}

/// What of a snapshot can be seen.
bool looksAlike(const servo::Snapshot& a, const servo::Snapshot& b) {
  const tick::TickReport &one = a.report, &other = b.report;
  if (a.mode != b.mode || one.fault.kind != other.fault.kind || (one.cut_N > 0.0) != (other.cut_N > 0.0)) return false;
  if (one.sample.q_rad != other.sample.q_rad || one.force.f_T_W() != other.force.f_T_W()) return false;
  return std::equal(one.held.begin(), one.held.end(), other.held.begin(), other.held.end(),
                    [](const tick::Held& x, const tick::Held& y) {
                      return x.acts == y.acts && x.status == y.status && x.p_WP == y.p_WP &&
                             x.arc.turn_rad == y.arc.turn_rad && x.arc.share == y.arc.share &&
                             x.robot.joints == y.robot.joints && x.robot.theta == y.robot.theta &&
                             x.robot.moment_W == y.robot.moment_W;
                    });
}

}  // namespace

SceneView::Impl::Impl(SceneView* owner) : view(owner), camera(firstLook()) {
  surface =
      new GlSurface([this](QSize pixels) { before(pixels); }, [this](QPainter& painter) { paintWords(painter); }, view);
  const vtkNew<vtkLight> key;  // follows the camera, a little from its left and above
  key->SetLightTypeToCameraLight();
  key->SetPosition(-0.4, 0.6, 1.0);
  key->SetFocalPoint(0.0, 0.0, 0.0);
  surface->renderer().SetAutomaticLightCreation(false);
  surface->renderer().AddLight(key);
  movement.setDuration(kLook_ms);
  movement.setStartValue(0.0);
  movement.setEndValue(1.0);
  movement.setEasingCurve(QEasingCurve::InOutCubic);
  connect(&movement, &QVariantAnimation::valueChanged, view, [this](const QVariant& share) {
    camera = between(from, to, share.toDouble());
    surface->update();
  });
  ghost_way.setDuration(kGhost_ms);
  ghost_way.setStartValue(0.0);
  ghost_way.setEndValue(1.0);
  ghost_way.setEasingCurve(QEasingCurve::InOutCubic);
  connect(&ghost_way, &QVariantAnimation::valueChanged, view, [this](const QVariant& share) {
    kinematics.setShare(share.toDouble());
    surface->update();
  });
}

void SceneView::Impl::before(QSize pixels) {
  const double scale = pixels.height() / std::max(1.0, size().height());
  if (actors_changed) {
    actors_changed = false;
    vtkRenderer& renderer = surface->renderer();
    renderer.RemoveAllViewProps();
    for (vtkActor* actor : hand.solids()) renderer.AddActor(actor);
    for (const auto& target : hand.targets()) renderer.AddActor(target);
    for (const auto& lines : {workspace.lines(), constraint.lines(), influence.lines(), robots.lines(), path.lines(),
                              hand.lines(), kinematics.lines()}) {
      for (vtkActor* actor : lines) renderer.AddActor(actor);
    }
    for (const auto& tint : constraint.tints()) renderer.AddActor(tint);
    for (vtkActor* actor : kinematics.marks()) renderer.AddActor(actor);
    renderer.AddActor(influence.rings());
    renderer.AddActor(hand.mark());
  }
  constraint.setLineWidth(scale);
  workspace.setLineWidth(scale);
  hand.setLineWidth(scale);
  kinematics.setLineWidth(scale);
  influence.setLineWidth(scale);
  robots.setLineWidth(scale);
  path.setLineWidth(scale);
  constraint.update(camera.eye_mm());
  workspace.update(camera);
  hand.update(camera, size());
  kinematics.update(camera);
  influence.update(camera, size());
  robots.update(camera);
  vtkCamera* eye = surface->renderer().GetActiveCamera();
  const Vec3 eye_mm = camera.eye_mm(), up_W = camera.up_W();
  eye->SetPosition(eye_mm.data());
  eye->SetFocalPoint(camera.focus_mm.data());
  eye->SetViewUp(up_W.data());
  eye->SetViewAngle(OrbitCamera::kViewAngle_rad / kRadPerDegree);
  const double far_mm = camera.distance_mm + camera.focus_mm.norm() + 600.0;
  eye->SetClippingRange(std::max(0.01 * far_mm, camera.distance_mm - camera.focus_mm.norm() - 600.0), far_mm);
}

void SceneView::Impl::showArm() {
  hand.present(*shown);
  kinematics.present(shown->report.sample.q_rad);
  influence.present(shown->report);
  robots.present(*shown);
}

void SceneView::Impl::paintWords(QPainter& painter) {
  WordsState state;
  state.theme = theme;
  state.font = view->font();
  state.size = size();
  state.scale = view->devicePixelRatioF();
  state.camera = camera;
  state.hint = hint;
  if (hand.known() && shown && shown->mode == servo::Mode::Faulted) {
    state.fault = QString::fromStdString(describe(shown->report.fault));
  }
  state.force_N = hand.force_N();
  state.force_limit_N = force_limit_N;
  state.limited = hand.limited();
  state.focus = view->hasFocus();
  std::vector<Label> labels = workspace.labels();
  labels.insert(labels.end(), kinematics.labels().begin(), kinematics.labels().end());
  labels.insert(labels.end(), influence.labels().begin(), influence.labels().end());
  state.has_influence = influence.isSeen();
  labels.insert(labels.end(), robots.labels().begin(), robots.labels().end());
  words.paint(painter, state, labels);
}

std::vector<Vec3> SceneView::Impl::extent() const {
  std::vector<Vec3> points = constraint.extent_mm();
  const Vec3 half_mm = workspaceHalf_mm();
  for (int corner = 0; corner < 8; ++corner) {
    points.push_back(
        half_mm.cwiseProduct(Vec3((corner & 1) != 0 ? 1 : -1, (corner & 2) != 0 ? 1 : -1, (corner & 4) != 0 ? 1 : -1)));
  }
  const std::vector<Vec3> of_robots = robots.extent_mm();
  points.insert(points.end(), of_robots.begin(), of_robots.end());
  if (hand.known()) {
    points.push_back(kMillimetrePerMetre * hand.X_WT().translation());
    points.push_back(kMillimetrePerMetre * (hand.X_WT() * Vec3(0.0, 0.0, kBody_m)));
    if (layers.arm) {
      points.push_back(kMillimetrePerMetre * hand.skeleton().p_WShoulder);
      points.push_back(kMillimetrePerMetre * hand.skeleton().p_WElbow);
    }
    const std::vector<Vec3> ghosts = kinematics.extent_mm();
    points.insert(points.end(), ghosts.begin(), ghosts.end());
  }
  return points;
}

void SceneView::Impl::fit() {
  OrbitCamera& ends_as = movement.state() == QAbstractAnimation::Running ? to : camera;
  ends_as = fitted(ends_as, size(), extent(), kRoom_px);
}

void SceneView::Impl::moveTo(const OrbitCamera& wanted) {
  movement.stop();
  from = camera;
  to = wanted;
  if (view->isVisible()) {
    movement.start();
  } else {
    camera = to;
  }
  surface->update();
}

SceneView::SceneView(QWidget* parent) : QWidget(parent), impl_(std::make_unique<Impl>(this)) {
  setObjectName(QStringLiteral("view.scene"));
  setAccessibleName(tr("3D view"));
  setAccessibleDescription(tr("What the stylus is held to, the stylus and the force on it. Arrow keys move the hand."));
  setFocusPolicy(Qt::StrongFocus);
  setMouseTracking(true);
  setMinimumSize(160, 120);
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->addWidget(impl_->surface);
  connect(impl_->surface, &GlSurface::drawn, this, &SceneView::drawn);
  setTheme(Theme::light());
  setScene({});
}

SceneView::~SceneView() {
  impl_->movement.stop();
  impl_->ghost_way.stop();
  delete impl_->surface;  // while what it draws is still there
}

void SceneView::setScene(const scene::Description& scene) {
  const arm::Preset* preset = arm::findPreset(scene.arm);
  if (preset == nullptr) preset = arm::findPreset(arm::kDefaultArm);
  impl_->hand.setGeometry(preset->geometry);
  impl_->kinematics.setArm(*preset);
  impl_->hand.setConstraints(scene.constraints.size());
  impl_->constraint.setScene(scene);
  impl_->robots.setScene(scene);
  impl_->scene = scene;
  impl_->workspace.setBase(kMillimetrePerMetre * preset->geometry.p_WB);
  impl_->actors_changed = true;
  setForceLimit(preset->continuous_force_N);
  if (impl_->shown) impl_->showArm();
  if (impl_->camera_is_mine) impl_->fit();
  impl_->surface->update();
}

void SceneView::followEdit(const scene::Description& scene) {
  const scene::Change change = scene::changeBetween(impl_->scene, scene);
  if (change == scene::Change::Gains) return;
  const bool is_mine = std::exchange(impl_->camera_is_mine, impl_->camera_is_mine && change == scene::Change::Scene);
  setScene(scene);  // what only moves a little does not move the camera
  impl_->camera_is_mine = is_mine;
}

void SceneView::present(const servo::Snapshot& snapshot) {
  if (impl_->shown && looksAlike(*impl_->shown, snapshot)) return;
  const bool first = !impl_->hand.known();
  impl_->shown = snapshot;
  impl_->showArm();
  if (first && impl_->camera_is_mine) impl_->fit();
  impl_->surface->update();
}

void SceneView::setTheme(const Theme& theme) {
  impl_->theme = theme;
  impl_->surface->setBackground(theme.background);
  impl_->constraint.setTheme(theme);
  impl_->workspace.setTheme(theme);
  impl_->hand.setTheme(theme);
  impl_->kinematics.setTheme(theme);
  impl_->influence.setTheme(theme);
  impl_->robots.setTheme(theme);
  impl_->path.setTheme(theme);
  impl_->actors_changed = true;
  impl_->surface->update();
}

void SceneView::setLayers(const Layers& layers) {
  const bool more = layers.ghosts && !impl_->layers.ghosts;
  impl_->layers = layers;
  impl_->workspace.show(layers.workspace, layers.triads);
  impl_->hand.show(layers.arm, layers.target, layers.force);
  impl_->kinematics.show(layers.link_frames, layers.ghosts, layers.motion_ellipsoid, layers.force_ellipsoid);
  impl_->influence.show(layers.influence);
  impl_->robots.show(layers.robot);
  impl_->path.show(layers.path);
  if (more && impl_->camera_is_mine) look(Camera::Fit);  // ghosts reach further than the arm
  impl_->surface->update();
}

void SceneView::chooseSolution(const std::optional<arm::Branch>& branch) {
  impl_->ghost_way.stop();
  impl_->kinematics.choose(branch);
  if (branch && isVisible()) {
    impl_->ghost_way.start();
  } else {
    impl_->kinematics.setShare(1.0);
  }
  impl_->surface->update();
}

bool SceneView::ghostMoving() const {
  return impl_->ghost_way.state() == QAbstractAnimation::Running;
}

std::size_t SceneView::ghostsDrawn() const {
  return impl_->kinematics.ghostsDrawn();
}

std::size_t SceneView::robotsDrawn() const {
  return impl_->robots.robotsDrawn();
}

std::optional<arm::JointAngles> SceneView::chosenGhost_rad() const {
  return impl_->kinematics.chosen_rad();
}

const Layers& SceneView::layers() const {
  return impl_->layers;
}

void SceneView::look(Camera camera) {
  OrbitCamera wanted = impl_->movement.state() == QAbstractAnimation::Running ? impl_->to : impl_->camera;
  const auto from = [&wanted](double azimuth_deg, double elevation_deg) {
    wanted.azimuth_rad = azimuth_deg * kRadPerDegree;
    wanted.elevation_rad = elevation_deg * kRadPerDegree;
  };
  switch (camera) {
    case Camera::Fit:
      break;
    case Camera::Front:
      from(0, 0);
      break;
    case Camera::Back:
      from(180, 0);
      break;
    case Camera::Left:
      from(-90, 0);
      break;
    case Camera::Right:
      from(90, 0);
      break;
    case Camera::Top:
      from(0, 90);
      break;
    case Camera::Bottom:
      from(0, -90);
      break;
    case Camera::Isometric:
      from(45, 35.264);
      break;
  }
  impl_->camera_is_mine = true;  // it shows everything, and goes on doing so when the window changes
  impl_->moveTo(fitted(wanted, impl_->size(), impl_->extent(), kRoom_px));
}

bool SceneView::moving() const {
  return impl_->movement.state() == QAbstractAnimation::Running;
}

void SceneView::setRecordedPath(std::vector<PathPoint> path) {
  impl_->path.setPath(std::move(path));
  impl_->surface->update();
}

std::size_t SceneView::pathPartsDrawn() const {
  return impl_->path.parts();
}

void SceneView::setHint(const QString& text) {
  if (text == impl_->hint) return;
  impl_->hint = text;
  impl_->surface->update();
}

void SceneView::setForceLimit(double continuous_N) {
  impl_->force_limit_N = continuous_N;
  impl_->hand.setForceLimit(continuous_N);
  impl_->kinematics.setForceLimit(continuous_N);
  impl_->path.setForceLimit(continuous_N);
  if (impl_->shown) impl_->showArm();
  impl_->surface->update();
}

void SceneView::setHandAvailable(bool available) {
  impl_->hand_available = available;
  impl_->grip.forget();
}

void SceneView::setHandWish(const sim::HandWish& wish) {
  impl_->grip.set(wish);
}

QImage SceneView::picture() {
  if (impl_->surface->size() != size()) {  // never shown: no layout has been at work
    impl_->surface->setGeometry(rect());
    if (impl_->camera_is_mine) impl_->fit();
  }
  return impl_->surface->picture();
}

QPointF SceneView::screenOf(const Vec3& p_W) const {
  return project(impl_->camera, impl_->size(), kMillimetrePerMetre * p_W).pixel;
}

qint64 SceneView::framesDrawn() const {
  return impl_->surface->framesDrawn();
}
int SceneView::glErrors() const {
  return impl_->surface->errors();
}
QString SceneView::graphicsName() const {
  return impl_->surface->rendererName();
}

void SceneView::resizeEvent(QResizeEvent* event) {
  QWidget::resizeEvent(event);
  if (impl_->camera_is_mine) impl_->fit();
}

void SceneView::changeEvent(QEvent* event) {
  QWidget::changeEvent(event);
  if (event->type() == QEvent::FontChange) impl_->surface->update();
}

}  // namespace underact::gui
