#include <algorithm>
#include <cmath>
#include <memory>
#include <ostream>

#include "app/cli/arm_choice.h"
#include "app/cli/command.h"
#include "app/cli/scene_file.h"
#include "app/cli/setting_overrides.h"
#include "app/cli/step_report.h"
#include "core/base/printed.h"
#include "core/base/units.h"
#include "core/json/json.h"
#include "core/scene/settings.h"
#include "core/sim/arm_model_file.h"

namespace underact::cli {
namespace {

constexpr double kLongestStep_s = 100.0;  // of the arm: each tick is a row of the table, and a sample of the fit

struct StepOptions {
  std::vector<double> num{1.0}, den;
  std::string scene, constraint, axis, law, csv;
  std::vector<double> from_mm;
  double step_mm = 10.0, seconds = 0.0;
  double kp_N_per_mm = -1.0, kd_N_s_per_mm = -1.0, ki_N_per_mm_s = -1.0;  // below 0: the scene's
  double mass_kg = 0.0, damping_N_s_per_m = 0.0;                          // that remain on the stylus
  int rate_hz = 1000;
  bool no_limits = false, json = false;
  std::string arm_model{sim::kDefaultArmModel};
};

/// Writes the table of a curve if requested. Exit: Well, or File.
Exit writeTable(const std::string& path, const std::string& text, const Streams& streams) {
  if (path.empty()) return Exit::Success;
  const Problems problems = writeText(path, text);
  print(problems, streams.err);
  return problems.empty() ? Exit::Success : Exit::File;
}

Exit stepFunction(const StepOptions& options, const Streams& streams) {
  const Result<lab::TransferFunction> transfer = lab::makeTransferFunction(options.num, options.den);
  if (!transfer) return fail(transfer.problems(), Exit::Usage, streams);
  const lab::StepMetrics metrics = lab::metricsOf(transfer.value());
  if (options.json)
    streams.out << metricsObject(metrics).text() << '\n';
  else
    printStep(transfer.value(), metrics, streams.out);
  const std::string note = noteOn(transfer.value());
  if (!note.empty()) streams.err << printed(note) << '\n';
  return writeTable(options.csv, csvOf(transfer.value(), options.seconds), streams);
}

/// The scene with the control law and the gains of the command line instead of its own.
Result<scene::Description> retuned(const scene::Description& scene, const StepOptions& options) {
  std::vector<std::string> overrides;
  const auto add = [&overrides](const char* key, double number) {
    if (number >= 0.0) overrides.push_back(std::string(key) + "=" + json::numberText(number));
  };
  if (!options.law.empty()) overrides.push_back("law=" + options.law);
  add("kp_N_per_mm", options.kp_N_per_mm);
  add("kd_N_s_per_mm", options.kd_N_s_per_mm);
  add("ki_N_per_mm_s", options.ki_N_per_mm_s);
  return withOverrides(scene, overrides);
}

lab::StepSetup setupOf(const StepOptions& options, const sim::ArmModel& model) {
  lab::StepSetup setup;
  setup.step_m = kMetrePerMillimetre * options.step_mm;
  for (const lab::Axis axis : {lab::Axis::X, lab::Axis::Y, lab::Axis::Z, lab::Axis::Held}) {
    if (options.axis == name(axis)) setup.axis = axis;
  }
  setup.constraint = options.constraint;
  if (!options.from_mm.empty()) setup.from_W = kMetrePerMillimetre * Eigen::Map<const Vec3>(options.from_mm.data());
  setup.arm = model;
  setup.hand = {options.mass_kg, options.damping_N_s_per_m, 0.0};
  setup.rate_hz = options.rate_hz;
  setup.seconds = options.seconds;
  setup.limits = !options.no_limits;
  return setup;
}

Exit stepArm(const StepOptions& options, const Streams& streams) {
  if (options.seconds > kLongestStep_s) {
    streams.err << "--seconds: at most 100 s of the simulated arm are measured.\n";
    return Exit::Usage;
  }
  const Result<LoadedScene> loaded = loadScene(options.scene, streams);
  if (!loaded) return fail(loaded.problems(), streams);
  const Result<sim::ArmModel> model = sim::chooseArmModel(options.arm_model);
  if (!model) return fail(model.problems(), streams);
  const Result<scene::Description> scene = retuned(loaded.value().description, options);
  if (!scene) return fail(scene.problems(), streams);
  const Result<lab::ArmStep> step = lab::measureStep(scene.value(), setupOf(options, model.value()));
  if (!step) return fail(step.problems(), Exit::BadInput, streams);
  if (options.json)
    streams.out << stepObject(step.value()).text() << '\n';
  else
    printStep(step.value(), streams.out);
  for (const std::string& note : notesOn(step.value())) streams.err << printed(note) << '\n';
  const Exit written = writeTable(options.csv, csvOf(step.value()), streams);
  return step.value().fault.empty() ? written : Exit::Fault;
}

/// --scene and the options that belong to it.
Option addArmOptions(Command command, StepOptions& options) {
  const char* const kGroup = "The simulated arm";
  const Option scene = command.option("--scene", options.scene, "Measure the simulated arm in this scene");
  const auto add = [&](const char* name, auto& value, const char* what) {
    return command.option(name, value, what).needs(scene).group(kGroup);
  };
  scene.group(kGroup);
  add("--step_mm", options.step_mm, "Size of the step, mm, of either sign")
      .showDefault()
      .check([](const std::string& text) {
        const std::optional<double> step_mm = options::numberOf(text);
        const bool good = step_mm && std::abs(*step_mm) >= 0.01 && std::abs(*step_mm) <= 500.0;
        return std::string(good ? "" : "must be a length of 0.01 to 500 mm, of either sign");
      });
  add("--axis", options.axis,
      "Axis of the step, or the direction in which the constraint pulls; by default the first that holds")
      .oneOf({"x", "y", "z", "held"});
  add("--constraint", options.constraint, "Name of the constraint, if there are several");
  add("--from_mm", options.from_mm, "The tip first rests at the target nearest to this position (0,0,60)")
      .withCommas()
      .expected(3, 3)
      .range(-1e6, 1e6);
  add("--law", options.law, "Instead of the scene's").oneOf(scene::findSetting("/control/law")->words());
  add("--kp_N_per_mm", options.kp_N_per_mm, "Instead of the scene's").range(0.0, 1e9);
  add("--kd_N_s_per_mm", options.kd_N_s_per_mm, "Instead of the scene's").range(0.0, 1e9);
  add("--ki_N_per_mm_s", options.ki_N_per_mm_s, "Instead of the scene's").range(0.0, 1e9);
  add("--mass_kg", options.mass_kg, "Mass that remains on the stylus after the hand has released it, kg")
      .showDefault()
      .range(0.0, 100.0);
  add("--damping_N_s_per_m", options.damping_N_s_per_m, "Damping that remains on the stylus, N s/m")
      .showDefault()
      .range(0.0, 1e4);
  add("--rate", options.rate_hz, "Ticks per second").showDefault().range(100, 10000);
  command.flag("--no-limits", options.no_limits, "Measure the control law alone, without the limits of the safety gate")
      .needs(scene)
      .group(kGroup);
  addArmModelOption(command, options.arm_model);
  return scene;
}

}  // namespace

void addLabStep(Command lab, const Streams& streams, Exit& exit) {
  const Command command = lab.add("step", "Step response of a transfer function, or of the simulated arm");
  const auto options = std::make_shared<StepOptions>();
  const Option num =
      command.option("--num", options->num, "Numerator: coefficients of descending powers of s").withCommas();
  const Option den = command.option("--den", options->den, "Denominator, likewise; order 1 to 8").withCommas();
  num.needs(den);
  const Option scene = addArmOptions(command, *options);
  scene.excludes(den);
  command.option("--seconds", options->seconds, "Duration, s; by default until the response has settled")
      .range(1e-6, 1e6);
  command.option("--csv", options->csv,
                 "Write the curve to this file: t_s, y; for the arm t_s, measured_mm, fit_mm, analytic_mm");
  command.flag("--json", options->json, "One JSON object instead of a table");
  command.footer(
      "One of --den and --scene is required.\n"
      "--json, for a function: {\"final_value\", \"rise_10_90_s\", \"settling_2pct_s\" (null: never), \"peak_time_s\" "
      "(null: no overshoot),\n"
      "\"overshoot_fraction\"}; null if there is none. Write 0 for a missing power of s: s^2 + 1 is 1,0,1.");
  command.whenChosen([den, scene, options, &streams, &exit] {
    if (!den.isGiven() && !scene.isGiven())
      options::refuse("--den (as in --num 1 --den 1,0.8,1) or --scene is required");
    exit = den.isGiven() ? stepFunction(*options, streams) : stepArm(*options, streams);
  });
}

}  // namespace underact::cli
