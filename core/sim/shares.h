#pragma once
#include "core/base/integration.h"
#include "core/base/real_time.h"

namespace underact::sim {

// Inside the room: what an integrator is, of every arm.

/// The weights of the velocities v at the beginning and v' at the end of a substep, which sum to 1: for the
/// displacement, and for the dampers. Without a mass there is no initial velocity, and v' alone counts: both 0.
struct Shares {
  double way_begin = 0.0, damping_begin = 0.0;
};

inline Shares sharesOf(Integrator integrator) noexcept UNDERACT_REAL_TIME {
  if (integrator == Integrator::EndVelocity) return {0.0, 0.0};
  return {0.5, integrator == Integrator::Trapezoidal ? 0.5 : 0.0};
}

}  // namespace underact::sim
