#include "app/gui/view/scene_view.h"

#include <QEvent>
#include <QVBoxLayout>
#include <utility>

#include "app/gui/kit/accessible_widgets.h"
#include "app/gui/kit/tight_layout.h"
#include "app/gui/view/scene_view_impl.h"
#include "core/base/units.h"
#include "core/scene/edit.h"
#include "core/scene/scene_arm.h"

namespace underact::gui {
SceneView::SceneView(QWidget* parent) : QWidget(parent), impl_(std::make_unique<Impl>(this)) {
  setAccessibleRole(this, QAccessible::Canvas);
  setObjectName(QStringLiteral("view.scene"));
  setAccessibleName(tr("3D view"));
  setAccessibleDescription(tr("The constraint, the stylus and the force on it. The arrow keys move the hand."));
  setFocusPolicy(Qt::StrongFocus);
  setMouseTracking(true);
  setMinimumSize(160, 120);
  auto* layout = tight<QVBoxLayout>(this);
  layout->addWidget(impl_->surface);
  connect(impl_->surface, &GlSurface::drawn, this, &SceneView::drawn);
  setTheme(Theme::light());
  setScene({});
}

SceneView::~SceneView() {
  impl_->movement.stop();
  impl_->ghost_trajectory.stop();
  delete impl_->surface;  // while what it draws is still there
}

void SceneView::setScene(const scene::Description& scene) {
  const arm::Preset& preset = scene::armOf(scene);
  impl_->hand.setArm(scene::modelOf(scene));
  impl_->kinematics.setArm(preset, scene::modelOf(scene));
  impl_->hand.setScene(scene);
  impl_->constraint.setScene(scene);
  impl_->robots.setScene(scene);
  impl_->meshes.setScene(scene);
  impl_->scene = scene;
  impl_->workspace.setArm(scene::modelOf(scene));
  impl_->actors_changed = true;
  impl_->awaitArms();
  setForceLimit(preset.continuous_force_N);
  if (impl_->shown) impl_->showArm();
  impl_->turnToDesk();
  if (impl_->camera_is_mine) impl_->fit();
  impl_->surface->update();
}

void SceneView::followEdit(const scene::Description& scene) {
  const scene::Change change = scene::changeBetween(impl_->scene, scene);
  if (change == scene::Change::Gains) return;
  const bool is_mine = std::exchange(impl_->camera_is_mine, impl_->camera_is_mine && change == scene::Change::Scene);
  setScene(scene);  // small changes do not move the camera
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

void SceneView::showSecond(const scene::Description& scene) {
  if (!impl_->second) {
    impl_->second.emplace();
    impl_->second->setTheme(impl_->theme);
    impl_->second->setLayers(impl_->layers);
  }
  impl_->second->setScene(scene);
  impl_->awaitArms();
  impl_->actors_changed = true;
  if (impl_->camera_is_mine) moveCamera(Camera::Fit);
  impl_->surface->update();
}

void SceneView::placeSecond(const Pose& X_WS_mm) {
  if (!impl_->second) return;
  impl_->second->setPlace(X_WS_mm);
  if (impl_->camera_is_mine) moveCamera(Camera::Fit);
  impl_->surface->update();
}

void SceneView::presentSecond(const servo::Snapshot& snapshot) {
  if (impl_->second && impl_->second->present(snapshot)) impl_->surface->update();
}

void SceneView::hideSecond() {
  if (!impl_->second) return;
  impl_->second.reset();
  impl_->actors_changed = true;
  if (impl_->camera_is_mine) moveCamera(Camera::Fit);
  impl_->surface->update();
}

bool SceneView::showsSecond() const {
  return impl_->second.has_value();
}

void SceneView::setDesk(const std::optional<Desk>& desk) {
  impl_->desk.setDesk(desk);
  impl_->turnToDesk();
  if (impl_->camera_is_mine) impl_->moveTo(impl_->fitted(impl_->wanted()));  // so that the reference points are visible
  impl_->surface->update();
}

std::size_t SceneView::marksDrawn() const {
  return impl_->desk.marks();
}

void SceneView::setTheme(const Theme& theme) {
  impl_->theme = theme;
  impl_->surface->setBackground(theme.background);
  impl_->constraint.setTheme(theme);
  impl_->workspace.setTheme(theme);
  impl_->hand.setTheme(theme);
  impl_->shadow.setTheme(theme);
  impl_->kinematics.setTheme(theme);
  impl_->influence.setTheme(theme);
  impl_->robots.setTheme(theme);
  impl_->path.setTheme(theme);
  impl_->desk.setTheme(theme);
  impl_->drawings.setTheme(theme);
  impl_->meshes.setTheme(theme);
  if (impl_->second) impl_->second->setTheme(theme);
  impl_->actors_changed = true;
  impl_->surface->update();
}

void SceneView::setLayers(const Layers& layers) {
  const bool more = layers.ghosts && !impl_->layers.ghosts;
  impl_->layers = layers;
  impl_->workspace.show(layers.workspace, layers.triads);
  impl_->hand.show(layers.arm, layers.target, layers.force);
  impl_->shadow.show(layers.arm);
  impl_->kinematics.show(layers.link_frames, layers.ghosts, layers.motion_ellipsoid, layers.force_ellipsoid);
  impl_->influence.show(layers.influence);
  impl_->robots.show(layers.robot);
  impl_->path.show(layers.path);
  impl_->desk.show(layers.desk);
  impl_->meshes.show(layers);
  if (impl_->second) impl_->second->setLayers(layers);
  impl_->layers.section_mm = impl_->meshes.section_mm();
  impl_->turnToDesk();
  if (more && impl_->camera_is_mine) moveCamera(Camera::Fit);  // the ghosts reach farther than the arm
  impl_->surface->update();
}

void SceneView::chooseSolution(int number) {
  impl_->ghost_trajectory.stop();
  impl_->kinematics.choose(number);
  if (number > 0 && isVisible()) {
    impl_->ghost_trajectory.start();
  } else {
    impl_->kinematics.setShare(1.0);
  }
  impl_->surface->update();
}

bool SceneView::solutionMoving() const {
  return impl_->ghost_trajectory.state() == QAbstractAnimation::Running;
}

std::size_t SceneView::solutionsDrawn() const {
  return impl_->kinematics.solutionsDrawn();
}

std::size_t SceneView::robotsDrawn() const {
  return impl_->robots.robotsDrawn();
}

std::optional<arm::JointAngles> SceneView::chosenSolution_rad() const {
  return impl_->kinematics.chosen_rad();
}

const Layers& SceneView::layers() const {
  return impl_->layers;
}

void SceneView::moveCamera(Camera camera) {
  OrbitCamera wanted = impl_->wanted();
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
    case Camera::Home:
      from(kHomeAzimuth_deg, kHomeElevation_deg);
      break;
  }
  impl_->camera_is_mine = true;  // it shows everything, and continues to when the window is resized
  impl_->moveTo(impl_->fitted(wanted));
}

void SceneView::lookFrom(const Vec3& from_W) {
  impl_->camera_is_mine = true;
  impl_->moveTo(impl_->fitted(lookingFrom(impl_->wanted(), from_W)));
}

void SceneView::fitSelection() {
  const std::vector<Vec3> selected = impl_->selected();
  if (selected.empty()) return;
  impl_->camera_is_mine = false;
  impl_->moveTo(gui::fitted(impl_->wanted(), impl_->size(), selected, impl_->room_px()));
}

void SceneView::setParallel(bool on) {
  OrbitCamera wanted = impl_->wanted();
  if (wanted.parallel == on) return;
  wanted.parallel = on;
  impl_->moveTo(impl_->camera_is_mine ? impl_->fitted(wanted) : wanted);
  emit parallelChanged(on);
}

bool SceneView::isParallel() const {
  return impl_->wanted().parallel;
}

bool SceneView::moving() const {
  return impl_->movement.state() == QAbstractAnimation::Running;
}

void SceneView::draw(const QString& owner, const Drawing& drawing) {
  impl_->drawings.draw(owner, drawing);
  impl_->surface->update();
}

std::size_t SceneView::framesInDrawings() const {
  return impl_->drawings.framesDrawn();
}

std::size_t SceneView::targetsInDrawings() const {
  return impl_->drawings.targetsDrawn();
}

Viewpoint SceneView::viewpoint() const {
  return {impl_->wanted(), impl_->camera_is_mine};
}

void SceneView::setViewpoint(const Viewpoint& viewpoint) {
  impl_->movement.stop();
  const bool was_parallel = impl_->camera.parallel;
  impl_->camera = viewpoint.camera;
  impl_->camera_is_mine = viewpoint.fits;
  if (viewpoint.fits) impl_->fit();
  if (was_parallel != viewpoint.camera.parallel) emit parallelChanged(viewpoint.camera.parallel);
  impl_->surface->update();
}

void SceneView::setRecordedPath(std::vector<PathPoint> path) {
  impl_->path.setPath(std::move(path));
  impl_->surface->update();
}

std::size_t SceneView::pathPartsDrawn() const {
  return impl_->path.parts();
}

std::size_t SceneView::trianglesDrawn() const {
  return impl_->meshes.triangles();
}

std::size_t SceneView::dimplesDrawn() const {
  return impl_->hand.dimplesDrawn();
}

std::size_t SceneView::patchDrawn() const {
  return impl_->meshes.patchCorners();
}

std::pair<double, double> SceneView::sectionRange_mm(int axis) const {
  const double half_mm = workspaceHalf_mm()[axis], now_mm = impl_->layers.section_mm[axis];
  double max = std::max(half_mm, now_mm), min = std::min(-half_mm, now_mm);
  for (const Vec3& p_mm : impl_->meshes.extent_mm()) {
    min = std::min(min, p_mm[axis]);
    max = std::max(max, p_mm[axis]);
  }
  constexpr double kFarthestMesh_mm = 1e8;  // of a mesh in map coordinates; a slider's steps are whole numbers
  return {std::max(min, -kFarthestMesh_mm), std::min(max, kFarthestMesh_mm)};
}

std::size_t SceneView::cutPartsDrawn() const {
  return impl_->layers.section ? static_cast<std::size_t>(impl_->meshes.cap().face()->GetNumberOfPolys()) : 0;
}

void SceneView::setHint(const QString& text) {
  if (text == impl_->hint) return;
  impl_->hint = text;
  impl_->surface->update();
}

void SceneView::setForceLimit(double continuous_N) {
  if (continuous_N == impl_->force_limit_N) return;
  impl_->force_limit_N = continuous_N;
  impl_->hand.setForceLimit(continuous_N);
  impl_->kinematics.setForceLimit(continuous_N);
  impl_->path.setForceLimit(continuous_N);
  if (impl_->shown) impl_->showArm();
  impl_->surface->update();
}

void SceneView::showWords(bool on) {
  impl_->has_words = on;
  impl_->surface->update();
}

void SceneView::setGaugeScale(double scale) {
  impl_->gauge_scale = scale;
  if (impl_->camera_is_mine) impl_->fit();
  impl_->surface->update();
}

double SceneView::gaugeScale() const {
  return impl_->gauge_scale;
}

void SceneView::setHandAvailable(bool available) {
  impl_->hand_available = available;
  impl_->grip.reset();
}

void SceneView::setHandSetpoint(const sim::HandSetpoint& setpoint) {
  impl_->grip.set(setpoint);
}

void SceneView::setKeepsHolding(bool on) {
  impl_->grip.setKeepsHolding(on);
}

void SceneView::setTaken(int from_top_px) {
  if (impl_->taken_px == from_top_px) return;
  impl_->taken_px = from_top_px;
  if (impl_->camera_is_mine) impl_->moveTo(impl_->fitted(impl_->wanted()));
}

QImage SceneView::picture() {
  if (impl_->surface->size() != size()) {  // never shown: not laid out yet
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
