#pragma once
#include <array>
#include <cstdint>
#include <variant>

#include "core/base/real_time.h"
#include "core/base/types.h"

namespace underact::control {

// Four estimators of the rate of a quantised signal, with different trade-offs of delay and noise. The guide's page
// velocity.md compares them on the same motions.

// Time constant of the low-pass filter. One encoder step (0.055 mm) at 1 kHz is 55 mm/s unfiltered; 1.6 ms (100 Hz)
// leaves 21 mm/s of it and costs 1.6 ms of delay.
inline constexpr double kRateFilter_s = 1.6e-3;

/// First order, by backward Euler, so that it is stable at any rate.
struct LowPass {
  double time_constant_s = kRateFilter_s;
};

/// The last difference over its time.
struct RawDifference {};

inline constexpr int kLongestWindow = 32;

/// The slope over as many of the last samples as lie within noise of a straight line: few where the motion changes,
/// many where it is uniform. Source: Janabi-Sharifi, Hayward and Chen 2000, first-order adaptive windowing: the window
/// by the line through its ends (end-fit), its slope by least squares (best-fit).
struct AdaptiveWindow {
  int window = 16;                 // ticks at most, 1 to kLongestWindow
  Vec3 noise = Vec3::Constant(0);  // per axis, in the unit of the signal: tolerance about the line
};

/// A Kalman filter for a measured position and a velocity with white acceleration of spectral density acceleration^2
/// times 1 ms, so that the servo's rate matters little. Both in the unit of the signal; only their ratio counts.
struct Kalman {
  double noise = 1.0;         // of a sample, standard deviation
  double acceleration = 1.0;  // of the signal, a second squared
};

/// How a velocity is estimated from samples; VelocityState::filter is the index in here.
using Velocity = std::variant<LowPass, RawDifference, AdaptiveWindow, Kalman>;

/// The last samples of each axis, the newest at `newest`, `count` of them.
struct Window {
  /// A ring of one quantity: one number for each sample.
  using Row = std::array<double, kLongestWindow + 1>;
  std::array<Row, 3> e_W = {};
  Row after_s = {};  // since the sample before it
  int newest = 0;
  int count = 0;
};

/// The state of a filter. e_last_W and rate_W are kept when the filter changes; the new one builds the rest from them.
struct VelocityState {
  Vec3 e_last_W = Vec3::Zero();
  Vec3 rate_W = Vec3::Zero();          // the filtered rate, a second
  bool has_last = false;               // false: the step to the next sample is no motion; the rate stays
  std::uint8_t filter = 0;             // to which the following belongs
  Vec3 place_W = Vec3::Zero();         // Kalman
  double spread[3] = {1.0, 0.0, 0.0};  // Kalman: covariance of position, of both, of velocity, in noise^2
  Window window = {};                  // AdaptiveWindow
};

/// Updates state.rate_W by a sample e_W that comes dt_s after the last one; 0: no time has passed, the rate stays.
/// Where has_last is false the rate stays, too, and the past is shifted to the present signal. Finite in, finite out,
/// up to overflow. Exact to some ulp of the largest sample over the time it looks back (the guide, extremes.md). Cost:
/// constant; for AdaptiveWindow linear in its window.
void updateRate(const Velocity& velocity, VelocityState& state, const Vec3& e_W,
                double dt_s) noexcept UNDERACT_REAL_TIME;

/// Sets the signal to rest at zero, as at an untouched wall, from which a motion may start.
void resetToZero(VelocityState& state) noexcept UNDERACT_REAL_TIME;

/// Resets the state to that before a first tick.
void reset(VelocityState& state) noexcept UNDERACT_REAL_TIME;

/// For bytes from a file: whether its counts and indexes keep a filter within its memory.
bool isValid(const VelocityState& state) noexcept;

}  // namespace underact::control
