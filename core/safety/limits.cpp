#include "core/safety/limits.h"

#include <algorithm>

namespace underact::safety {
namespace {

// 1 N/ms, whatever the rate: a wall of 0.5 N/mm hit at 2 m/s needs as much, one encoder step a fortieth of it.
constexpr double kSlew_N_per_s = 1000.0;
// A hand follows shapes at up to about 1 m/s; an arm accelerated by its own force exceeds 2.
constexpr double kCalmSpeed_m_per_s = 1.0, kMaxSpeed_m_per_s = 2.0;
// A fist reaches 10 m/s: twice that was no hand, but a lost count or a corrupted sample.
constexpr double kMaxJump_m_per_s = 20.0;
constexpr double kEdge_rad = 0.05;  // 3 degrees: 7 mm at the tip

}  // namespace

Limits limitsForHands(double max_force_N, const Vec3& continuous_N_m) {
  Limits limits;
  limits.max_force_N = max_force_N;
  limits.max_slew_N_per_s = kSlew_N_per_s;
  limits.calm_speed_m_per_s = kCalmSpeed_m_per_s;
  limits.max_speed_m_per_s = kMaxSpeed_m_per_s;
  limits.max_jump_m_per_s = kMaxJump_m_per_s;
  limits.edge_rad = kEdge_rad;
  std::copy(continuous_N_m.begin(), continuous_N_m.end(), limits.thermal.continuous_N_m.begin());
  return limits;
}

unsigned bitsOf(const Cuts& cuts) noexcept {
  return (cuts.clamp_N > 0.0 ? kClampBit : 0U) | (cuts.speed_N > 0.0 ? kSpeedBit : 0U) |
         (cuts.edge_N > 0.0 ? kEdgeBit : 0U) | (cuts.heat_N > 0.0 ? kHeatBit : 0U) |
         (cuts.slew_N > 0.0 ? kSlewBit : 0U) | (cuts.frozen ? kFrozenBit : 0U) |
         (cuts.motors_N > 0.0 ? kMotorsBit : 0U);
}

double sumOf(const Cuts& cuts) noexcept {
  const double sum_N = cuts.clamp_N + cuts.speed_N + cuts.motors_N + cuts.edge_N + cuts.heat_N + cuts.slew_N;
  return sum_N < std::numeric_limits<double>::max() ? sum_N : std::numeric_limits<double>::max();
}

}  // namespace underact::safety
