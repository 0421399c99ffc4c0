#include "core/tick/motion.h"

#include "core/arm/jacobian.h"
#include "core/arm/mechanism.h"
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

void watchJoints(const arm::Watched& watched, const arm::JointLimits& limits, const arm::JointAngles& q_rad,
                 const chain::Jacobian& J, safety::Motion& motion) noexcept {
  motion.count = watched.count;
  for (std::size_t i = 0; i < watched.count; ++i) {
    const std::size_t joint = watched.joint[i];
    const auto column = J.col(static_cast<Eigen::Index>(joint));
    const double scale = watched.slides[i] ? kSlide_rad_per_m : 1.0;
    motion.joints[i] = {column.head<3>(), column.tail<3>(), scale * (q_rad[joint] - limits.min_rad[joint]),
                        scale * (limits.max_rad[joint] - q_rad[joint])};
  }
}

void computeKinematics(const TickProgram& program, const arm::JointAngles& q_rad, TickReport& report,
                       safety::Motion& motion) noexcept {
  const Needs& needs = program.needs;
  const arm::Kinematics at = arm::kinematics(program.geometry, q_rad, {needs.orientation, needs.motors});
  report.p_WT = at.X_WT.translation();
  if (needs.orientation) {
    report.R_WT = at.X_WT.linear();
    report.stylus_W = at.X_WT.linear().col(2);
  }
  if (needs.motors) watchJoints(program.watched, program.joint_limits, q_rad, at.J, motion);
  motion.turns = needs.moment && program.watched.turn;
  motion.renders_all = program.watched.push_freely;
  if (!motion.renders_all) motion.renders = arm::renderable(*program.geometry.mechanism, at.J);
  if (motion.turns) motion.renders_wrench = arm::renderableWrench(at.J, safety::kMomentArm_m);
}

void computeMotion(const arm::JointAngles& q_rad, const TickState& before, double dt_s, const Vec3& p_WT,
                   safety::Motion& motion) noexcept {
  if (dt_s > 0.0) motion.v_WT = (p_WT - before.p_WT) / dt_s;
  motion.moved = !(dt_s > 0.0) || q_rad != before.q_rad;
}

}  // namespace underact::tick
