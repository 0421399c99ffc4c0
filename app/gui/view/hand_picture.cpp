#include "app/gui/view/hand_picture.h"

#include <vtkProperty.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "core/base/units.h"

namespace underact::gui {
namespace {

// Of an arm of the Omni's size.
constexpr double kTarget_mm = 4.6;
constexpr double kShaft_mm = 1.1, kHead_mm = 3.2, kHeadLength_mm = 9.0, kBar_mm = 6.5, kBarThick_mm = 1.1;
constexpr double kMinForce_N = 0.005;  // what the gauge rounds to zero
constexpr double kRing_px = 17.0;

/// Little shading: a colour with a meaning must look the same from every side.
void showMeaning(vtkActor& actor) {
  actor.GetProperty()->SetAmbient(0.8);
  actor.GetProperty()->SetDiffuse(0.22);
}

/// The size of a target's marker, relative to that of one far away.
double markerShare(double away_mm) {
  constexpr double kNear_mm = 6.0, kMin = 0.55;
  return std::clamp(away_mm / kNear_mm, kMin, 1.0);
}

vtkSmartPointer<vtkPolyData> headSurface() {
  const std::array<Ring, 3> profile{Ring{0, 0}, Ring{1, 0}, Ring{0, 1}};
  return turned(profile, 28);
}

}  // namespace

HandPicture::HandPicture()
    : shaft_(makeActor(unitTube(20, true), PieceKind::Solid)),
      head_(makeActor(headSurface(), PieceKind::Solid)),
      bar_(makeActor(unitTube(28, true), PieceKind::Solid)),
      outline_actor_(makeActor(outlines_.data(), PieceKind::Line)),
      error_actor_(makeActor(errors_.data(), PieceKind::Line)),
      through_actor_(makeActor(through_.data(), PieceKind::Mark)),
      mark_actor_(makeActor(mark_.data(), PieceKind::Mark)) {
  for (vtkActor* actor : {shaft_.Get(), head_.Get(), bar_.Get()}) {
    actor->SetVisibility(false);
    showMeaning(*actor);
  }
}

std::vector<vtkActor*> HandPicture::solids() const {
  std::vector<vtkActor*> solids = arm_.solids();
  solids.insert(solids.end(), {shaft_.Get(), head_.Get(), bar_.Get()});
  return solids;
}

void HandPicture::setScene(const scene::Description& scene) {
  const std::size_t count = scene.constraints.size();
  dimple_.setScene(scene);
  targets_.clear();
  for (std::size_t index = 0; index < count; ++index) {
    targets_.push_back(makeActor(unitCube(), PieceKind::Solid));
    targets_.back()->SetVisibility(false);
    showMeaning(*targets_.back());
    setColour(*targets_.back(), theme_.target);
  }
  held_mm_.clear();
}

void HandPicture::setTheme(const Theme& theme) {
  theme_ = theme;
  arm_.setTheme(theme);
  dimple_.setTheme(theme);
  for (const auto& target : targets_) setColour(*target, theme.target);
  placeForce();
}

void HandPicture::setArm(const arm::Model& model) {
  arm_.setArm(model);
  size_ = arm_.stand().size;
}

void HandPicture::setLineWidth(double scale) {
  arm_.setLineWidth(scale);
  dimple_.setLineWidth(scale);
  outline_actor_->GetProperty()->SetLineWidth(static_cast<float>(1.25 * scale));
  error_actor_->GetProperty()->SetLineWidth(static_cast<float>(1.5 * scale));
  through_actor_->GetProperty()->SetLineWidth(static_cast<float>(1.5 * scale));
  mark_actor_->GetProperty()->SetLineWidth(static_cast<float>(3.0 * scale));
}

void HandPicture::show(bool arm, bool target, bool force) {
  arm_.show(arm, true);
  dimple_.show(force);
  show_target_ = target;
  show_force_ = force;
  placeForce();
  placeTargets();
}

void HandPicture::present(const servo::Snapshot& snapshot) {
  const tick::TickReport& report = snapshot.report;
  arm_.present(report.sample.q_rad);  // joints that are not finite: the last pose stays
  faulted_ = report.fault.kind != FaultKind::None || snapshot.mode == servo::Mode::Faulted;
  const Vec3& f_T_W = report.force.f_T_W();
  force_N_ = f_T_W.allFinite() ? f_T_W.norm() : 0.0;
  limited_ = report.cut_N > 0.0 && force_N_ > kMinForce_N;  // while the force is off, no limit is felt
  const Vec3 tip_mm = kMillimetrePerMetre * X_WT().translation();
  arrow_ = force_N_ > kMinForce_N && !faulted_ && force_limit_N_ > 0.0;
  if (arrow_) force_end_mm_ = tip_mm + size_ * kArrow_mm / force_limit_N_ * f_T_W;
  held_mm_.clear();
  for (const tick::ConstraintReport& held : report.held) {
    if (!held.acts || held.status != target::Status::Unique || !held.p_WP.allFinite()) continue;
    held_mm_.push_back(kMillimetrePerMetre * held.p_WP);
  }
  dimple_.present(report, X_WT().translation(), arrow_ ? force_N_ / force_limit_N_ : 0.0, size_);
  placeForce();
  placeTargets();
}

void HandPicture::placeForce() {
  const bool visible = known() && arrow_ && show_force_;
  shaft_->SetVisibility(visible);
  head_->SetVisibility(visible);
  bar_->SetVisibility(visible && limited_);
  if (!visible) return;
  const QColor colour = limited_ ? theme_.force_limited : theme_.force;
  for (vtkActor* actor : {shaft_.Get(), head_.Get(), bar_.Get()}) setColour(*actor, colour);
  const Vec3 tip_mm = kMillimetrePerMetre * X_WT().translation();
  const Vec3 travel_mm = force_end_mm_ - tip_mm, direction = travel_mm.normalized();
  const double head_length_mm = std::min(size_ * kHeadLength_mm, 0.6 * travel_mm.norm());
  head_mm_ = force_end_mm_ - head_length_mm * direction;
  place(*shaft_, along(tip_mm, head_mm_, size_ * kShaft_mm));
  place(*head_, along(head_mm_, force_end_mm_, kHead_mm * head_length_mm / kHeadLength_mm));
}

void HandPicture::placeTargets() {
  errors_.clear();
  const Vec3 tip_mm = kMillimetrePerMetre * X_WT().translation();
  for (std::size_t index = 0; index < targets_.size(); ++index) {
    const bool visible = known() && show_target_ && index < held_mm_.size();
    targets_[index]->SetVisibility(visible);
    if (!visible) continue;
    // A marker over the tip would hide where it touches: the nearer, the smaller.
    const double away_mm = (held_mm_[index] - tip_mm).norm();
    place(*targets_[index], at(held_mm_[index], size_ * markerShare(away_mm / size_) * kTarget_mm));
    errors_.segment(tip_mm, held_mm_[index], theme_.target);
  }
  errors_.done();
}

void HandPicture::update(const OrbitCamera& camera, const QSizeF& size) {
  arm_.update(camera);
  outlines_.clear();
  through_.clear();
  mark_.clear();
  const Vec3 eye_mm = camera.eye_mm(), tip_mm = kMillimetrePerMetre * X_WT().translation();
  if (known()) {
    if (shaft_->GetVisibility() != 0) {
      const QColor colour = limited_ ? theme_.force_limited : theme_.force;
      const double head_radius_mm = kHead_mm * (force_end_mm_ - head_mm_).norm() / kHeadLength_mm;
      through_.segment(tip_mm, force_end_mm_, colour);
      outlines_.sides(eye_mm, tip_mm, head_mm_, size_ * kShaft_mm, size_ * kShaft_mm, colour);
      outlines_.sides(eye_mm, head_mm_, force_end_mm_, head_radius_mm, 0.0, colour);
      // The bar is perpendicular to the arrow and to the line of sight, so that it is visible from every direction.
      Vec3 across = (force_end_mm_ - tip_mm).cross(eye_mm - force_end_mm_);
      across = across.norm() > 1e-6 ? Vec3(across.normalized()) : camera.right_W();
      const Vec3 half_mm = size_ * kBar_mm * across;
      place(*bar_, along(force_end_mm_ - half_mm, force_end_mm_ + half_mm, size_ * kBarThick_mm));
    }
    if (faulted_) {
      const double radius_mm = kRing_px * pixelLength_mm(size, project(camera, size, tip_mm).depth_mm);
      const Vec3 right_W = camera.right_W(), up_W = camera.up_W();
      mark_.circle(tip_mm, right_W, up_W, radius_mm, theme_.force_limited);
      const double arm_mm = 0.7 * radius_mm;
      mark_.segment(tip_mm - arm_mm * (right_W + up_W), tip_mm + arm_mm * (right_W + up_W), theme_.force_limited);
      mark_.segment(tip_mm - arm_mm * (right_W - up_W), tip_mm + arm_mm * (right_W - up_W), theme_.force_limited);
    }
  }
  for (std::size_t index = 0; index < targets_.size(); ++index) {
    if (targets_[index]->GetVisibility() == 0) continue;
    // A square that faces the eye, and the error line: seen through whatever hides the marker.
    through_.segment(tip_mm, held_mm_[index], theme_.target);
    const double away_mm = (held_mm_[index] - tip_mm).norm();
    const double half_mm = 0.5 * size_ * markerShare(away_mm / size_) * kTarget_mm;
    const Vec3 right = half_mm * camera.right_W(), up = half_mm * camera.up_W();
    const std::array<Vec3, 4> corners{held_mm_[index] - right - up, held_mm_[index] + right - up,
                                      held_mm_[index] + right + up, held_mm_[index] - right + up};
    through_.chain(corners, theme_.target, true);
  }
  outlines_.done();
  through_.done();
  mark_.done();
  mark_actor_->SetVisibility(known() && faulted_);
}

}  // namespace underact::gui
