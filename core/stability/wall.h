#pragma once
#include "core/control/velocity.h"
#include "core/sim/plant.h"

namespace underact::stability {

/// A mass with damping in a hand, held by a sampled virtual wall: F = -(K x + B dx/dt), held over a period and delayed
/// by some periods. K is the unknown.
struct SampledWall {
  double mass_kg = 0.045;          // of arm and hand; above 0
  double damping_N_s_per_m = 0.1;  // of arm and hand, from 0 on
  double hand_stiffness_N_per_m = 0.0;
  double kd_N_s_per_m = 0.0;                              // B
  control::Velocity velocity = control::RawDifference{};  // how dx/dt is found
  std::int64_t period_ns = 1'000'000;
  int delay_ticks = 0;      // 0 to kMaxDelay
  double friction_N = 0.0;  // Coulomb's
  double coarseness = 0.0;  // of the encoders: 1 in steps of the arm's own, 2 in steps twice as long; 0: exact

  /// Of a tick.
  double period_s() const { return 1e-9 * static_cast<double>(period_ns); }
  /// Whether the wall is linear, so that eigenvalues decide: no friction, no steps, a linear filter.
  bool isLinear() const;
};

inline constexpr int kMaxDelay = 16;

/// The default Kalman filter, in m.
control::Velocity defaultKalman();

/// A simulated arm of the same mass and damping, its tip free apart from the hand's spring.
sim::Plant plantOf(const SampledWall& wall);

}  // namespace underact::stability
