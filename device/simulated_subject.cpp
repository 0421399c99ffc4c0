#include "device/simulated_subject.h"

#include <cmath>

#include "core/arm/preset.h"
#include "core/base/random.h"
#include "core/base/translate.h"
#include "core/base/units.h"
#include "core/scene/scene_arm.h"
#include "core/servo/host.h"
#include "device/simulated_arm.h"

namespace underact::device {
namespace {

constexpr double kDepth_m = 0.005;  // beyond it the tip's arc leaves the straight line by more than is felt here
constexpr double kPressed_s = 0.6;
constexpr std::int64_t kSettled = 500, kTicks = 1200;  // first the force ramps up

/// Down by kDepth_m from the beam's rest position.
sim::HandScript pressOn(const Vec3& p_WT) {
  sim::HandScript script;
  script.path = {{0.0, p_WT}, {1e-3 * static_cast<double>(kSettled), p_WT}};
  script.path.push_back({script.path.back().t_s + kPressed_s, p_WT - kDepth_m * Vec3::UnitY()});
  return script;
}

double gaussian(std::uint64_t& random) {  // Box and Muller 1958
  const double radius = std::sqrt(-2.0 * std::log(1.0 - nextShare(random)));
  return radius * std::cos(2.0 * kPi * nextShare(random));
}

}  // namespace

Result<double> pressedStiffness(const scene::Description& scene, calibration::Beam beam) {
  SimulatedArm::Options options;
  options.arm = scene::armOf(scene);
  auto arm = std::make_unique<SimulatedArm>(options);
  const Vec3 p_WT = calibration::tipOf(scene, beam);
  arm->follow(pressOn(p_WT));
  servo::Host host(std::move(arm), {1000, servo::Clock::Manual});
  const Problems problems = host.load(scene);
  if (!problems.empty()) return problems;
  host.start();
  host.run(kTicks);
  // The slope of the regression line through all (displacement, force), with an offset because of the arm's friction.
  double count = 0.0, travel = 0.0, force = 0.0, squares = 0.0, both = 0.0;
  host.drain([&](const servo::TickRecord& record) {
    if (record.tick < kSettled) return;
    const double travel_m = p_WT.y() - record.p_WT.y(), up_N = record.f_sent_T_W.y();
    count += 1.0, travel += travel_m, force += up_N, squares += travel_m * travel_m, both += travel_m * up_N;
  });
  const double spread = count * squares - travel * travel;
  if (!(spread > 0.0))
    return Problems{{phrase(TRANSLATE_NOOP("problem", "The simulated hand could not press the beam.")), {}}};
  return (count * both - travel * force) / spread / kNewtonPerMetre;
}

Result<calibration::Beam> answerOf(SimulatedSubject& subject, const scene::Description& scene) {
  double felt_N_per_mm[2] = {0.0, 0.0};
  for (const calibration::Beam beam : {calibration::Beam::Left, calibration::Beam::Right}) {
    const Result<double> pressed = pressedStiffness(scene, beam);
    if (!pressed) return pressed.problems();
    felt_N_per_mm[static_cast<std::size_t>(beam)] =
        pressed.value() * std::exp(subject.weber * gaussian(subject.random));
  }
  return felt_N_per_mm[0] > felt_N_per_mm[1] ? calibration::Beam::Left : calibration::Beam::Right;
}

}  // namespace underact::device
