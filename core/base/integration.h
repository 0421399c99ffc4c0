#pragma once
#include <cstdint>

namespace underact {

/// How a substep of the simulated arm is integrated. All treat dampers and springs implicitly and are stable for any
/// substep. MeanVelocity: dampers and springs act as at the end, the displacement is that of the mean velocity; exact
/// under a constant force alone. EndVelocity: the displacement is that of the velocity at the end (backward Euler): a
/// force acts half a substep early. Both are of first order. Trapezoidal: dampers and springs act as at the mean of
/// begin and end; of second order. Every arm takes each of them.
enum class Integrator : std::uint8_t { MeanVelocity, EndVelocity, Trapezoidal };

// The default is chosen from `lab trade` (the guide's page lab.md): twice as fast as steps of 50 us by the mean
// velocity, and more than three times as accurate.
inline constexpr std::int64_t kSubstep_ns = 200'000;

/// How the simulated arm is integrated.
struct Integration {
  Integrator integrator = Integrator::Trapezoidal;
  std::int64_t substep_ns = kSubstep_ns;  // above 0; the last one of a period is the remainder
};

}  // namespace underact
