#pragma once
#include <cstdint>

namespace underact {

/// How the simulated arm goes on over a substep. All take dampers and springs implicitly and stay calm at any substep.
/// MeanVelocity: dampers and springs act as at its end, the way is that of the mean velocity; exact under a held force
/// alone. EndVelocity: the way is that of the velocity at its end (backward Euler): a force has its effect half a
/// substep early. Both are of first order. Trapezoidal: dampers and springs act as at the mean of begin and end;
/// of second order.
enum class Integrator : std::uint8_t { MeanVelocity, EndVelocity, Trapezoidal };

// The usual substep. The wall's own time constant, sqrt(m / k) = 17 ms at 0.5 N/mm, is 340 of them.
inline constexpr std::int64_t kSubstep_ns = 50'000;

/// In how fine steps the simulated arm is integrated.
struct Integration {
  Integrator integrator = Integrator::MeanVelocity;
  std::int64_t substep_ns = kSubstep_ns;  // above 0; the last one of a period is what is left of it
};

}  // namespace underact
