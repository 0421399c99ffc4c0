#include "device/measure_simulated.h"

#include <algorithm>
#include <random>
#include <utility>

#include "core/base/translate.h"
#include "core/servo/host.h"
#include "device/simulated_person.h"

namespace underact::device {
namespace {

using identify::Measurement;

constexpr int kLooksASecond = 100;  // polls for the next scene: the window's frames are no faster
// A substep ends with the tip at rest where it reverses, up to 0.2 ms early with the usual ones: 0.15 % of the
// friction.
constexpr std::int64_t kSubstep_ns = 5'000;
constexpr double kScatter_m = 3e-3;  // of the tip's first rest position, per axis

Vec3 scattered(const Vec3& p_WT, std::uint64_t seed) {
  std::mt19937_64 random(seed);
  const auto next = [&random] { return 0x1p-53 * static_cast<double>(random() >> 11U) - 0.5; };
  const double x = next(), y = next(), z = next();
  return p_WT + 2.0 * kScatter_m * Vec3(x, y, z);
}

}  // namespace

Result<SimulatedMeasurement> measureSimulated(SimulatedArm::Options options, const identify::Wanted& wanted,
                                              std::uint64_t seed, const std::function<bool(double share)>& progress) {
  Result<identify::Plan> plan = makePlan(wanted);
  if (!plan) return plan.problems();
  options.start_p_WT = scattered(wanted.places_W.front(), seed);
  options.integration.substep_ns = kSubstep_ns;
  auto made = std::make_unique<SimulatedArm>(options);
  SimulatedArm& arm = *made;
  servo::Host host(std::move(made), {.rate_hz = options.rate_hz, .clock = servo::Clock::Manual});
  SimulatedPerson person(arm, options.arm);
  Measurement measurement(plan.value(), [&host](const scene::Description& scene) -> Result<std::uint64_t> {
    const Problems problems = host.edit(scene);
    if (!problems.empty()) return problems;
    return host.revision();
  });
  host.start();
  arm::JointAngles q_rad{};
  while (measurement.state() != Measurement::State::Done) {
    person.act(measurement, q_rad);
    Problems problems = measurement.go();
    host.run(std::max(1, options.rate_hz / kLooksASecond));
    host.drain([&](const servo::TickRecord& record) {
      q_rad = record.q_rad;
      measurement.add(record);
    });
    if (problems.empty()) problems = measurement.advance();
    if (!problems.empty()) return problems;
    if (host.snapshot().mode == servo::Mode::Faulted)
      return SimulatedMeasurement{std::move(plan).value(), {}, host.snapshot().report.fault};
    if (progress && !progress(measurement.share()))
      return Problems{{phrase(TRANSLATE_NOOP("problem", "The measurement was cancelled."))}};
  }
  return SimulatedMeasurement{std::move(plan).value(), measurement.recorded(), {}};
}

}  // namespace underact::device
