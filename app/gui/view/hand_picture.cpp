#include "app/gui/view/hand_picture.h"

#include <vtkProperty.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "core/base/units.h"

namespace underact::gui {
namespace {

constexpr double kTip_mm = HandPicture::kTip_mm, kNeck_mm = HandPicture::kNeck_mm, kBody_mm = HandPicture::kBody_mm,
                 kTaper_mm = HandPicture::kTaper_mm, kEnd_mm = HandPicture::kEnd_mm;
constexpr double kLink_mm = 1.2, kJoint_mm = 2.6;
constexpr double kTarget_mm = 4.6;
constexpr double kShaft_mm = 1.1, kHead_mm = 3.2, kHeadLength_mm = 9.0, kBar_mm = 6.5, kBarThick_mm = 1.1;
constexpr double kLeastForce_N = 0.005;  // what the gauge rounds to zero
constexpr double kRing_px = 17.0;

vtkSmartPointer<vtkPolyData> stylusSurface() {
  std::vector<Ring> profile;
  const double meet = std::acos(kNeck_mm / kTip_mm);
  for (int step = 0; step <= 10; ++step) {
    const double angle = -0.5 * kPi + step * (meet + 0.5 * kPi) / 10;
    profile.push_back({step == 0 ? 0.0 : kTip_mm * std::cos(angle), kTip_mm * std::sin(angle)});
  }
  profile.push_back({kBody_mm, kTaper_mm});
  profile.push_back({kBody_mm, kEnd_mm - kBody_mm});
  for (int step = 1; step <= 8; ++step) {
    const double angle = 0.5 * kPi * step / 8;
    profile.push_back({step == 8 ? 0.0 : kBody_mm * std::cos(angle), kEnd_mm - kBody_mm + kBody_mm * std::sin(angle)});
  }
  return turned(profile, 28);
}

/// Little shading: a colour with a meaning must look the same from every side.
void showMeaning(vtkActor& actor) {
  actor.GetProperty()->SetAmbient(0.8);
  actor.GetProperty()->SetDiffuse(0.22);
}

vtkSmartPointer<vtkPolyData> headSurface() {
  const std::array<Ring, 3> profile{Ring{0, 0}, Ring{1, 0}, Ring{0, 1}};
  return turned(profile, 28);
}

}  // namespace

HandPicture::HandPicture()
    : upper_(makeActor(unitTube(20, true), Kind::Solid)),
      fore_(makeActor(unitTube(20, true), Kind::Solid)),
      shoulder_(makeActor(unitSphere(24, 12), Kind::Solid)),
      elbow_(makeActor(unitSphere(24, 12), Kind::Solid)),
      stylus_(makeActor(stylusSurface(), Kind::Solid)),
      shaft_(makeActor(unitTube(20, true), Kind::Solid)),
      head_(makeActor(headSurface(), Kind::Solid)),
      bar_(makeActor(unitTube(28, true), Kind::Solid)),
      outline_actor_(makeActor(outlines_.data(), Kind::Line)),
      error_actor_(makeActor(errors_.data(), Kind::Line)),
      mark_actor_(makeActor(mark_.data(), Kind::Mark)) {
  for (vtkActor* actor : solids()) actor->SetVisibility(false);
  for (vtkActor* actor : {shaft_.Get(), head_.Get(), bar_.Get()}) showMeaning(*actor);
}

std::vector<vtkActor*> HandPicture::solids() const {
  return {upper_, fore_, shoulder_, elbow_, stylus_, shaft_, head_, bar_};
}

void HandPicture::setConstraints(std::size_t count) {
  targets_.clear();
  for (std::size_t index = 0; index < count; ++index) {
    targets_.push_back(makeActor(unitCube(), Kind::Solid));
    targets_.back()->SetVisibility(false);
    showMeaning(*targets_.back());
    setColour(*targets_.back(), theme_.target);
  }
  held_mm_.clear();
}

void HandPicture::setTheme(const Theme& theme) {
  theme_ = theme;
  for (vtkActor* actor : {upper_.Get(), fore_.Get(), shoulder_.Get(), elbow_.Get()}) {
    setColour(*actor, mixed(theme.background, theme.ink, theme.dark ? 0.55 : 0.6));
  }
  setColour(*stylus_, theme.ink);
  for (const auto& target : targets_) setColour(*target, theme.target);
  placeForce();
}

void HandPicture::setGeometry(const arm::Geometry& geometry) {
  geometry_ = geometry;
}

void HandPicture::setLineWidth(double scale) {
  outline_actor_->GetProperty()->SetLineWidth(static_cast<float>(1.25 * scale));
  error_actor_->GetProperty()->SetLineWidth(static_cast<float>(1.5 * scale));
  mark_actor_->GetProperty()->SetLineWidth(static_cast<float>(3.0 * scale));
}

void HandPicture::show(bool arm, bool target, bool force) {
  show_arm_ = arm;
  show_target_ = target;
  show_force_ = force;
  placeArm();
  placeForce();
  placeTargets();
}

void HandPicture::present(const servo::Snapshot& snapshot) {
  const tick::TickReport& report = snapshot.report;
  const arm::JointAngles& q_rad = report.sample.q_rad;
  if (std::all_of(q_rad.begin(), q_rad.end(), [](double angle) { return std::isfinite(angle); })) {
    X_WT_ = arm::tipPose(geometry_, q_rad);
    skeleton_ = arm::skeleton(geometry_, q_rad);
    known_ = true;
  }
  faulted_ = report.fault.kind != FaultKind::None || snapshot.mode == servo::Mode::Faulted;
  const Vec3& f_T_W = report.force.f_T_W();
  force_N_ = f_T_W.allFinite() ? f_T_W.norm() : 0.0;
  limited_ = report.cut_N > 0.0;
  const Vec3 tip_mm = kMillimetrePerMetre * X_WT_.translation();
  arrow_ = force_N_ > kLeastForce_N && !faulted_ && force_limit_N_ > 0.0;
  if (arrow_) force_end_mm_ = tip_mm + kArrow_mm / force_limit_N_ * f_T_W;
  held_mm_.clear();
  for (const tick::ConstraintReport& held : report.held) {
    if (!held.acts || held.status != target::Status::Unique || !held.p_WP.allFinite()) continue;
    held_mm_.push_back(kMillimetrePerMetre * held.p_WP);
  }
  placeArm();
  placeForce();
  placeTargets();
}

void HandPicture::placeArm() {
  stylus_->SetVisibility(known_);
  for (vtkActor* actor : {upper_.Get(), fore_.Get(), shoulder_.Get(), elbow_.Get()}) {
    actor->SetVisibility(known_ && show_arm_);
  }
  if (!known_) return;
  const Vec3 tip_mm = kMillimetrePerMetre * X_WT_.translation();
  const Vec3 shoulder_mm = kMillimetrePerMetre * skeleton_.p_WShoulder,
             elbow_mm = kMillimetrePerMetre * skeleton_.p_WElbow;
  Eigen::Matrix4d X = X_WT_.matrix();
  X.block<3, 1>(0, 3) = tip_mm;
  place(*stylus_, X);
  place(*upper_, along(shoulder_mm, elbow_mm, kLink_mm));
  place(*fore_, along(elbow_mm, tip_mm, kLink_mm));
  place(*shoulder_, at(shoulder_mm, kJoint_mm));
  place(*elbow_, at(elbow_mm, kJoint_mm));
}

void HandPicture::placeForce() {
  const bool visible = known_ && arrow_ && show_force_;
  shaft_->SetVisibility(visible);
  head_->SetVisibility(visible);
  bar_->SetVisibility(visible && limited_);
  if (!visible) return;
  const QColor colour = limited_ ? theme_.force_limited : theme_.force;
  for (vtkActor* actor : {shaft_.Get(), head_.Get(), bar_.Get()}) setColour(*actor, colour);
  const Vec3 tip_mm = kMillimetrePerMetre * X_WT_.translation();
  const Vec3 way_mm = force_end_mm_ - tip_mm, direction = way_mm.normalized();
  const double head_length_mm = std::min(kHeadLength_mm, 0.6 * way_mm.norm());
  head_mm_ = force_end_mm_ - head_length_mm * direction;
  place(*shaft_, along(tip_mm, head_mm_, kShaft_mm));
  place(*head_, along(head_mm_, force_end_mm_, kHead_mm * head_length_mm / kHeadLength_mm));
}

void HandPicture::placeTargets() {
  errors_.clear();
  const Vec3 tip_mm = kMillimetrePerMetre * X_WT_.translation();
  for (std::size_t index = 0; index < targets_.size(); ++index) {
    const bool visible = known_ && show_target_ && index < held_mm_.size();
    targets_[index]->SetVisibility(visible);
    if (!visible) continue;
    place(*targets_[index], at(held_mm_[index], kTarget_mm));
    errors_.segment(tip_mm, held_mm_[index], theme_.target);
  }
  errors_.done();
}

void HandPicture::update(const OrbitCamera& camera, const QSizeF& size) {
  outlines_.clear();
  mark_.clear();
  const Vec3 eye_mm = camera.eye_mm(), tip_mm = kMillimetrePerMetre * X_WT_.translation();
  if (known_) {
    // Without multisampling the edge of a shaded surface is jagged; a smooth line of its own colour hides that.
    const QColor ink = theme_.dark ? mixed(theme_.ink, theme_.background, 0.2) : theme_.ink;
    const Vec3 z_W = X_WT_.linear().col(2);
    const Vec3 taper_mm = tip_mm + kTaper_mm * z_W, end_mm = tip_mm + (kEnd_mm - kBody_mm) * z_W;
    outlines_.outline(eye_mm, tip_mm, kTip_mm, ink);
    outlines_.sides(eye_mm, tip_mm + kNeck_mm * z_W, taper_mm, kNeck_mm, kBody_mm, ink);
    outlines_.sides(eye_mm, taper_mm, end_mm, kBody_mm, kBody_mm, ink);
    outlines_.outline(eye_mm, end_mm, kBody_mm, ink);
    if (show_arm_) {
      const Vec3 shoulder_mm = kMillimetrePerMetre * skeleton_.p_WShoulder,
                 elbow_mm = kMillimetrePerMetre * skeleton_.p_WElbow;
      const QColor soft = mixed(theme_.background, theme_.ink, theme_.dark ? 0.42 : 0.55);
      outlines_.sides(eye_mm, shoulder_mm, elbow_mm, kLink_mm, kLink_mm, soft);
      outlines_.sides(eye_mm, elbow_mm, tip_mm, kLink_mm, kLink_mm, soft);
      outlines_.outline(eye_mm, shoulder_mm, kJoint_mm, soft);
      outlines_.outline(eye_mm, elbow_mm, kJoint_mm, soft);
    }
    if (shaft_->GetVisibility() != 0) {
      const QColor colour = limited_ ? theme_.force_limited : theme_.force;
      const double head_radius_mm = kHead_mm * (force_end_mm_ - head_mm_).norm() / kHeadLength_mm;
      outlines_.sides(eye_mm, tip_mm, head_mm_, kShaft_mm, kShaft_mm, colour);
      outlines_.sides(eye_mm, head_mm_, force_end_mm_, head_radius_mm, 0.0, colour);
      // The bar is perpendicular to the arrow and to the line of sight, so that it is visible from every direction.
      Vec3 across = (force_end_mm_ - tip_mm).cross(eye_mm - force_end_mm_);
      across = across.norm() > 1e-6 ? Vec3(across.normalized()) : camera.right_W();
      place(*bar_, along(force_end_mm_ - kBar_mm * across, force_end_mm_ + kBar_mm * across, kBarThick_mm));
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
  outlines_.done();
  mark_.done();
  mark_actor_->SetVisibility(known_ && faulted_);
}

}  // namespace underact::gui
