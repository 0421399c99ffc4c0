#include "core/tradeoff/duration.h"

#include <algorithm>

#include "core/tradeoff/front.h"
#include "core/tradeoff/measures.h"

namespace underact::tradeoff {
namespace {

// A period of the simulated arm with the hand and two readings of the clock, and a substep of it: from lab trade's
// front of 05_circle, 373 us for 1000 periods of one substep with a tick of 275 ns, and 23 ns for each further substep.
constexpr double kArmPeriod_ns = 300.0, kArmSubstep_ns = 23.0;
// Measured for each choice on six scenes: the joints for a position of the hand; what a walk stores for a tick; the
// joints for a pose, most of them by iteration; a block of a recording, and a row in it.
constexpr double kJoints_ns = 400.0, kKept_ns = 150.0, kPose_ns = 1000.0, kBlock_ns = 160'000.0, kRow_ns = 400.0;

/// The duration of a second of one run.
double runOf_ns(const Settings& settings, double tick_ns) {
  const double substeps = std::max(1.0, 1e6 / settings.rate_hz / settings.simulation.substep_us);
  return settings.rate_hz * (tick_ns + kArmPeriod_ns + kArmSubstep_ns * substeps);
}

/// The duration of the blocks for a run of so many seconds, per second.
double blocksOf_ns(const Settings& settings, double seconds) {
  const double blocks = std::max(kFewestBlocks / seconds, 1.0 / settings.block_s);
  return blocks * (kBlock_ns + kRow_ns * settings.block_s * settings.rate_hz);
}

/// The duration of the reference for all options, per second.
double oracleOf_ns(const Choice& choice, Settings base, double tick_ns) {
  if (choice.measureOn == inverseOn) return base.rate_hz * kJoints_ns;
  if (choice.measureOn == blocksOn) return 0.0;
  if (choice.measureOn == rateOn) base.rate_hz = kOracleRate_hz;
  if (choice.measureOn == simulationOn) base.simulation.substep_us = kOracleSubstep_us;
  if (choice.measureOn == rateOn || choice.measureOn == simulationOn) return runOf_ns(base, tick_ns);
  const double walks = choice.measureOn == velocityOn ? 2.0 : 1.0;  // before and after each tick
  return base.rate_hz * (walks * (tick_ns + kKept_ns) + (1.0 + walks) * kJoints_ns);
}

double optionOf_ns(const Choice& choice, const Settings& settings, double seconds, double tick_ns) {
  if (choice.measureOn == inverseOn) return settings.rate_hz * kPose_ns;
  if (choice.measureOn == blocksOn) return blocksOf_ns(settings, seconds);
  if (choice.measureOn == rateOn || choice.measureOn == simulationOn) return runOf_ns(settings, tick_ns);
  return settings.rate_hz * (tick_ns + kKept_ns);
}

}  // namespace

double secondsToMeasure(const scene::Description& scene, std::size_t hands, double seconds, int rate_hz,
                        double tick_ns) {
  const Settings base = settingsOf(scene, rate_hz);
  Settings finest = base;
  finest.rate_hz = kOracleRate_hz;
  finest.simulation.substep_us = scene::kShortestSubstep_us;
  double work_ns = runOf_ns(finest, tick_ns);
  for (const Settings& candidate : settingsToTry(scene, rate_hz)) work_ns += runOf_ns(candidate, tick_ns);
  for (const Choice& choice : choices()) {
    if (!choice.applies(scene)) continue;
    work_ns += oracleOf_ns(choice, base, tick_ns);
    for (const Option& option : choice.options) {
      Settings settings = base;
      option.choose(settings);
      work_ns += optionOf_ns(choice, settings, seconds, tick_ns);
    }
  }
  return 1e-9 * seconds * static_cast<double>(hands) * work_ns;
}

}  // namespace underact::tradeoff
