#pragma once
#include <cstdint>

namespace underact {

/// How the simulated arm goes on over a substep. All take dampers and springs implicitly and stay calm at any substep.
/// MeanVelocity: dampers and springs act as at its end, the way is that of the mean velocity; exact under a held force
/// alone. EndVelocity: the way is that of the velocity at its end (backward Euler): a force has its effect half a
/// substep early. Both are of first order. Trapezoidal: dampers and springs act as at the mean of begin and end;
/// of second order.
enum class Integrator : std::uint8_t { MeanVelocity, EndVelocity, Trapezoidal };

// The usual way is chosen from `lab trade` (the guide's page lab.md): twice as fast as steps of 50 us by the mean
// velocity, and more than three times as exact.
inline constexpr std::int64_t kSubstep_ns = 200'000;

/// In how fine steps the simulated arm is integrated.
struct Integration {
  Integrator integrator = Integrator::Trapezoidal;
  std::int64_t substep_ns = kSubstep_ns;  // above 0; the last one of a period is what is left of it
};

}  // namespace underact
