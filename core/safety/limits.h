#pragma once
#include <array>
#include <cstddef>

#include "core/base/real_time.h"
#include "core/base/types.h"

namespace underact::safety {

/// The most driven joints of an arm.
inline constexpr std::size_t kMaxDriven = 8;

/// The lever arm at which a moment counts as much as a force: a hand's grip on a tool.
inline constexpr double kMomentArm_m = 0.1;

/// One number for each driven joint; infinite: no limit.
using PerDriven = std::array<double, kMaxDriven>;
inline constexpr PerDriven kNoTorqueLimits{kInfinity, kInfinity, kInfinity, kInfinity,
                                           kInfinity, kInfinity, kInfinity, kInfinity};

/// The thermal model of the driven joints' motors: heat 1 is the steady state at the continuous torque.
struct Thermal {
  PerDriven continuous_N_m{};     // continuous torque; a motor of 0 is not watched
  double time_constant_s = 60.0;  // assumed: no data sheet of the arm states it
};

/// The limits of the gate. One that is infinite, or 0 where so stated, is off.
struct Limits {
  double max_force_N = 0.0;               // the arm's continuous force
  double rise_s = 0.3;                    // soft start: from nothing to the whole force
  double fall_s = 0.05;                   // soft release
  int max_missed = 20;                    // ticks in a row without a new sample, then the servo stops
  int max_late = 20;                      // ticks in a row a whole period late, then the force is released
  double max_slew_N_per_s = kInfinity;    // how fast the force itself may change
  double calm_speed_m_per_s = kInfinity;  // up to this speed a force may drive the stylus along ...
  double max_speed_m_per_s = kInfinity;   // ... and from this one on none may; forces against the motion pass
  double max_jump_m_per_s = kInfinity;    // between two samples: beyond it, no hand moved the tip
  double frozen_s = 0.0;                  // joints bit-identical for so long: release; 0: off
  double edge_rad = 0.0;                  // within this of a joint's stop a force towards it fades; 0: off
  Thermal thermal = {};
  double max_moment_N_m = 0.0;                 // of an arm that renders one
  PerDriven max_torque_N_m = kNoTorqueLimits;  // of the driven joints; N where they slide
};

/// The limits for a hand on an arm: all of them on except frozen_s, which depends on the device (a real encoder shows
/// noise, a simulated one need not). max_force_N: of the arm; continuous_N_m: of its first three motors.
Limits limitsForHands(double max_force_N, const Vec3& continuous_N_m);

/// What each limit took off the force this tick, N, in the order in which they act.
struct Cuts {
  double clamp_N = 0.0;
  double speed_N = 0.0;
  double edge_N = 0.0;
  double heat_N = 0.0;
  double slew_N = 0.0;
  bool frozen = false;      // the sample has not moved for frozen_s: the force is let go until it does
  double motors_N = 0.0;    // what no motor can render; acts between speed and edge
  double moment_N_m = 0.0;  // what all of them took off the moment; no bit, and not in the sum
};

/// The limits that act as bits, for a row of a recording.
enum CutBit : unsigned {
  kClampBit = 1,
  kSpeedBit = 2,
  kEdgeBit = 4,
  kHeatBit = 8,
  kSlewBit = 16,
  kFrozenBit = 32,
  kMotorsBit = 64
};
/// The CutBits of the limits that took something off. A cut that is not a number counts as none.
unsigned bitsOf(const Cuts& cuts) noexcept UNDERACT_REAL_TIME;

/// All that was taken off, N.
double sumOf(const Cuts& cuts) noexcept UNDERACT_REAL_TIME;

}  // namespace underact::safety
