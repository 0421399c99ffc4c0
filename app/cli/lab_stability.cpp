#include <algorithm>
#include <cmath>
#include <filesystem>
#include <memory>
#include <ostream>

#include "app/cli/command.h"
#include "app/cli/json_object.h"
#include "app/cli/lab_folder.h"
#include "app/cli/progress.h"
#include "app/cli/scene_file.h"
#include "app/cli/shipped.h"
#include "app/cli/table.h"
#include "core/base/units.h"
#include "core/stability/exact.h"
#include "core/stability/maps.h"
#include "core/system/signals.h"

namespace underact::cli {
namespace {

using stability::SampledWall;

const std::vector<std::string> kFilters{"raw", "low_pass", "kalman", "adaptive_window"};

constexpr double kSoft_N_per_m = 20.0;  // of a trial that shows whether anything holds the tip

struct StabilityOptions {
  SampledWall wall;  // of one cell
  bool one_cell = false;
  int rate_hz = 1000;
  std::string filter = "raw";
  double filter_s = control::LowPass{}.time_constant_s;
  double stiffness_N_per_m = 0.0;  // above 0: label it

  std::vector<std::string> maps;
  std::vector<std::string> scenes;
  bool labels = false, json = false;
  std::string out;  // folder; empty: the tables on stdout
};

control::Velocity filterNamed(const std::string& name, double time_constant_s) {
  if (name == "low_pass") return control::LowPass{time_constant_s};
  if (name == "kalman") return stability::defaultKalman();
  const scene::AdaptiveWindowFilter default_value;
  if (name == "adaptive_window")
    return control::AdaptiveWindow{static_cast<int>(default_value.window),
                                   Vec3::Constant(kMetrePerMillimetre * default_value.noise_mm)};
  return control::RawDifference{};
}

Exit oneCell(const StabilityOptions& options, const Streams& streams) {
  SampledWall wall = options.wall;
  wall.period_ns = 1'000'000'000 / options.rate_hz;
  wall.velocity = filterNamed(options.filter, options.filter_s);
  const stability::Limits limits = stability::limitsOf(wall);
  JsonObject cell;
  cell.addNumber("simulated_limit_N_per_m", limits.simulated_N_per_m);
  limits.exact_N_per_m ? cell.addNumber("exact_limit_N_per_m", *limits.exact_N_per_m)
                       : cell.addNull("exact_limit_N_per_m");
  cell.addNumber("passive_limit_N_per_m", limits.passive_N_per_m);
  cell.addNumber("colgate_schenkel_N_per_m", limits.colgate_schenkel_N_per_m);
  cell.addNumber("gil_hulin_N_per_m", limits.gil_hulin_N_per_m);
  if (options.stiffness_N_per_m > 0.0) {
    const stability::Label label = stability::labelOf(wall, limits, options.stiffness_N_per_m);
    cell.addNumber("stiffness_N_per_m", options.stiffness_N_per_m);
    cell.addText("label", name(label.trial.behaviour));
    cell.addNumber("amplitude_mm", kMillimetrePerMetre * label.trial.amplitude_m);
    cell.addBool("passive", label.is_passive);
  }
  streams.out << cell.text() << '\n';
  return Exit::Success;
}

/// The tables of a run, each in a file or on stdout.
struct StabilityTables {
  Table limits{{"map", "variant", "rate_hz", "delay_ticks", "mass_kg", "damping_N_s_per_m", "hand_stiffness_N_per_m",
                "friction_N", "encoder_steps", "kd_N_s_per_m", "simulated_N_per_m", "exact_N_per_m", "passive_N_per_m",
                "colgate_schenkel_N_per_m", "gil_hulin_N_per_m"}};
  Table labels{{"map", "variant", "kd_N_s_per_m", "stiffness_N_per_m", "label", "amplitude_mm", "passive"}};
  Table scenes{{"scene", "title", "constraint", "space", "rate_hz", "kd_N_s_per_m", "simulated_N_per_m",
                "label_at_nominal", "passive_at_nominal", "least_energy_uJ"}};
  Table scene_labels{{"scene", "rate_hz", "kd_N_s_per_m", "stiffness_N_per_m", "label", "passive", "least_energy_uJ"}};
};

void addLimits(const std::string& map, const std::string& variant, const SampledWall& wall,
               const stability::Limits& limits, StabilityTables& tables) {
  const Table::Field exact = limits.exact_N_per_m ? Table::Field(*limits.exact_N_per_m) : Table::Field();
  tables.limits.add({map, variant, std::int64_t{1'000'000'000} / wall.period_ns, std::int64_t{wall.delay_ticks},
                     wall.mass_kg, wall.damping_N_s_per_m, wall.hand_stiffness_N_per_m, wall.friction_N,
                     wall.coarseness, wall.kd_N_s_per_m, limits.simulated_N_per_m, exact, limits.passive_N_per_m,
                     limits.colgate_schenkel_N_per_m, limits.gil_hulin_N_per_m});
}

void addLabel(const std::string& map, const std::string& variant, const SampledWall& wall,
              const stability::Limits& limits, double K, StabilityTables& tables) {
  const stability::Label label = stability::labelOf(wall, limits, K);
  tables.labels.add({map, variant, wall.kd_N_s_per_m, K, std::string(name(label.trial.behaviour)),
                     kMillimetrePerMetre * label.trial.amplitude_m, label.is_passive});
}

/// The steps of the work, so that the remaining time is known from the start.
using Step = std::function<Problems(StabilityTables&)>;

void addWallSteps(const stability::WallMap& map, bool labels, std::vector<Step>& steps) {
  for (const stability::Variant& variant : map.variants) {
    for (const double kd : stability::mapDampings_N_s_per_m()) {
      SampledWall wall = variant.wall;
      wall.kd_N_s_per_m = kd;
      steps.push_back([key = std::string(map.key), name = variant.name, wall, labels](StabilityTables& tables) {
        const stability::Limits limits = stability::limitsOf(wall);
        addLimits(key, name, wall, limits, tables);
        if (!labels) return Problems{};
        for (const double K : stability::mapStiffnesses_N_per_m()) addLabel(key, name, wall, limits, K, tables);
        return Problems{};
      });
    }
  }
}

/// A file's problems as the command line prints them.
Problems from(const std::string& file, Problems problems) {
  for (Problem& problem : problems) problem.place.file = file;
  return problems;
}

/// nominal: the trial at the nominal stiffness, which is one of the cells.
Problems addSceneLabels(const std::string& file, const stability::SceneWall& wall,
                        const Result<stability::SceneTrialResult>& nominal, StabilityTables& tables) {
  for (const double K : stability::sceneStiffnesses_N_per_m()) {
    const Result<stability::SceneTrialResult> trial =
        K == stability::kNominal_N_per_m ? nominal : stability::tryScene(wall, K);
    if (!trial) return from(file, trial.problems());
    tables.scene_labels.add({std::filesystem::path(file).stem().string(), std::int64_t{wall.rate_hz}, wall.kd_N_s_per_m,
                             K, std::string(name(trial.value().trial.behaviour)), trial.value().is_passive,
                             1e6 * trial.value().min_energy_J});
  }
  return {};
}

Problems addScene(const std::string& file, const stability::SceneWall& wall, bool labels, StabilityTables& tables) {
  const Result<double> limit = stability::simulatedLimit(wall);
  if (!limit) return from(file, limit.problems());
  const Result<stability::SceneTrialResult> nominal = stability::tryScene(wall, stability::kNominal_N_per_m);
  if (!nominal) return from(file, nominal.problems());
  const scene::Constraint& one = wall.scene.constraints.front();
  const bool joints = scene::controlOf(wall.scene, 0).space == tick::Space::Joint;
  tables.scenes.add({std::filesystem::path(file).stem().string(), wall.scene.title, one.name,
                     std::string(joints ? "joint" : "cartesian"), std::int64_t{wall.rate_hz}, wall.kd_N_s_per_m,
                     limit.value(), std::string(name(nominal.value().trial.behaviour)), nominal.value().is_passive,
                     1e6 * nominal.value().min_energy_J});
  return labels ? addSceneLabels(file, wall, nominal, tables) : Problems{};
}

/// Of a scene's first constraint. Scenes that cannot be measured are reported and left out.
void addSceneSteps(const std::string& file, scene::Description scene, bool labels, const Streams& streams,
                   std::vector<Step>& steps) {
  stability::SceneWall wall;
  wall.scene = std::move(scene);
  wall.constraint = wall.scene.constraints.front().name;
  const Result<stability::SceneTrialResult> soft = stability::tryScene(wall, kSoft_N_per_m);
  if (!soft) {
    print(from(file, soft.problems()), streams.err);
    return;
  }
  if (!soft.value().holds) {
    streams.err << file << ": Nothing holds the tip there, so there is no limit to find; left out.\n";
    return;
  }
  for (const int rate_hz : stability::sceneRates_hz()) {
    for (const double kd : stability::sceneDampings_N_s_per_m()) {
      wall.rate_hz = rate_hz;
      wall.kd_N_s_per_m = kd;
      steps.push_back([file, wall, labels](StabilityTables& tables) { return addScene(file, wall, labels, tables); });
    }
  }
}

bool isAsked(const StabilityOptions& options, const std::string& key) {
  return options.maps.empty() || std::find(options.maps.begin(), options.maps.end(), key) != options.maps.end();
}

/// Scenes without a formula for their limit: with a robot, or controlled in joint space.
bool hasNoFormula(const scene::Description& scene) {
  return scene::controlOf(scene, 0).space == tick::Space::Joint ||
         std::holds_alternative<scene::VirtualManipulator>(scene.constraints.front().shape);
}

Result<std::vector<Step>> stepsOf(const StabilityOptions& options, const Streams& streams) {
  std::vector<Step> steps;
  const bool labels = options.labels || !options.out.empty();
  for (const stability::WallMap& map : stability::wallMaps()) {
    if (isAsked(options, map.key)) addWallSteps(map, labels, steps);
  }
  if (!isAsked(options, "scenes") && options.scenes.empty()) return steps;
  const Result<std::vector<std::string>> files = options.scenes.empty() ? shippedScenes() : options.scenes;
  if (!files) return files.problems();
  for (const std::string& file : files.value()) {
    Result<LoadedScene> loaded = loadScene(file, streams);
    if (!loaded) return loaded.problems();
    scene::Description& scene = loaded.value().description;
    if (!options.scenes.empty() || hasNoFormula(scene)) addSceneSteps(file, std::move(scene), labels, streams, steps);
  }
  return steps;
}

void printUnlessEmpty(const Table& table, bool json, std::ostream& out) {
  if (!table.isEmpty()) json ? table.printJson(out) : table.printCsv(out);
}

Exit maps(const StabilityOptions& options, const Streams& streams) {
  const Result<std::vector<Step>> steps = stepsOf(options, streams);
  if (!steps) return fail(steps.problems(), streams);
  const system::Interrupt interrupt;
  Progress progress(streams);
  StabilityTables tables;
  for (std::size_t done = 0; done < steps.value().size(); ++done) {
    if (interrupt.came()) {
      streams.err << "Stopped before the end. Nothing is printed, because a part would look like the whole.\n";
      return Exit::BadInput;
    }
    const Problems problems = steps.value()[done](tables);
    if (!problems.empty()) return fail(problems, streams);
    progress.show(static_cast<double>(done + 1) / static_cast<double>(steps.value().size()));
  }
  if (!options.out.empty()) {
    return fillFolder(options.out, "stability",
                      {{"stability_limits.csv", &tables.limits},
                       {"stability_labels.csv", &tables.labels},
                       {"stability_scenes.csv", &tables.scenes},
                       {"stability_scene_labels.csv", &tables.scene_labels}},
                      streams);
  }
  printUnlessEmpty(tables.limits, options.json, streams.out);
  printUnlessEmpty(tables.labels, options.json, streams.out);
  printUnlessEmpty(tables.scenes, options.json, streams.out);
  printUnlessEmpty(tables.scene_labels, options.json, streams.out);
  return Exit::Success;
}

void addCellOptions(Command command, StabilityOptions& options) {
  SampledWall& wall = options.wall;
  const auto cell = [&](const char* name, auto& number, const char* what, double min, double max) {
    const Option option = command.option(name, number, what).range(min, max);
    option.group("One wall");
    option.whenGiven([&options] { options.one_cell = true; });
    return option.showDefault();
  };
  cell("--mass_kg", wall.mass_kg, "Mass of arm and hand, kg", 1e-6, 1e3);
  cell("--damping_N_s_per_m", wall.damping_N_s_per_m, "Damping of arm and hand, N s/m", 0.0, 1e4);
  cell("--kd_N_s_per_m", wall.kd_N_s_per_m, "Damping of the wall, N s/m", 0.0, 1e4);
  cell("--rate_hz", options.rate_hz, "Samples per second", 1, 100'000);
  cell("--delay_ticks", wall.delay_ticks, "Periods between a sample and its force", 0, stability::kMaxDelay);
  cell("--hand_stiffness_N_per_m", wall.hand_stiffness_N_per_m, "Stiffness of the hand, N/m", 0.0, 1e6);
  cell("--friction_N", wall.friction_N, "Coulomb friction of the arm, N", 0.0, 1e3);
  cell("--encoder_steps", wall.coarseness, "1: angles in the arm's own encoder steps, 2: twice as coarse, 0: exact",
       0.0, 1e3);
  cell("--stiffness_N_per_m", options.stiffness_N_per_m, "Also report how a wall of this stiffness behaves, N/m", 0.0,
       1e7);
  command.option("--filter", options.filter, "Velocity filter of the wall")
      .group("One wall")
      .whenGiven([&options] { options.one_cell = true; })
      .oneOf(kFilters)
      .showDefault();
  cell("--filter_s", options.filter_s, "Time constant of the filter low_pass, s", 1e-6, 1e3);
}

}  // namespace

void addLabStability(Command lab, const Streams& streams, Exit& exit) {
  auto options = std::make_shared<StabilityOptions>();
  const Command command = lab.add("stability",
                                  "How stiff a wall can be before it buzzes: one wall, or maps over rate, delay, hand, "
                                  "filter, encoders, friction and the scenes for which there is no formula");
  addCellOptions(command, *options);
  std::vector<std::string> keys{"scenes"};
  for (const stability::WallMap& map : stability::wallMaps()) keys.emplace_back(map.key);
  command.option("--map", options->maps, "Maps, separated by commas; by default all").withCommas().oneOf(keys);
  command.option("--scenes", options->scenes, "Scene files, instead of those that ship");
  command.flag("--labels", options->labels,
               "Also report for each cell how a push develops, and whether the cell is passive");
  command.option("--out", options->out, "Folder for the tables as CSV, including the labels, and their pictures");
  command.flag("--json", options->json, "One JSON object per row instead of CSV");
  command.footer(
      "One wall: a JSON object. \"simulated_limit_N_per_m\" is found by bisection in the simulated loop, "
      "\"exact_limit_N_per_m\" by the\n"
      "eigenvalues of the loop (null: friction, encoder steps or a nonlinear filter); then the limit that is passive "
      "for any hand, and two formulas.");
  command.whenChosen(
      [options, &streams, &exit] { exit = options->one_cell ? oneCell(*options, streams) : maps(*options, streams); });
}

}  // namespace underact::cli
