#pragma once
#include <array>
#include <cstdint>
#include <variant>

#include "core/base/real_time.h"
#include "core/base/types.h"

namespace underact::control {

// How fast a signal changes that comes in steps: four ways, each another trade of delay for noise. The guide's page
// velocity.md has the figures of each on the same motions.

// Time constant of the usual filter. One encoder step (0.055 mm) at 1 kHz is 55 mm/s unfiltered; 1.6 ms (100 Hz) leaves
// 21 mm/s of it and costs 1.6 ms of delay.
inline constexpr double kRateFilter_s = 1.6e-3;

/// First order: backward Euler, so that it stays calm at any rate.
struct LowPass {
  double time_constant_s = kRateFilter_s;
};

/// The last difference over its time, and nothing else.
struct RawDifference {};

inline constexpr int kLongestWindow = 32;

/// The slope over as many of the last samples as lie within noise of one straight line: short where the hand turns,
/// long where it moves evenly. Source: Janabi-Sharifi, Hayward and Chen 2000, first-order adaptive windowing: the
/// window by the line through its ends (end-fit), the slope of it by least squares (best-fit).
struct AdaptiveWindow {
  int window = 16;                 // ticks at most, 1 to kLongestWindow
  Vec3 noise = Vec3::Constant(0);  // per axis, in the unit of the signal: as far as a sample may lie off the line
};

/// Kalman's filter for a place that is measured and a velocity that drifts: white acceleration with spectral density
/// acceleration^2 times 1 ms, so that the rate of the servo changes little. Both in the unit of the signal; it is their
/// ratio that decides.
struct Kalman {
  double noise = 1.0;         // of a sample, standard deviation
  double acceleration = 1.0;  // of the signal, a second squared
};

/// How a velocity is estimated from samples; VelocityState::filter is the index in here.
using Velocity = std::variant<LowPass, RawDifference, AdaptiveWindow, Kalman>;

/// The last samples, axis by axis, the newest at `newest`; as many as count are there.
struct Window {
  /// A ring of one quantity: one number for each sample.
  using Row = std::array<double, kLongestWindow + 1>;
  std::array<Row, 3> e_W = {};
  Row after_s = {};  // since the sample before it
  int newest = 0;
  int count = 0;
};

/// All memory of a filter. e_last_W and rate_W go over from one filter to another; each makes what it needs besides out
/// of them.
struct VelocityState {
  Vec3 e_last_W = Vec3::Zero();
  Vec3 rate_W = Vec3::Zero();          // what the filter makes of it, a second
  bool has_last = false;               // false: from the last sample to the next is no motion; the rate stays as it is
  std::uint8_t filter = 0;             // whose memory follows
  Vec3 place_W = Vec3::Zero();         // Kalman
  double spread[3] = {1.0, 0.0, 0.0};  // Kalman: of place, of both, of velocity, in noise^2
  Window window = {};                  // AdaptiveWindow
};

/// state.rate_W after a sample e_W that comes dt_s after the one before it; 0: no time has passed, the rate stays.
/// Where has_last is false the rate stays, too, and the past goes along to where the signal is now. Finite in, finite
/// out, up to overflow. Exact to some ulp of the largest sample over the time it looks back (the guide, extremes.md).
/// Cost: constant, but for AdaptiveWindow, which is linear in its window.
void followRate(const Velocity& velocity, VelocityState& state, const Vec3& e_W,
                double dt_s) noexcept UNDERACT_REAL_TIME;

/// The signal stands at zero, as at a wall that nobody touches; a motion may start from there.
void standAtZero(VelocityState& state) noexcept UNDERACT_REAL_TIME;

/// Nothing is known any more, as on a first tick.
void forget(VelocityState& state) noexcept UNDERACT_REAL_TIME;

/// Of bytes from a file: its counts and places are such that a filter keeps within its memory.
bool isSound(const VelocityState& state) noexcept;

}  // namespace underact::control
