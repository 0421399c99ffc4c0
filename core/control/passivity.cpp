#include "core/control/passivity.h"

#include <algorithm>
#include <cmath>

#include "core/base/valid_bytes.h"

namespace underact::control {
namespace {

// A limit of the surplus, so that energy dissipated long ago does not pay for a burst now: 0.5 mJ moves 0.145 kg at 83
// mm/s.
constexpr double kMaxSurplus_J = 5e-4;
// The apparent mass of the arm alone. A damping of m / dt stops it within a tick; a higher one reverses it.
constexpr double kMinMass_kg = 0.045;
// An encoder shows a uniform motion of 50 mm/s as 0.055 mm a tick, a slower one as steps with ticks without motion in
// between: a step is remembered for about two ticks, and a step forth and back cancels.
constexpr double kSmooth_s = 2e-3;

/// Whether the constraint took over from another one or is there for the first time, not by a motion of the hand, as
/// where a wall is touched or left.
bool isHandedOver(const EnergyState& state, const PassivityInput& passage) noexcept UNDERACT_REAL_TIME {
  const bool by_hand = passage.untouched || state.untouched;
  return !state.begun || passage.edited || (state.pulled != passage.pulls && !by_hand);
}

Vec3 partAlong(const Vec3& v_W, const Vec3& direction_W) noexcept UNDERACT_REAL_TIME {
  const double size2 = direction_W.squaredNorm();
  return size2 > 0.0 && std::isfinite(size2) ? Vec3((v_W.dot(direction_W) / size2) * direction_W) : Vec3(Vec3::Zero());
}

/// The mean force since the last encoder step: a tip measured in steps seems to rest until a step is complete, but
/// moved all the while. Where every tick shows motion, it is the last force.
Vec3 meanForce(EnergyState& state, const PassivityInput& passage) noexcept UNDERACT_REAL_TIME {
  if (!state.begun) return Vec3::Zero();
  state.impulse_N_s += passage.dt_s * passage.f_T_W;
  state.still_s += passage.dt_s;
  if (passage.displacement_T_W == Vec3::Zero() || !(state.still_s > 0.0)) return Vec3::Zero();
  const Vec3 mean_T_W = state.impulse_N_s / state.still_s;
  state.impulse_N_s.setZero();
  state.still_s = 0.0;
  return mean_T_W;
}

}  // namespace

double clampedEnergy(double spring_J, double force_N, double max_force_N) noexcept {
  if (!(spring_J > 0.0) || !std::isfinite(spring_J) || !std::isfinite(force_N)) return 0.0;
  if (!(force_N > max_force_N)) return spring_J;
  const double share = max_force_N / force_N;
  return spring_J * share * (2.0 - share);
}

bool isValid(const EnergyState& state) noexcept {
  return isFlag(state.pulled) && isFlag(state.untouched) && isFlag(state.begun);
}

void observe(EnergyState& state, const PassivityInput& passage) noexcept {
  const double taken_J = -meanForce(state, passage).dot(passage.displacement_T_W);
  const double grown_J = passage.level * (passage.stored_J - state.stored_J);
  const double ramped_J = (passage.level - state.level) * state.stored_J;
  const bool handed_over = isHandedOver(state, passage);
  state.energy_J += taken_J + ramped_J + (handed_over ? grown_J : 0.0);
  state.balance_J = std::min(state.balance_J + taken_J - (handed_over ? 0.0 : grown_J), kMaxSurplus_J);
  const double share = handed_over ? 1.0 : passage.dt_s / (passage.dt_s + kSmooth_s);
  const Vec3 change_W = handed_over ? Vec3(-passage.displacement_T_W) : Vec3(passage.e_W - state.e_last_W);
  state.displacement_T_W += share * (passage.displacement_T_W - state.displacement_T_W);
  state.change_W += share * (change_W - state.change_W);
  if (!std::isfinite(state.energy_J)) state.energy_J = 0.0;
  if (!std::isfinite(state.balance_J)) state.balance_J = 0.0;
  if (!std::isfinite(state.displacement_T_W.squaredNorm())) state.displacement_T_W.setZero();
  if (!std::isfinite(state.change_W.squaredNorm())) state.change_W.setZero();
}

Vec3 damper(const EnergyState& state, const PassivityInput& passage) noexcept {
  if (!(state.balance_J < 0.0) || !(passage.dt_s > 0.0) || isHandedOver(state, passage)) return Vec3::Zero();
  // The part of the displacement along which the spring acts: along its force, or along the change of its error,
  // whichever is more. The second counts where the force rotates, as on a circle about a point.
  const Vec3 along_pull_W = partAlong(state.displacement_T_W, passage.e_W);
  const bool gives_way = state.change_W.dot(state.displacement_T_W) < 0.0;
  const Vec3 along_change_W = gives_way ? partAlong(state.displacement_T_W, state.change_W) : Vec3(Vec3::Zero());
  const Vec3& felt_W = along_change_W.squaredNorm() > along_pull_W.squaredNorm() ? along_change_W : along_pull_W;
  // What a damper along it dissipates in the next tick: as now, or as recently where the encoders show no step now.
  const double felt2_m2 = std::max(felt_W.squaredNorm(), felt_W.dot(passage.displacement_T_W));
  if (!(felt2_m2 > 0.0)) return Vec3::Zero();
  const double max_N_per_m = kMinMass_kg / (passage.dt_s * passage.dt_s);
  return -std::min(-state.balance_J / felt2_m2, max_N_per_m) * felt_W;
}

void remember(EnergyState& state, const PassivityInput& passage, const Vec3& f_T_W) noexcept {
  state.stored_J = passage.stored_J;
  state.level = passage.level;
  state.e_last_W = passage.e_W;
  state.f_T_W = f_T_W;
  state.pulled = passage.pulls;
  state.untouched = passage.untouched;
  state.begun = true;
}

}  // namespace underact::control
