#pragma once
#include <optional>

#include "core/lab/transfer_function.h"

namespace underact::lab {

inline constexpr double kSettlingBand = 0.02, kRiseFrom = 0.1, kRiseTo = 0.9;  // shares of the final value

/// What a step response is like. Rise: from 10 % of the final value, first passed, to 90 %, first passed. Settling:
/// from then on within 2 % of the final value. Peak: the time of the greatest value, where one is above the final
/// value; the overshoot is what it is above, a share of the final value. Source: Beckman 2007, section B.4.
struct StepMetrics {
  std::optional<double> final_value;         // none: there is none
  std::optional<double> rise_10_90_s;        // none: no final value, or one of 0
  std::optional<double> settling_2pct_s;     // none: never
  std::optional<double> peak_time_s;         // none: nothing is above the final value
  std::optional<double> overshoot_fraction;  // 0 where nothing is above it
};

/// Of the response to a unit step, each time to some 1e-12 of itself, as far as the poles determine it: found between
/// samples by the zeros of the response and of its rate. The final value of an undamped response is the one about which
/// it oscillates; a growing or drifting one, and one with a final value of 0, has no other metrics. Of equal peaks the
/// first counts; overshoot below 1e-14 is none. Cost: some ms, more for low damping. At most 640,000 samples (some
/// seconds), which only nearly undamped modes beside far slower ones need; beyond them a rise or peak is not found, and
/// the settling time may be too late.
StepMetrics metricsOf(const TransferFunction& transfer);

/// How long a plot of the response should be, s, above 0: one and a half times the settling time, six periods of an
/// oscillation, or what it takes to see drift or growth.
double plotDuration_s(const TransferFunction& transfer);

}  // namespace underact::lab
