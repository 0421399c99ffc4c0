#include "core/tradeoff/choices.h"

#include <array>

#include "core/json/json.h"
#include "core/scene/scene_arm.h"
#include "core/tradeoff/measures.h"

namespace underact::tradeoff {
namespace {

bool always(const scene::Description&) {
  return true;
}

bool solvesInTick(const scene::Description& scene) {
  return arm::solvesInTick(scene::armOf(scene).geometry);
}

/// Whether a law damps in Cartesian space: one in joint space has joint rates, for which there is no reference here.
bool dampsInPlace(const scene::Description& scene) {
  for (std::size_t index = 0; index < scene.constraints.size(); ++index) {
    const scene::Control& control = controlOf(scene, index);
    if (control.law != scene::LawType::P && control.space == tick::Space::Cartesian) return true;
  }
  return false;
}

std::string milliseconds(double seconds) {
  return json::numberText(1e3 * seconds) + " ms";
}

std::vector<Option> rates() {
  std::vector<Option> options;
  for (const int rate_hz : {250, 500, 1000, 2000, 4000, 8000})
    options.push_back({std::to_string(rate_hz) + " Hz", [=](Settings& s) { s.rate_hz = rate_hz; }});
  return options;
}

std::vector<Option> simulations() {
  std::vector<Option> options;
  const auto add = [&](const char* name, Integrator integrator, std::initializer_list<double> substeps_us) {
    for (const double us : substeps_us) {
      options.push_back({std::string(name) + ", " + json::numberText(us) + " us", [=](Settings& s) {
                           s.simulation = {integrator, us};
                         }});
    }
  };
  add("end velocity", Integrator::EndVelocity, {1000.0, 200.0, 50.0, 10.0});
  add("mean velocity", Integrator::MeanVelocity, {1000.0, 200.0, 50.0, 10.0});
  add("trapezoidal", Integrator::Trapezoidal, {1000.0, 500.0, 200.0, 50.0, 10.0});
  return options;
}

std::vector<Option> searches() {
  const auto by = [](const char* name, Search search) { return Option{name, [=](Settings& s) { s.search = search; }}; };
  return {by("local", Search::Local), by("hybrid", Search::Hybrid), by("global", Search::Global)};
}

std::vector<Option> solvers() {
  const auto by = [](const char* name, scene::SolverMethod method) {
    return Option{name, [=](Settings& s) { s.solver.method = method; }};
  };
  return {by("closed form", scene::SolverMethod::ClosedForm), by("iterative", scene::SolverMethod::Iterative)};
}

std::vector<Option> steps() {
  std::vector<Option> options;
  for (const int max : {1, 2, 3, 5, 10, 20, 50}) {
    options.push_back({std::to_string(max), [=](Settings& s) {
                         s.solver.method = scene::SolverMethod::Iterative;
                         s.solver.max_steps = max;
                       }});
  }
  return options;
}

std::vector<Option> inverses() {
  std::vector<Option> options{{"closed form", [](Settings& s) { s.inverse_steps = 0; }}};
  for (const int max : {1, 2, 3, 5, 60})
    options.push_back({"iterative, " + std::to_string(max), [=](Settings& s) { s.inverse_steps = max; }});
  return options;
}

std::vector<Option> filters() {
  const auto by = [](const char* name, scene::Velocity velocity) {
    return Option{name, [=](Settings& s) { s.velocity = velocity; }};
  };
  return {by("raw", scene::RawFilter{}),
          by("low-pass, 0.8 ms", scene::LowPassFilter{0.8}),
          by("low-pass, 1.6 ms", scene::LowPassFilter{1.6}),
          by("low-pass, 5 ms", scene::LowPassFilter{5.0}),
          by("window, 4", scene::AdaptiveWindowFilter{4.0, 0.11}),
          by("window, 8", scene::AdaptiveWindowFilter{8.0, 0.11}),
          by("window, 16", scene::AdaptiveWindowFilter{16.0, 0.11}),
          by("Kalman, 3 m/s^2", scene::KalmanFilter{0.016, 3000.0}),
          by("Kalman, 8 m/s^2", scene::KalmanFilter{0.016, 8000.0}),
          by("Kalman, 20 m/s^2", scene::KalmanFilter{0.016, 20'000.0})};
}

std::vector<Option> blocks() {
  std::vector<Option> options;
  for (const double block_s : {0.01, 0.02, 0.05, 0.1, 0.2, 0.5})
    options.push_back({milliseconds(block_s), [=](Settings& s) { s.block_s = block_s; }});
  return options;
}

/// Whether two settings are equal in one field.
template <auto kField>
bool alike(const Settings& a, const Settings& b) {
  return a.*kField == b.*kField;
}

bool sameMethod(const Settings& a, const Settings& b) {
  const auto iterates = [](const Settings& s) { return s.solver.method == scene::SolverMethod::Iterative; };
  return iterates(a) == iterates(b);  // auto is the closed form if there is one
}

bool sameSteps(const Settings& a, const Settings& b) {
  return a.solver.max_steps == b.solver.max_steps;
}

}  // namespace

std::span<const Choice> choices() {
  static const std::array<Choice, 8> kChoices{{
      {"rate", "How often does the servo tick?", "the servo's tick",
       "the path of the tip, compared with a run at 16 kHz", "mm", 0.11, "two encoder steps", rates(), always,
       alike<&Settings::rate_hz>, rateOn},
      {"simulation", "How is the simulated arm integrated?", "the arm's period",
       "the path of the tip, compared with the trapezoidal rule in steps of 5 us", "mm", 0.00275,
       "a twentieth of an encoder step", simulations(), always, alike<&Settings::simulation>, simulationOn},
      {"search", "How is the nearest point of a mesh or a curve found?", "the servo's tick",
       "how much farther away than the nearest point of all", "mm", 1e-9, "the nearest is what a scene promises",
       searches(), hasSearch, alike<&Settings::search>, searchOn},
      {"solver", "Are a robot's joints found in closed form?", "the servo's tick",
       "the target, compared with 100 steps to 1e-14", "mm", 1e-3, "a fiftieth of an encoder step", solvers(),
       hasSolver, sameMethod, solverOn},
      {"steps", "How many steps may the solver take in a tick?", "the servo's tick",
       "the target, compared with 100 steps to 1e-14", "mm", 1e-3, "a fiftieth of an encoder step", steps(), hasSolver,
       sameSteps, solverOn},
      {"velocity", "How is the rate of the error found?", "the servo's tick",
       "the rate, compared with exact angles 10 us before and after", "mm/s", 25.0,
       "unfiltered, one encoder step is 55 mm/s", filters(), dampsInPlace, alike<&Settings::velocity>, velocityOn},
      {"inverse", "How are the arm's own joints found for a pose?", "one pose, starting from the last joint angles",
       "the position of the tip", "mm", 1e-9, "a thousand times the rounding error of the closed form", inverses(),
       solvesInTick, alike<&Settings::inverse_steps>, inverseOn},
      {"blocks", "How much of a recording is written at a time?", "a row of the recording",
       "what is lost at most if the process is killed, apart from the 0.02 s between two reads of the recorder", "s",
       0.125, "0.25 s is promised, and a busy machine may delay the writer by as much again", blocks(), always,
       alike<&Settings::block_s>, blocksOn},
  }};
  return kChoices;
}

std::optional<std::size_t> optionOf(const Choice& choice, const Settings& settings) {
  for (std::size_t index = 0; index < choice.options.size(); ++index) {
    Settings chosen = settings;
    choice.options[index].choose(chosen);
    if (choice.same(chosen, settings)) return index;
  }
  return std::nullopt;
}

}  // namespace underact::tradeoff
