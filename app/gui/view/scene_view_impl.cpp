#include "app/gui/view/scene_view_impl.h"

#include <vtkCamera.h>
#include <vtkLight.h>
#include <vtkNew.h>
#include <vtkRenderer.h>

#include <QPainter>
#include <algorithm>

#include "app/gui/kit/words.h"
#include "core/base/units.h"

namespace underact::gui {
namespace {

constexpr int kPoll_ms = 200, kGhost_ms = 800;
const QMarginsF kRoom_px(52.0, 60.0, 52.0, 44.0);  // the hint is at the top

/// From the front, a little from the right and above: so that the sphere, the stylus and the arm behind it do not
/// overlap.
OrbitCamera firstLook() {
  OrbitCamera camera;
  camera.azimuth_rad = 32.0 * kRadPerDegree;
  camera.elevation_rad = 20.0 * kRadPerDegree;
  return camera;
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
  movement.setDuration(kPoll_ms);
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
    renderer.AddActor(meshes.face());
    for (const auto& target : hand.targets()) renderer.AddActor(target);
    for (const auto& lines : {workspace.lines(), constraint.lines(), influence.lines(), robots.lines(), path.lines(),
                              desk.lines(), hand.lines(), kinematics.lines()}) {
      for (vtkActor* actor : lines) renderer.AddActor(actor);
    }
    for (vtkActor* actor : meshes.actors()) renderer.AddActor(actor);
    for (const auto& tint : constraint.tints()) renderer.AddActor(tint);
    for (vtkActor* actor : kinematics.marks()) renderer.AddActor(actor);
    renderer.AddActor(influence.rings());
    renderer.AddActor(hand.mark());
    renderer.AddActor(drawings.mark());
    if (second) renderer.AddViewProp(second->prop());
  }
  constraint.setLineWidth(scale);
  workspace.setLineWidth(scale);
  hand.setLineWidth(scale);
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
  kinematics.update(camera);
  influence.update(camera, size());
  robots.update(camera);
  meshes.update(camera.eye_mm());
  if (second) second->update(camera, size());
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
  const Vec3 half_mm = workspaceHalf_mm();
  for (int corner = 0; corner < 8; ++corner) {
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

OrbitCamera SceneView::Impl::wanted() const {
  return movement.state() == QAbstractAnimation::Running ? to : camera;
}

/// The picture rotates when the desk, or whether it is followed, has changed.
void SceneView::Impl::turnToDesk() {
  OrbitCamera turned = wanted();
  const Mat3 R_WD = layers.from_desk ? desk.R_WD() : Mat3(Mat3::Identity());
  if (turned.R_WD == R_WD) return;
  turned.R_WD = R_WD;
  moveTo(camera_is_mine ? fitted(turned) : turned);
}

void SceneView::Impl::fit() {
  OrbitCamera& ends_as = movement.state() == QAbstractAnimation::Running ? to : camera;
  ends_as = fitted(ends_as);
}

OrbitCamera SceneView::Impl::fitted(const OrbitCamera& looking) const {
  return gui::fitted(looking, size(), extent(), kRoom_px);
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

}  // namespace underact::gui
