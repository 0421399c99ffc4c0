#include "app/gui/view/hand_grip.h"

#include <algorithm>
#include <array>

#include "core/base/units.h"
#include "device/input/motion.h"

namespace underact::gui {
namespace {

using device::input::kReach_m;
constexpr double kTurnPerPixel_rad = 0.5 * kRadPerDegree;

}  // namespace

Mat3 nearestAxes(const OrbitCamera& camera) {
  const std::array<Vec3, 3> screen{camera.right_W(), camera.up_W(), -camera.back_W()};
  Mat3 axes = Mat3::Zero();
  Mat3 left = Mat3::Zero();
  for (int column = 0; column < 3; ++column) left.col(column) = screen[static_cast<std::size_t>(column)];
  for (int round = 0; round < 3; ++round) {  // the clearest match first
    Eigen::Index row = 0, column = 0;
    left.cwiseAbs().maxCoeff(&row, &column);
    axes(row, column) = left(row, column) < 0.0 ? -1.0 : 1.0;
    left.row(row).setZero();
    left.col(column).setZero();
  }
  return axes;
}

void HandGrip::set(const sim::HandSetpoint& setpoint) {
  setpoint_ = setpoint;
  known_ = true;
}

bool HandGrip::take(const Pose& X_WT) {
  moved_ = false;
  if (known_ && setpoint_.holds) return false;
  if (!known_ || !setpoint_.turns) setpoint_ = {{}, Vec3::Zero(), X_WT.linear(), false, true};
  setpoint_.p_WT = X_WT.translation();
  setpoint_.holds = known_ = true;
  return true;
}

void HandGrip::hold(const Vec3& p_WT) {
  moved_ = true;
  if (setpoint_.holds) return;
  setpoint_.p_WT = p_WT;
  setpoint_.holds = true;
}

void HandGrip::drag(const OrbitCamera& camera, const QSizeF& size, const Vec3& p_WT, const QPointF& offset) {
  const double depth_mm = std::max(project(camera, size, kMillimetrePerMetre * p_WT).depth_mm, 1.0);
  hold(p_WT);
  const double pixel_m = kMetrePerMillimetre * pixelLength_mm(size, depth_mm);
  setpoint_.p_WT += pixel_m * (offset.x() * camera.right_W() - offset.y() * camera.up_W());
  keepInside();
}

void HandGrip::deepen(const OrbitCamera& camera, const Vec3& p_WT, double travel_m) {
  hold(p_WT);
  setpoint_.p_WT -= travel_m * camera.back_W();
  keepInside();
}

void HandGrip::beginTurn(const Mat3& R_WT) {
  if (!setpoint_.turns) setpoint_.R_WT = R_WT;
  if (!moved_ && !keeps_holding_) setpoint_.holds = false;
}

void HandGrip::turn(const OrbitCamera& camera, const Mat3& R_WT, const QPointF& offset) {
  beginTurn(R_WT);
  turnAbout(camera.up_W(), kTurnPerPixel_rad * offset.x());
  turnAbout(camera.right_W(), kTurnPerPixel_rad * offset.y());
}

void HandGrip::step(const OrbitCamera& camera, const Vec3& p_WT, const Vec3& right_up_away, double length_m) {
  hold(p_WT);
  setpoint_.p_WT += length_m * (nearestAxes(camera) * right_up_away);
  keepInside();
}

void HandGrip::turnStep(const OrbitCamera& camera, const Mat3& R_WT, const Vec3& right_up_away, double angle_rad) {
  beginTurn(R_WT);
  const Mat3 axes = nearestAxes(camera);
  turnAbout(axes.col(1), angle_rad * right_up_away.x());
  turnAbout(axes.col(0), -angle_rad * right_up_away.y());
  turnAbout(axes.col(2), angle_rad * right_up_away.z());
}

void HandGrip::turnAbout(const Vec3& axis_W, double angle_rad) {
  const Mat3 turned = Eigen::AngleAxisd(angle_rad, axis_W) * setpoint_.R_WT;
  setpoint_.R_WT = Eigen::Quaterniond(turned).normalized().toRotationMatrix();  // many small rotations stay orthonormal
  setpoint_.turns = true;
}

void HandGrip::keepInside() {
  const double away_m = setpoint_.p_WT.norm();
  if (away_m > kReach_m) setpoint_.p_WT *= kReach_m / away_m;
}

}  // namespace underact::gui
