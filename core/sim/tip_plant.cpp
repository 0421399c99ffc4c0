#include <algorithm>
#include <cmath>

#include "core/arm/forward.h"
#include "core/arm/inverse.h"
#include "core/arm/jacobian.h"
#include "core/base/units.h"
#include "core/sim/mechanics.h"

namespace underact::sim {
namespace {

constexpr double kMinLever_m = 1e-3;  // a joint that moves the tip less than this per radian is not used
constexpr double kBefore_m = 0.06;    // where nobody holds it: before the middle of the workspace

/// The forces on the tip over a substep besides the arm's.
struct Pull {
  double mass_kg;
  double own_damping_N_s_per_m;  // of the arm: against its velocity
  double damping_N_s_per_m;      // of the hand: against its velocity less the one that the hand wants
  double stiffness_N_per_m;
  double friction_N;
};

/// One substep: the momentum equation, solved for the velocity at its end. With w the share of v in the displacement
/// and d its share in the dampers (1 - w and 1 - d those of v'), b_a the arm's own damping and b the hand's:   x' = x +
/// dt (w v + (1 - w) v')   M (v' - v) = dt (f - b_a (d v + (1 - d) v') + b (v_w - d v - (1 - d) v') + k (x_w - x_s)) -
/// r, |r| <= mu dt r against v', and x_s where the spring is evaluated: x', or with d = 1/2 the middle of x and x'
/// (v_w, x_w: there, too). A displacement by v' alone makes a force act half a substep early. The solution is exact: an
/// impulse below the friction leaves v' = 0, and friction never reverses a direction.
void substep(const Pull& pull, const Shares& shares, const Vec3& f_T_W, const Vec3& p_WH, const Vec3& v_WH, double dt_s,
             PlantState& state) noexcept UNDERACT_REAL_TIME {
  const double begin_s = dt_s * shares.travel_begin, end_s = dt_s - begin_s;
  const double spring = 1.0 - shares.damping_begin;  // share of the displacement after which the spring is evaluated
  const double b = pull.own_damping_N_s_per_m + pull.damping_N_s_per_m, k = pull.stiffness_N_per_m;
  const Vec3 p_WFree = state.p_WT + begin_s * state.v_WT;
  const Vec3 p_WSpring = state.p_WT + (spring * begin_s) * state.v_WT;
  const Vec3 p_WMeant = p_WH - (shares.damping_begin * dt_s) * v_WH;
  const Vec3 hand_N = k * (p_WMeant - p_WSpring) + pull.damping_N_s_per_m * v_WH;
  const double carried_kg = pull.mass_kg - dt_s * shares.damping_begin * b;
  const double inertia_kg = pull.mass_kg + dt_s * ((1.0 - shares.damping_begin) * b + spring * end_s * k);
  const Vec3 impulse_N_s = carried_kg * state.v_WT + dt_s * (f_T_W + hand_N);
  const double size_N_s = impulse_N_s.norm(), friction_N_s = pull.friction_N * dt_s;
  if (size_N_s > friction_N_s && inertia_kg > 0.0) {
    state.v_WT = impulse_N_s * ((1.0 - friction_N_s / size_N_s) / inertia_kg);
  } else {
    state.v_WT.setZero();
  }
  state.p_WT = p_WFree + end_s * state.v_WT;
}

/// Joints 1 to 3 within their limits that bring the tip near to p_WT, which they cannot reach: one joint after the
/// other, beginning at q_rad, the better of the present joints and the clamped joints for p_WT. (Clamped joints alone
/// are off by 30 mm where the elbow is nearly straight.)
void slideAtStop(const arm::Preset& arm, const Vec3& p_WT, arm::JointAngles& q_rad) noexcept UNDERACT_REAL_TIME {
  constexpr int kSweeps = 8;  // joint 1 is independent of 2 and 3, of which mostly one is at its stop
  for (int sweep = 0; sweep < kSweeps; ++sweep) {
    for (std::size_t joint = 0; joint < 3; ++joint) {
      const arm::Tip tip = arm::tip(arm.geometry, q_rad);
      const Vec3 offset = tip.J_p.col(static_cast<Eigen::Index>(joint));
      const double way2 = offset.squaredNorm();
      if (!(way2 > kMinLever_m * kMinLever_m)) continue;
      const double wanted_rad = q_rad[joint] + offset.dot(p_WT - tip.p_WT) / way2;
      q_rad[joint] = std::clamp(wanted_rad, arm.limits.min_rad[joint], arm.limits.max_rad[joint]);
    }
  }
}

/// Makes tip and joints 1 to 3 consistent, within reach and limits; the wrist stays.
void holdInLimits(const arm::Preset& arm, PlantState& state) noexcept UNDERACT_REAL_TIME {
  const arm::PositionSolution reach = arm::solvePosition(arm.geometry, state.p_WT);
  const arm::JointAngles held_rad = arm::withinLimits(arm.limits, reach.q_rad);
  const arm::JointAngles before_rad = state.q_rad;
  bool at_stop = false;
  for (std::size_t joint = 0; joint < 3; ++joint) {
    at_stop = at_stop || held_rad[joint] != reach.q_rad[joint];
    state.q_rad[joint] = held_rad[joint];
  }
  if (reach.reachable && !at_stop) return;
  if (at_stop) {
    const Vec3 p_WBefore = arm::tipPosition(arm.geometry, before_rad),
               p_WCut = arm::tipPosition(arm.geometry, state.q_rad);
    if ((p_WBefore - state.p_WT).squaredNorm() < (p_WCut - state.p_WT).squaredNorm()) state.q_rad = before_rad;
    slideAtStop(arm, state.p_WT, state.q_rad);
  }
  const Vec3 p_WL = arm::tipPosition(arm.geometry, state.q_rad);
  const Vec3 beyond_W = state.p_WT - p_WL;
  const double beyond_m = beyond_W.norm();
  if (beyond_m > 0.0) {
    const Vec3 out_W = beyond_W / beyond_m;
    state.v_WT -= std::max(0.0, state.v_WT.dot(out_W)) * out_W;
  }
  state.p_WT = p_WL;
}

PlantState tipAtRest(const Plant& plant, const Vec3* p_WT) noexcept UNDERACT_REAL_TIME {
  PlantState state;
  state.p_WT = p_WT != nullptr ? *p_WT : Vec3(0.0, 0.0, kBefore_m);
  state.q_rad = arm::withinLimits(plant.arm.limits, arm::dhFromDevice({}));
  holdInLimits(plant.arm, state);
  return state;
}

PlantState advanceTip(const Plant& plant, PlantState state, const Pushed& pushed, const HandSetpoint& wish,
                      std::int64_t period_ns) noexcept UNDERACT_REAL_TIME {
  const Pull pull{plant.model.mass_kg + plant.hand.mass_kg, plant.model.damping_N_s_per_m, plant.hand.damping_N_s_per_m,
                  wish.holds ? plant.hand.stiffness_N_per_m : 0.0, plant.model.friction_N};
  const Shares shares = pull.mass_kg > 0.0 ? sharesOf(plant.integration.integrator) : Shares{};
  for (std::int64_t left_ns = period_ns; left_ns > 0;) {
    const std::int64_t step_ns = std::min(left_ns, plant.integration.substep_ns);
    left_ns -= step_ns;
    const Vec3 p_WH = wish.p_WT - (kSecondPerNanosecond * static_cast<double>(left_ns)) * wish.v_WT;
    substep(pull, shares, pushed.f_T_W, p_WH, wish.v_WT, kSecondPerNanosecond * static_cast<double>(step_ns), state);
  }
  if (!isFinite(state)) return state;
  holdInLimits(plant.arm, state);
  if (wish.turns) state.q_rad = arm::withinLimits(plant.arm.limits, arm::solveWrist(state.q_rad, wish.R_WT));
  return state;
}

}  // namespace

const Mechanics kTipMechanics{tipAtRest, advanceTip, arm::deviceFromDh, arm::dhFromDevice};

}  // namespace underact::sim
