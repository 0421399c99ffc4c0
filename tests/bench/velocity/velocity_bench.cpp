#include <algorithm>
#include <cmath>
#include <cstdio>
#include <functional>
#include <string>
#include <vector>

#include "core/arm/forward.h"
#include "core/arm/inverse.h"
#include "core/arm/preset.h"
#include "core/base/units.h"
#include "core/control/velocity.h"
#include "core/sim/hand_script.h"
#include "core/sim/plant.h"

// Delay and noise of the velocity filters on the same motions, seen through the arm's encoders. The delay of a filter
// is the lag at which the true velocity fits its own best; what does not fit even there is noise. Prints a table for
// the guide's page velocity.md; the same numbers on every machine.

namespace underact {
namespace {

// One encoder step is 0.055 mm at the tip; two encoders that step at once are 0.11 mm off a straight line. A step seen
// as noise has a standard deviation of its 3.5th part.
constexpr double kNoise_m = 110e-6, kSpread_m = 16e-6;

struct Motion {
  const char* name;
  double seconds;
  std::function<sim::HandSetpoint(std::int64_t)> at;
};

struct Named {
  const char* name;
  control::Velocity velocity;
};

Motion scripted(const char* name, const char* hand, double seconds) {
  const sim::HandScript script = sim::builtInHand(hand, 6).value();
  return {name, seconds, [script](std::int64_t time_ns) { return sim::setpointAt(script, time_ns); }};
}

std::vector<Motion> motions() {
  const Vec3 v_W = 0.005 * Vec3(0.6, 0.64, 0.48);
  const auto ramp = [v_W](std::int64_t time_ns) {
    sim::HandSetpoint setpoint;
    setpoint.v_WT = v_W;
    setpoint.p_WT = Vec3(-0.015, -0.01, 0.02) + kSecondPerNanosecond * static_cast<double>(time_ns) * v_W;
    return setpoint;
  };
  return {scripted("sweep", "sweep", 16.0),
          scripted("tremor", "tremor", 8.0),
          {"5 mm/s", 8.0, ramp},
          scripted("stroke", "stab", 3.0)};
}

std::vector<Named> filters() {
  return {{"`raw`", control::RawDifference{}},
          {"`low_pass`", control::LowPass{}},
          {"`low_pass`, 5 ms", control::LowPass{5e-3}},
          {"`adaptive_window`", control::AdaptiveWindow{8, Vec3::Constant(kNoise_m)}},
          {"`adaptive_window`, 16 ticks", control::AdaptiveWindow{16, Vec3::Constant(kNoise_m)}},
          {"`kalman`", control::Kalman{kSpread_m, 8.0}},
          {"`kalman`, 3 m/s^2", control::Kalman{kSpread_m, 3.0}}};
}

/// The tip as the encoders show it.
Vec3 seen(const arm::Preset& preset, const Vec3& p_WT) {
  return arm::tipPosition(preset.geometry, sim::quantized(preset, arm::solvePosition(preset.geometry, p_WT).q_rad));
}

struct Figures {
  double delay_ms, noise_mm_per_s, worst_mm_per_s, overshoot_mm_per_s;
};

double squaredMisfit(const Motion& motion, const std::vector<std::int64_t>& time_ns, const std::vector<Vec3>& rate_W,
                     std::int64_t lag_ns) {
  double sum = 0.0;
  for (std::size_t n = 0; n < rate_W.size(); ++n) {
    sum += (rate_W[n] - motion.at(time_ns[n] - lag_ns).v_WT).squaredNorm();
  }
  return sum / static_cast<double>(3 * rate_W.size());
}

Figures figuresOf(const Motion& motion, const control::Velocity& velocity, std::int64_t period_ns) {
  const arm::Preset& preset = *arm::findPreset("touch-measured");
  control::VelocityState state;
  std::vector<std::int64_t> time_ns;
  std::vector<Vec3> rate_W;
  double fastest = 0.0, fastest_true = 0.0;
  for (std::int64_t t_ns = 0; t_ns < static_cast<std::int64_t>(1e9 * motion.seconds); t_ns += period_ns) {
    control::updateRate(velocity, state, seen(preset, motion.at(t_ns).p_WT),
                        kSecondPerNanosecond * static_cast<double>(period_ns));
    if (t_ns < 200'000'000) continue;  // until it has settled
    time_ns.push_back(t_ns);
    rate_W.push_back(state.rate_W);
    fastest = std::max(fastest, state.rate_W.norm());
    fastest_true = std::max(fastest_true, motion.at(t_ns).v_WT.norm());
  }
  // Golden section over lags from -2 to 30 ms: the misfit has one minimum there.
  double low = -2e6, high = 30e6;
  const auto misfit = [&](double lag_ns) {
    return squaredMisfit(motion, time_ns, rate_W, static_cast<std::int64_t>(lag_ns));
  };
  for (int n = 0; n < 22; ++n) {
    const double a = high - 0.618034 * (high - low), b = low + 0.618034 * (high - low);
    (misfit(a) < misfit(b) ? high : low) = misfit(a) < misfit(b) ? b : a;
  }
  const double lag_ns = 0.5 * (low + high);
  double worst = 0.0;
  for (std::size_t n = 0; n < rate_W.size(); ++n) {
    worst = std::max(worst, (rate_W[n] - motion.at(time_ns[n] - static_cast<std::int64_t>(lag_ns)).v_WT).norm());
  }
  return {lag_ns * 1e-6, 1e3 * std::sqrt(misfit(lag_ns)), 1e3 * worst, 1e3 * (fastest - fastest_true)};
}

void print(std::int64_t period_ns) {
  const std::vector<Motion> all = motions();
  std::printf("\n%g kHz: delay in ms / noise in mm/s (worst)\n\n| filter |", 1e6 / static_cast<double>(period_ns));
  for (const Motion& motion : all) std::printf(" %s |", motion.name);
  std::printf(" overshoot of the stroke, mm/s |\n|---|");
  for (std::size_t n = 0; n <= all.size(); ++n) std::printf("---|");
  std::printf("\n");
  for (const Named& filter : filters()) {
    std::printf("| %s |", filter.name);
    Figures last{};
    for (const Motion& motion : all) {
      last = figuresOf(motion, filter.velocity, period_ns);
      // A steady motion fits at every lag.
      if (std::string(motion.name) == "5 mm/s") {
        std::printf(" %.1f (%.0f) |", last.noise_mm_per_s, last.worst_mm_per_s);
      } else {
        std::printf(" %.2f / %.1f (%.0f) |", last.delay_ms, last.noise_mm_per_s, last.worst_mm_per_s);
      }
    }
    std::printf(" %.0f |\n", last.overshoot_mm_per_s);
  }
}

}  // namespace
}  // namespace underact

int main() {
  underact::print(1'000'000);
  underact::print(250'000);
  return 0;
}
