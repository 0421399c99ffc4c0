#pragma once
#include <cstdint>

#include "core/base/real_time.h"
#include "core/base/types.h"

namespace underact::control {

// A wall that is felt through samples gives back a little more than was put into it: the force lags behind the hand.
// The observer counts what each constraint was given and gave; the controller damps by what is missing. Source:
// Hannaford and Ryu 2002 (time-domain passivity), with the force paired to the displacement during which it was in
// effect, and the energy of the spring as reference (Ryu, Kim and Hannaford 2004), so that damping comes while the
// energy is lost and not as a blow at the end of a push.

/// Whether a scene has the passivity observer, and the passivity controller with it.
enum class Passivity : std::uint8_t { Off, Observe, Control };

/// All memory of one constraint's observer.
struct EnergyState {
  double energy_J = 0.0;            // put in by the stylus and not got back
  double balance_J = 0.0;           // what is over (or, below 0, missing) of the spring's own energy
  double stored_J = 0.0;            // in the spring at the last tick, with the whole force let through
  double level = 0.0;               // share of the force that the gate's ramp let through then
  Vec3 e_last_W = Vec3::Zero();     // its error then, zero where it was untouched
  Vec3 f_T_W = Vec3::Zero();        // its force, before the gate
  Vec3 impulse_N_s = Vec3::Zero();  // of its force in effect since the tip last seemed to move
  Vec3 way_T_W = Vec3::Zero();      // of the tip in a tick, smoothed over steps of the encoders
  Vec3 change_W = Vec3::Zero();     // of the error in a tick, the same
  double still_s = 0.0;             // how long ago that was
  bool pulled = false;              // it acted then
  bool untouched = false;           // it was a free wall then
  bool begun = false;               // there was a tick before
};

/// Of bytes from a file.
bool isSound(const EnergyState& state) noexcept;

/// A tick as one constraint sees it.
struct Passage {
  Vec3 way_T_W = Vec3::Zero();  // of the tip since the last tick, m
  Vec3 f_T_W = Vec3::Zero();    // the constraint's part of the force that was in effect on that way, N
  Vec3 e_W = Vec3::Zero();      // the error now, m; zero where the constraint is untouched
  double stored_J = 0.0;        // in its spring now, with the whole force let through
  double level = 0.0;           // share that the gate's ramp lets through, 0 to 1
  double dt_s = 0.0;            // since the last tick
  bool pulls = false;           // it acts
  bool untouched = false;       // it is a free wall
  bool edited = false;          // gains or target are others than they were a tick ago
};

/// What a spring of energy spring_J under force_N holds once it is clamped to max_force_N: less of the part that lies
/// beyond. 0 where a number is none.
double clampedEnergy(double spring_J, double force_N, double max_force_N) noexcept UNDERACT_REAL_TIME;

/// Counts the tick. What the program itself puts in is no gain of the stylus's and is credited: the share of the stored
/// energy by which the ramp goes up (or down), an edit, and what a constraint holds that takes over as the nearest one.
/// The energy is exact within 64 ulp of all that was added up. Finite in, finite out.
void observe(EnergyState& state, const Passage& passage) noexcept UNDERACT_REAL_TIME;

/// The force that takes out what is missing, if the tip goes on as it did: against that part of its way which the
/// spring feels, so that along a plane or a line the stylus stays free. Never more than stops the arm's own mass within
/// a tick; the rest stays on the account. Zero where nothing is missing. To be called after observe().
Vec3 damper(const EnergyState& state, const Passage& passage) noexcept UNDERACT_REAL_TIME;

/// Keeps what the next tick is compared with. f_T_W: what the constraint asks for in all, before the gate, N.
void remember(EnergyState& state, const Passage& passage, const Vec3& f_T_W) noexcept UNDERACT_REAL_TIME;

}  // namespace underact::control
