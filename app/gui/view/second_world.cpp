#include "app/gui/view/second_world.h"

#include <vtkMatrix4x4.h>
#include <vtkNew.h>

#include <QCoreApplication>
#include <algorithm>

#include "app/gui/view/scene_view.h"
#include "core/arm/preset.h"
#include "core/base/units.h"
#include "core/scene/scene_arm.h"

namespace underact::gui {

bool looksAlike(const servo::Snapshot& one, const servo::Snapshot& other) {
  const tick::TickReport &a = one.report, &b = other.report;
  if (one.mode != other.mode || a.fault.kind != b.fault.kind || (a.cut_N > 0.0) != (b.cut_N > 0.0)) return false;
  if (a.sample.q_rad != b.sample.q_rad || a.force.f_T_W() != b.force.f_T_W()) return false;
  return std::equal(a.held.begin(), a.held.end(), b.held.begin(), b.held.end(),
                    [](const tick::ConstraintReport& x, const tick::ConstraintReport& y) {
                      return x.acts == y.acts && x.status == y.status && x.p_WP == y.p_WP &&
                             x.arc.turn_rad == y.arc.turn_rad && x.arc.share == y.arc.share &&
                             x.robot.joints == y.robot.joints && x.robot.theta == y.robot.theta &&
                             x.robot.moment_W == y.robot.moment_W;
                    });
}

SecondWorld::SecondWorld() : assembly_(vtkSmartPointer<vtkAssembly>::New()) {}

void SecondWorld::setScene(const scene::Description& scene) {
  const arm::Preset& preset = scene::armOf(scene);
  hand_.setArm(scene::modelOf(scene));
  hand_.setForceLimit(preset.continuous_force_N);
  hand_.setScene(scene);
  constraint_.setScene(scene);
  robots_.setScene(scene);
  meshes_.setScene(scene);
  shown_.reset();
  assemble();
}

/// Parts of an assembly have their own placement and are moved with it.
void SecondWorld::assemble() {
  assembly_ = vtkSmartPointer<vtkAssembly>::New();
  for (vtkActor* actor : hand_.solids()) assembly_->AddPart(actor);
  for (const auto& target : hand_.targets()) assembly_->AddPart(target);
  for (const auto& lines : {constraint_.lines(), influence_.lines(), robots_.lines(), hand_.lines()}) {
    for (vtkActor* actor : lines) assembly_->AddPart(actor);
  }
  for (vtkActor* actor : meshes_.actors()) assembly_->AddPart(actor);
  for (const auto& tint : constraint_.tints()) assembly_->AddPart(tint);
  for (vtkActor* actor : robots_.surfaces()) assembly_->AddPart(actor);
  for (vtkActor* actor : hand_.dimples()) assembly_->AddPart(actor);
  assembly_->AddPart(influence_.rings());
  for (vtkActor* actor : hand_.marks()) assembly_->AddPart(actor);
  setPlace(X_WS_mm_);
}

void SecondWorld::setPlace(const Pose& X_WS_mm) {
  X_WS_mm_ = X_WS_mm;
  const vtkNew<vtkMatrix4x4> matrix;
  for (int row = 0; row < 4; ++row) {
    for (int column = 0; column < 4; ++column) matrix->SetElement(row, column, X_WS_mm_.matrix()(row, column));
  }
  assembly_->SetUserMatrix(matrix);
}

void SecondWorld::setTheme(const Theme& theme) {
  ink_ = theme.ink;
  constraint_.setTheme(theme);
  hand_.setTheme(theme);
  influence_.setTheme(theme);
  robots_.setTheme(theme);
  meshes_.setTheme(theme);
  assemble();
}

void SecondWorld::setLayers(const Layers& layers) {
  Layers mine = layers;
  mine.section = false;  // the cut is across the first arm's frame
  hand_.show(mine.arm, mine.target, mine.force);
  influence_.show(mine.influence);
  robots_.show(mine.robot);
  meshes_.show(mine);
}

void SecondWorld::setLineWidth(double device_pixels_per_pixel) {
  constraint_.setLineWidth(device_pixels_per_pixel);
  hand_.setLineWidth(device_pixels_per_pixel);
  influence_.setLineWidth(device_pixels_per_pixel);
  robots_.setLineWidth(device_pixels_per_pixel);
  meshes_.setLineWidth(device_pixels_per_pixel);
}

bool SecondWorld::present(const servo::Snapshot& snapshot) {
  if (shown_ && looksAlike(*shown_, snapshot)) return false;
  shown_ = snapshot;
  hand_.present(snapshot);
  influence_.present(snapshot.report);
  robots_.present(snapshot);
  meshes_.present(snapshot.report);
  return true;
}

void SecondWorld::update(OrbitCamera camera, const QSizeF& size) {
  camera.focus_mm = X_WS_mm_.inverse() * camera.focus_mm;  // as seen from its own frame
  camera.R_WD = X_WS_mm_.linear().transpose() * camera.R_WD;
  constraint_.update(camera.eye_mm());
  hand_.update(camera, size);
  influence_.update(camera, size);
  robots_.update(camera);
  meshes_.update(camera.eye_mm());
}

std::vector<Label> SecondWorld::labels() const {
  std::vector<Label> labels{{QCoreApplication::translate("SceneView", "second arm"), Vec3(0.0, 0.0, 0.0), ink_, true}};
  labels.insert(labels.end(), influence_.labels().begin(), influence_.labels().end());
  labels.insert(labels.end(), robots_.labels().begin(), robots_.labels().end());
  labels.front().p_mm.y() = -workspaceHalf_mm().y() - 14.0;
  for (Label& label : labels) label.p_mm = X_WS_mm_ * label.p_mm;
  return labels;
}

std::vector<Vec3> SecondWorld::extent_mm() const {
  std::vector<Vec3> points = constraint_.extent_mm();
  points.insert(points.end(), meshes_.extent_mm().begin(), meshes_.extent_mm().end());
  const std::vector<Vec3> of_robots = robots_.extent_mm();
  points.insert(points.end(), of_robots.begin(), of_robots.end());
  if (hand_.known()) {
    const std::vector<Vec3> of_arm = hand_.arm().extent_mm();
    points.insert(points.end(), of_arm.begin(), of_arm.end());
  }
  for (Vec3& point : points) point = X_WS_mm_ * point;
  return points;
}

}  // namespace underact::gui
