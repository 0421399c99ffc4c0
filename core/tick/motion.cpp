#include "core/tick/motion.h"

#include "core/arm/forward.h"
#include "core/arm/general_arm.h"
#include "core/arm/jacobian.h"
#include "core/base/units.h"

namespace underact::tick {
namespace {

constexpr double kSlide_rad_per_m = 10.0;  // a slide's last 5 mm count as a turn's last 3 degrees

}  // namespace

double secondsSince(const TickState& state, std::int64_t time_ns) noexcept {
  if (!state.has_time) return 0.0;
  const std::uint64_t passed_ns = static_cast<std::uint64_t>(time_ns) - static_cast<std::uint64_t>(state.time_ns);
  return kSecondPerNanosecond * static_cast<double>(static_cast<std::int64_t>(passed_ns));
}

GateTime gateTimeOf(const TickInput& input, const TickState& before, double by_arm_s, double law_dt_s) noexcept {
  if (!(input.period_s > 0.0)) return {law_dt_s, 0.0, law_dt_s};  // as in version 0.1.0: the sample's clock
  if (!before.has_time) return {};
  const double since_s = (before.gate.missed + 1) * input.period_s + input.waited_s;
  return {input.period_s, input.waited_s, safety::travelTime_s(by_arm_s, since_s)};
}

void watchJoints(const arm::JointLimits& limits, const arm::JointAngles& q_rad, const Mat3& J_p,
                 safety::Motion& motion) noexcept {
  motion.count = 3;
  for (std::size_t joint = 0; joint < 3; ++joint) {
    safety::DrivenJoint& driven = motion.joints[joint];
    driven.J_v = J_p.col(static_cast<Eigen::Index>(joint));
    driven.room_below_rad = q_rad[joint] - limits.min_rad[joint];
    driven.room_above_rad = limits.max_rad[joint] - q_rad[joint];
  }
}

namespace {

void computeGeneral(const TickProgram& program, const arm::GeneralArm& arm, const arm::JointAngles& q_rad,
                    TickReport& report, safety::Motion& motion) noexcept UNDERACT_REAL_TIME {
  const chain::Kinematics at = chain::kinematics(arm.chain, q_rad);
  report.p_WT = at.X_WT.translation();
  if (program.needs.orientation) {
    report.R_WT = at.X_WT.linear();
    report.stylus_W = at.X_WT.linear().col(2);
  }
  motion.count = program.watched.count;
  motion.turns = program.needs.moment;
  motion.renders_all = false;
  motion.renders = arm::renderable(arm, at.J);
  if (motion.turns) motion.renders_wrench = arm::renderableWrench(at.J, safety::kMomentArm_m);
  for (std::size_t i = 0; i < motion.count; ++i) {
    const std::size_t joint = program.watched.joint[i];
    const auto column = at.J.col(static_cast<Eigen::Index>(joint));
    const double scale = arm.chain.joints[joint].type == chain::JointType::Prismatic ? kSlide_rad_per_m : 1.0;
    motion.joints[i] = {column.head<3>(), column.tail<3>(),
                        scale * (q_rad[joint] - program.joint_limits.min_rad[joint]),
                        scale * (program.joint_limits.max_rad[joint] - q_rad[joint])};
  }
}

}  // namespace

void computeKinematics(const TickProgram& program, const arm::JointAngles& q_rad, TickReport& report,
                       safety::Motion& motion) noexcept {
  if (program.geometry.general != nullptr) {
    computeGeneral(program, *program.geometry.general, q_rad, report, motion);
    return;
  }
  Mat3 J_p = Mat3::Zero();
  if (program.needs.orientation) {
    const Pose X_WT = arm::tipPose(program.geometry, q_rad);
    report.p_WT = X_WT.translation();
    report.R_WT = X_WT.linear();
    report.stylus_W = X_WT.linear().col(2);
    if (program.needs.motors) J_p = arm::positionJacobian(program.geometry, q_rad);
  } else if (program.needs.motors) {
    const arm::Tip tip = arm::tip(program.geometry, q_rad);
    report.p_WT = tip.p_WT;
    J_p = tip.J_p;
  } else {
    report.p_WT = arm::tipPosition(program.geometry, q_rad);
  }
  if (program.needs.motors) watchJoints(program.joint_limits, q_rad, J_p, motion);
}

void computeMotion(const arm::JointAngles& q_rad, const TickState& before, double dt_s, const Vec3& p_WT,
                   safety::Motion& motion) noexcept {
  if (dt_s > 0.0) motion.v_WT = (p_WT - before.p_WT) / dt_s;
  motion.moved = !(dt_s > 0.0) || q_rad != before.q_rad;
}

}  // namespace underact::tick
