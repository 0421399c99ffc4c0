#include "core/tick/energy.h"

#include <cmath>

#include "core/arm/inverse.h"
#include "core/control/passivity.h"

namespace underact::tick {
namespace {

/// The energy in its spring, for the force that the clamp lets through.
double storedIn(const TickProgram& program, const TickReport& report, const TickState& state,
                std::size_t index) noexcept UNDERACT_REAL_TIME {
  const Entry& entry = program.entries[index];
  const ConstraintReport& held = report.held[index];
  const double max_N = program.limits.max_force_N;
  if (held.robot.joints > 0) return control::clampedEnergy(held.robot.energy_J, held.f_T_W.norm(), max_N);
  const Vec3& kp = control::stiffness(entry.law);
  if (entry.space == Space::Cartesian) {
    const Vec3 e_W = held.p_WP - report.p_WT, f_T_W = kp.cwiseProduct(e_W);
    return control::clampedEnergy(0.5 * f_T_W.dot(e_W), f_T_W.norm(), max_N);
  }
  const arm::JointAngles& q_rad = report.sample.q_rad;
  const arm::JointAngles wanted_rad = arm::withinLimits(program.joint_limits, state.entries[index].follower.q_rad);
  const Vec3 e_rad(wanted_rad[0] - q_rad[0], wanted_rad[1] - q_rad[1], wanted_rad[2] - q_rad[2]);
  return control::clampedEnergy(0.5 * kp.cwiseProduct(e_rad).dot(e_rad), held.f_T_W.norm(), max_N);
}

/// The part of the force sent last that belongs to a constraint which asked for f_T_W of it. A single one has all of
/// it; several share it in proportion, and what the gate's slew limit adds belongs to none.
Vec3 partOf(const TickState& state, const Vec3& f_T_W) noexcept UNDERACT_REAL_TIME {
  if (state.entries.size() == 1) return state.gate.f_T_W;
  const double asked2_N2 = state.asked_T_W.squaredNorm();
  if (!(asked2_N2 > 0.0) || !std::isfinite(asked2_N2)) return Vec3::Zero();
  return (state.gate.f_T_W.dot(state.asked_T_W) / asked2_N2) * f_T_W;
}

}  // namespace

void observeEnergy(const TickProgram& program, const control::LawInput& moment, const Vec3& displacement_T_W,
                   std::size_t index, TickState& state, TickReport& report) noexcept {
  const Entry& entry = program.entries[index];
  ConstraintReport& held = report.held[index];
  control::EnergyState& energy = state.entries[index].energy;
  if (moment.idle || entry.passivity == control::Passivity::Off) {
    energy = control::EnergyState{};
    return;
  }
  control::PassivityInput passage;
  passage.displacement_T_W = displacement_T_W;
  passage.f_T_W = partOf(state, energy.f_T_W);
  passage.level = state.gate.level;
  passage.dt_s = moment.dt_s;
  passage.pulls = held.status == target::Status::Unique && held.acts;
  passage.untouched = held.status == target::Status::Free;
  passage.edited = state.retuned;
  if (passage.pulls) {
    passage.e_W = held.p_WP - report.p_WT;
    passage.stored_J = storedIn(program, report, state, index);
  }
  control::observe(energy, passage);
  if (passage.pulls && entry.passivity == control::Passivity::Control) {
    const Vec3 f_T_W = held.f_T_W, damper_T_W = control::damper(energy, passage);
    if (damper_T_W != Vec3::Zero()) {
      // The damper would be negligible beside a force beyond the gate's limit.
      const Vec3 pushed_T_W = safety::clampForce(f_T_W, program.limits.max_force_N);
      held.f_T_W = pushed_T_W + damper_T_W;
      if (held.f_T_W.dot(passage.e_W) < 0.0) held.f_T_W.setZero();  // nor must it push the arm back
      held.f_passive_T_W = held.f_T_W - pushed_T_W;
    }
  }
  held.energy_J = energy.energy_J;
  control::remember(energy, passage, held.f_T_W);
}

}  // namespace underact::tick
