#include "app/gui/view/scene_view_impl.h"

#include <vtkCamera.h>
#include <vtkLight.h>
#include <vtkNew.h>
#include <vtkRenderer.h>

#include <QLineF>
#include <QPainter>
#include <algorithm>
#include <cmath>

#include "app/gui/kit/words.h"
#include "core/base/units.h"

namespace underact::gui {
namespace {

constexpr int kPoll_ms = 200, kGhost_ms = 800, kArmsRead_ms = 50;
constexpr double kMaxTaken = 0.36;        // of the height, by a card over the view
constexpr double kThickestPen_m = 0.005;  // from its middle, of the Omni's size

OrbitCamera firstLook() {
  OrbitCamera camera;
  camera.azimuth_rad = kHomeAzimuth_deg * kRadPerDegree;
  camera.elevation_rad = kHomeElevation_deg * kRadPerDegree;
  return camera;
}

}  // namespace

SceneView::Impl::Impl(SceneView* owner) : view(owner), camera(firstLook()) {
  surface =
      new GlSurface([this](QSize pixels) { before(pixels); }, [this](QPainter& painter) { paintWords(painter); }, view);
  surface->renderer().SetAutomaticLightCreation(false);
  for (std::size_t index = 0; index < kLights.size(); ++index) {  // they follow the camera
    const vtkNew<vtkLight> light;
    light->SetLightTypeToCameraLight();
    light->SetPosition(kLights[index].x(), kLights[index].y(), kLights[index].z());
    light->SetFocalPoint(0.0, 0.0, 0.0);
    light->SetIntensity(kLightStrengths[index]);
    surface->renderer().AddLight(light);
  }
  movement.setDuration(kPoll_ms);
  movement.setStartValue(0.0);
  movement.setEndValue(1.0);
  movement.setEasingCurve(QEasingCurve::InOutCubic);
  connect(&movement, &QVariantAnimation::valueChanged, view, [this](const QVariant& share) {
    camera = between(from, to, share.toDouble());
    surface->update();
  });
  arms_read.setInterval(kArmsRead_ms);
  connect(&arms_read, &QTimer::timeout, view, [this] { takeArms(); });
  ghost_trajectory.setDuration(kGhost_ms);
  ghost_trajectory.setStartValue(0.0);
  ghost_trajectory.setEndValue(1.0);
  ghost_trajectory.setEasingCurve(QEasingCurve::InOutCubic);
  connect(&ghost_trajectory, &QVariantAnimation::valueChanged, view, [this](const QVariant& share) {
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
    for (vtkActor* actor : shadow.actors()) renderer.AddActor(actor);
    for (vtkActor* actor : hand.solids()) renderer.AddActor(actor);
    renderer.AddActor(meshes.face());
    for (const auto& target : hand.targets()) renderer.AddActor(target);
    for (const auto& lines : {workspace.lines(), constraint.lines(), influence.lines(), robots.lines(), path.lines(),
                              desk.lines(), hand.lines(), kinematics.lines()}) {
      for (vtkActor* actor : lines) renderer.AddActor(actor);
    }
    for (vtkActor* actor : meshes.actors()) renderer.AddActor(actor);
    for (const auto& tint : constraint.tints()) renderer.AddActor(tint);
    for (const auto& surfaces : {robots.surfaces(), kinematics.surfaces()}) {
      for (vtkActor* actor : surfaces) renderer.AddActor(actor);
    }
    for (vtkActor* actor : hand.dimples()) renderer.AddActor(actor);
    for (vtkActor* actor : kinematics.marks()) renderer.AddActor(actor);
    renderer.AddActor(workspace.mark());
    renderer.AddActor(influence.rings());
    for (vtkActor* actor : hand.marks()) renderer.AddActor(actor);
    renderer.AddActor(drawings.mark());
    renderer.AddActor(drawings.lit());
    if (second) renderer.AddViewProp(second->prop());
  }
  constraint.setLineWidth(scale);
  workspace.setLineWidth(scale);
  hand.setLineWidth(scale);
  shadow.setLineWidth(scale);
  kinematics.setLineWidth(scale);
  influence.setLineWidth(scale);
  robots.setLineWidth(scale);
  path.setLineWidth(scale);
  desk.setLineWidth(scale);
  drawings.setLineWidth(scale);
  meshes.setLineWidth(scale);
  if (second) second->setLineWidth(scale);
  constraint.update(camera.eye_mm());
  workspace.update(camera);
  hand.update(camera, size());
  shadow.update(camera);
  kinematics.update(camera);
  influence.update(camera, size());
  robots.update(camera);
  meshes.update(camera.eye_mm());
  if (second) second->update(camera, size());
  vtkCamera* eye = surface->renderer().GetActiveCamera();
  const double around_mm = camera.focus_mm.norm() + 600.0 * std::max(1.0, hand.arm().stand().size);
  // In parallel projection the eye's distance changes nothing but the range of depths.
  const double away_mm = camera.distance_mm + (camera.parallel ? around_mm : 0.0), far_mm = away_mm + around_mm;
  const Vec3 eye_mm = camera.focus_mm + away_mm * camera.back_W(), up_W = camera.up_W();
  eye->SetPosition(eye_mm.data());
  eye->SetFocalPoint(camera.focus_mm.data());
  eye->SetViewUp(up_W.data());
  eye->SetViewAngle(OrbitCamera::kViewAngle_rad / kRadPerDegree);
  eye->SetParallelProjection(camera.parallel);
  eye->SetParallelScale(camera.distance_mm * std::tan(0.5 * OrbitCamera::kViewAngle_rad));
  eye->SetClippingRange(std::max(0.01 * far_mm, away_mm - around_mm), far_mm);
}

const Problems& SceneView::armProblems() const {
  return impl_->hand.arm().problems();
}

void SceneView::Impl::awaitArms() {
  if (hand.isReadingArm() || (second && second->isReadingArm())) arms_read.start();
  emit view->armRead(hand.arm().problems());
}

void SceneView::Impl::takeArms() {
  const bool read = hand.takeArmRead(), also = second && second->takeArmRead();
  if (!hand.isReadingArm() && !(second && second->isReadingArm())) arms_read.stop();
  if (!read && !also) return;
  if (shown) showArm();
  surface->update();
  if (read) emit view->armRead(hand.arm().problems());
}

void SceneView::Impl::showArm() {
  hand.present(*shown);
  shadow.present(hand.arm().shadowRods(), hand.arm().stand());
  kinematics.present(shown->report.sample.q_rad);
  influence.present(shown->report);
  robots.present(*shown);
  meshes.present(shown->report);
  layers.section_mm = meshes.section_mm();
}

void SceneView::Impl::paintWords(QPainter& painter) {
  if (!has_words) return;
  WordsState state;
  state.theme = theme;
  state.font = view->font();
  state.size = size();
  state.scale = view->devicePixelRatioF();
  state.camera = camera;
  state.hint = hint;
  if (hand.known() && shown && shown->mode == servo::Mode::Faulted) {
    state.fault = sentenceText(describe(shown->report.fault));
  }
  state.force_N = hand.force_N();
  state.force_limit_N = force_limit_N;
  state.gauge_scale = gauge_scale;
  state.limited = hand.limited();
  state.focus = view->hasFocus();
  std::vector<Label> labels = workspace.labels();
  labels.insert(labels.end(), kinematics.labels().begin(), kinematics.labels().end());
  labels.insert(labels.end(), influence.labels().begin(), influence.labels().end());
  state.has_influence = influence.isSeen();
  labels.insert(labels.end(), robots.labels().begin(), robots.labels().end());
  labels.insert(labels.end(), desk.labels().begin(), desk.labels().end());
  labels.insert(labels.end(), drawings.labels().begin(), drawings.labels().end());
  if (second) {
    const std::vector<Label> of_second = second->labels();
    labels.insert(labels.end(), of_second.begin(), of_second.end());
  }
  words.paint(painter, state, labels);
}

std::vector<Vec3> SceneView::Impl::extent() const {
  std::vector<Vec3> points = constraint.extent_mm();
  const Vec3 half_mm = workspace.half_mm();
  for (int corner = 0; layers.workspace && corner < 8; ++corner) {
    points.push_back(
        half_mm.cwiseProduct(Vec3((corner & 1) != 0 ? 1 : -1, (corner & 2) != 0 ? 1 : -1, (corner & 4) != 0 ? 1 : -1)));
  }
  points.insert(points.end(), meshes.extent_mm().begin(), meshes.extent_mm().end());
  const std::vector<Vec3> of_robots = robots.extent_mm();
  points.insert(points.end(), of_robots.begin(), of_robots.end());
  points.insert(points.end(), desk.extent_mm().begin(), desk.extent_mm().end());
  if (second) {
    const std::vector<Vec3> of_second = second->extent_mm();
    points.insert(points.end(), of_second.begin(), of_second.end());
  }
  if (hand.known()) {
    const std::vector<Vec3> of_arm = hand.arm().extent_mm();
    points.insert(points.end(), of_arm.begin(), of_arm.end());
    const std::vector<Vec3> ghosts = kinematics.extent_mm();
    points.insert(points.end(), ghosts.begin(), ghosts.end());
  }
  return points;
}

std::vector<Vec3> SceneView::Impl::selected() const {
  if (const std::vector<Vec3> chosen = kinematics.chosenExtent_mm(); !chosen.empty()) return chosen;
  std::vector<Vec3> points = constraint.extent_mm();
  points.insert(points.end(), meshes.extent_mm().begin(), meshes.extent_mm().end());
  const std::vector<Vec3> of_robots = robots.extent_mm();
  points.insert(points.end(), of_robots.begin(), of_robots.end());
  if (hand.known()) points.push_back(kMillimetrePerMetre * hand.X_WT().translation());
  return points;
}

OrbitCamera SceneView::Impl::wanted() const {
  return movement.state() == QAbstractAnimation::Running ? to : camera;
}

/// A card over the view has its room as long as the arm stays larger than it.
QMarginsF SceneView::Impl::room_px() const {
  QMarginsF room = kRoom_px;
  room.setBottom(std::max(1.0, gauge_scale) * room.bottom());  // the gauge stands below the arm
  if (taken_px > room.top() && taken_px < kMaxTaken * size().height()) room.setTop(taken_px);
  return room;
}

/// The picture rotates when the desk, or whether it is followed, has changed.
void SceneView::Impl::turnToDesk() {
  OrbitCamera turned = wanted();
  const Mat3 R_WD = layers.from_desk && desk.isKnown() ? desk.R_WD() : hand.arm().stand().R_WD;
  if (turned.R_WD == R_WD) return;
  turned.R_WD = R_WD;
  moveTo(camera_is_mine ? fitted(turned) : turned);
}

void SceneView::Impl::fit() {
  OrbitCamera& ends_as = movement.state() == QAbstractAnimation::Running ? to : camera;
  ends_as = fitted(ends_as);
  surface->update();  // a widget of OpenGL that is resized has been drawn by now
}

OrbitCamera SceneView::Impl::fitted(const OrbitCamera& looking) const {
  return gui::fitted(looking, size(), extent(), room_px());
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

QRectF SceneView::stylusOnScreen() const {
  if (!impl_->hand.known()) return {};
  const auto [tip_W, end_W] = impl_->hand.arm().stylus_W();
  const QPointF tip = screenOf(tip_W), end = screenOf(end_W);
  const double thick_m = kThickestPen_m * impl_->hand.arm().stand().size;
  double around = 1.0;
  for (int axis = 0; axis < 3; ++axis)
    around = std::max(around, QLineF(end, screenOf(end_W + thick_m * Vec3::Unit(axis))).length());
  return QRectF(tip, end).normalized().adjusted(-around, -around, around, around);
}

}  // namespace underact::gui
