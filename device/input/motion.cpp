#include "device/input/motion.h"

#include <algorithm>
#include <cmath>

namespace underact::device::input {
namespace {

double axisAt(const Readings& readings, int axis) {
  if (axis < 0 || axis >= std::min(readings.axes, kMaxAxes)) return 0.0;
  const double value = readings.axis[static_cast<std::size_t>(axis)];
  return std::isfinite(value) ? std::clamp(value, -1.0, 1.0) : 0.0;
}

/// Of a trigger, 0 to 1; a missing one is not pressed.
double pulled(const Readings& readings, int axis) {
  if (axis < 0 || axis >= std::min(readings.axes, kMaxAxes)) return 0.0;
  if (!std::isfinite(readings.axis[static_cast<std::size_t>(axis)])) return 0.0;
  return 0.5 * (axisAt(readings, axis) + 1.0);
}

bool isPressed(const Readings& readings, int button) {
  return button < readings.buttons && readings.isPressed(button);
}

}  // namespace

double deflection(const Source& source, const Readings& readings) {
  switch (source.kind) {
    case SourceKind::None:
      return 0.0;
    case SourceKind::Axis:
      return axisAt(readings, source.plus);
    case SourceKind::Buttons:
      return (isPressed(readings, source.plus) ? 1.0 : 0.0) - (isPressed(readings, source.minus) ? 1.0 : 0.0);
    case SourceKind::Triggers:
      return pulled(readings, source.plus) - pulled(readings, source.minus);
  }
  return 0.0;
}

double shaped(double deflection, double dead_zone, double exponent) {
  const double zone = std::clamp(dead_zone, 0.0, kFurthestDeadZone);
  const double beyond = (std::min(std::abs(deflection), 1.0) - zone) / (1.0 - zone);
  if (!(beyond > 0.0)) return 0.0;  // NaN, too
  return std::copysign(std::pow(beyond, std::clamp(exponent, 1.0, kFinest)), deflection);
}

double share(const AxisMap& map, const Readings& readings) {
  const double part = shaped(deflection(map.source, readings), map.dead_zone, map.exponent);
  return map.inverted ? -part : part;
}

ReadyAxes updatedReadyAxes(const ReadyAxes& awake, const Map& map, const Readings& readings) {
  ReadyAxes now = awake;
  for (std::size_t part = 0; part < kMotionAxes; ++part) {
    if (share(map.motions[part], readings) == 0.0) now.motions[part] = true;
  }
  return now;
}

Motion motionOf(const Map& map, const Readings& readings, const ReadyAxes& awake) {
  Motion motion;
  for (std::size_t part = 0; part < kMotionAxes; ++part) {
    if (!awake.motions[part]) continue;
    const double speed = map.motions[part].top * share(map.motions[part], readings);
    const auto axis = static_cast<Eigen::Index>(part % kMoves);
    (part < kMoves ? motion.v_WT : motion.w_WT_W)[axis] = speed;
  }
  const auto held = [&](ButtonRole press) { return isPressed(readings, map.presses[static_cast<std::size_t>(press)]); };
  motion.stylus_buttons = (held(ButtonRole::Stylus1) ? 1U : 0U) | (held(ButtonRole::Stylus2) ? 2U : 0U);
  motion.stop = held(ButtonRole::Stop);
  return motion;
}

Motion combined(const Motion& one, const Motion& other) {
  return {one.v_WT + other.v_WT, one.w_WT_W + other.w_WT_W, one.stylus_buttons | other.stylus_buttons,
          one.stop || other.stop};
}

sim::HandSetpoint movedSetpoint(const sim::HandSetpoint& setpoint, const Motion& motion, double dt_s,
                                const Pose& X_WT) {
  sim::HandSetpoint next = setpoint;
  next.holds = true;
  if (!(dt_s > 0.0) || !motion.v_WT.allFinite() || !motion.w_WT_W.allFinite() || !X_WT.matrix().allFinite())
    return next;
  const double step_s = std::min(dt_s, kLongestStep_s);
  const Vec3 p_WT = X_WT.translation();
  if (!motion.v_WT.isZero(0.0)) {
    const double max_m = std::max(kLeash_m, (setpoint.p_WT - p_WT).norm());
    const Vec3 ahead_W = setpoint.p_WT + step_s * motion.v_WT - p_WT;
    next.p_WT = p_WT + ahead_W * std::min(1.0, max_m / std::max(ahead_W.norm(), max_m));
    next.p_WT *= std::min(1.0, kReach_m / std::max(next.p_WT.norm(), kReach_m));
  }
  const double turn_rad = step_s * motion.w_WT_W.norm();
  if (turn_rad > 0.0) {
    const Mat3 R_WT = setpoint.turns ? setpoint.R_WT : Mat3(X_WT.linear());
    const Mat3 turned = Eigen::AngleAxisd(turn_rad, motion.w_WT_W.normalized()) * R_WT;
    next.R_WT = Eigen::Quaterniond(turned).normalized().toRotationMatrix();  // many small rotations stay a rotation
    next.turns = true;
  }
  return next;
}

}  // namespace underact::device::input
