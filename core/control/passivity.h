#pragma once
#include <cstdint>

#include "core/base/real_time.h"
#include "core/base/types.h"

namespace underact::control {

// A sampled wall returns slightly more energy than was put into it, since the force lags behind the hand. The passivity
// observer accounts for the energy of each constraint; the passivity controller dissipates what is generated. Source:
// Hannaford and Ryu 2002 (time-domain passivity), with the force paired with the displacement during which it was in
// effect, and the energy of the spring as reference (Ryu, Kim and Hannaford 2004), so that damping acts while energy is
// generated and not as a jolt at the end of a push.

/// Whether a scene has the passivity observer, and the passivity controller with it.
enum class Passivity : std::uint8_t { Off, Observe, Control };

/// The state of one constraint's observer.
struct EnergyState {
  double energy_J = 0.0;                 // net energy that the stylus has put in
  double balance_J = 0.0;                // excess over the spring's own energy; below 0: missing
  double stored_J = 0.0;                 // in the spring at the last tick, at full force
  double level = 0.0;                    // share of the force that passed the gate's ramp then
  Vec3 e_last_W = Vec3::Zero();          // its error then, zero where it was untouched
  Vec3 f_T_W = Vec3::Zero();             // its force, before the gate
  Vec3 impulse_N_s = Vec3::Zero();       // of its force since the tip was last seen to move
  Vec3 displacement_T_W = Vec3::Zero();  // of the tip in a tick, smoothed over encoder steps
  Vec3 change_W = Vec3::Zero();          // of the error in a tick, the same
  double still_s = 0.0;                  // how long ago that was
  bool pulled = false;                   // it acted then
  bool untouched = false;                // it was a free wall then
  bool begun = false;                    // there was a tick before
};

/// For bytes from a file: whether the state can be used.
bool isValid(const EnergyState& state) noexcept;

/// The input of one constraint's observer in a tick.
struct PassivityInput {
  Vec3 displacement_T_W = Vec3::Zero();  // of the tip since the last tick, m
  Vec3 f_T_W = Vec3::Zero();             // the constraint's part of the force during that displacement, N
  Vec3 e_W = Vec3::Zero();               // the error now, m; zero where the constraint is untouched
  double stored_J = 0.0;                 // in its spring now, at full force
  double level = 0.0;                    // share that passes the gate's ramp, 0 to 1
  double dt_s = 0.0;                     // since the last tick
  bool pulls = false;                    // it acts
  bool untouched = false;                // it is a free wall
  bool edited = false;                   // gains or target have changed since the last tick
};

/// The energy of a spring with energy spring_J and force force_N once it is clamped to max_force_N: less that of the
/// part beyond. 0 where a number is not finite.
double clampedEnergy(double spring_J, double force_N, double max_force_N) noexcept UNDERACT_REAL_TIME;

/// Accounts for a tick. Energy put in by the program itself is credited, not attributed to the stylus: the share of the
/// stored energy by which the ramp goes up (or down), an edit, and the energy of a constraint that takes over as the
/// nearest one. The energy is exact within 64 ulp of all summands. Finite in, finite out.
void observe(EnergyState& state, const PassivityInput& passage) noexcept UNDERACT_REAL_TIME;

/// The force that dissipates the missing energy, if the tip continues its motion: against the part of its displacement
/// along which the spring acts, so that the stylus stays free along a plane or a line. At most what stops the arm's own
/// mass within a tick; the rest remains on the account. Zero where nothing is missing. To be called after observe().
Vec3 damper(const EnergyState& state, const PassivityInput& passage) noexcept UNDERACT_REAL_TIME;

/// Stores what the next tick is compared with. f_T_W: the whole force of the constraint, before the gate, N.
void remember(EnergyState& state, const PassivityInput& passage, const Vec3& f_T_W) noexcept UNDERACT_REAL_TIME;

}  // namespace underact::control
