#include "app/cli/hands.h"

#include <algorithm>
#include <cmath>
#include <memory>
#include <optional>
#include <utility>

#include "app/sweeper/catalogue.h"
#include "app/sweeper/command_words.h"
#include "core/arm/preset.h"
#include "core/base/fault.h"
#include "core/base/random.h"
#include "core/base/units.h"
#include "core/json/text.h"
#include "core/mesh/surface.h"
#include "core/record/tick_figures.h"
#include "core/scene/load_meshes.h"
#include "core/scene/read.h"
#include "core/scene/scene_arm.h"
#include "core/servo/host.h"
#include "core/sim/arm_model.h"
#include "core/sweep/build.h"
#include "device/simulated_arm.h"

namespace underact::sweep {
namespace hands_kind {

constexpr std::int64_t kTicksAtOnce = 1000;  // far fewer than the servo keeps for us
constexpr double kLongest_s = 1e5;
constexpr std::int64_t kMaxDraws = 10'000'000;
constexpr std::size_t kLargestFile = std::size_t{1} << 30U;  // larger than any scene, hand or curve

/// All that the cells share. A hand is made with the cell's seed, so only its name, or its file's content, is kept.
struct Plan {
  std::vector<scene::Description> scenes;  // loaded
  std::vector<std::string> scene_names, hand_names;
  std::vector<sim::HandScript> hands;  // their tremor's seed is set by the cell
  std::vector<int> rates_hz;
  std::size_t draws = 0;
  double seconds = 0.0;
  Range mass_kg, damping_N_s_per_m, stiffness_N_per_m;
  sim::ArmModel arm_model;
};

/// The indices of a cell; draws are adjacent.
struct Where {
  std::size_t scene, hand, rate, draw;
};

Where whereIs(const Plan& plan, std::size_t index) {
  const std::size_t draw = index % plan.draws, rate = index / plan.draws;
  const std::size_t hand = rate / plan.rates_hz.size(), scene = hand / plan.hands.size();
  return {scene, hand % plan.hands.size(), rate % plan.rates_hz.size(), draw};
}

/// The results of a run on the simulated arm.
struct Figures {
  record::TickFigures ticks;
  record::Work work;
  record::StoredEnergy energy;
  std::int64_t clamped = 0, faults = 0;
  FaultKind first_fault = FaultKind::None, last_fault = FaultKind::None;

  void add(const servo::TickRecord& record) {
    const double force_N = record.f_sent_T_W.norm();
    ticks.add(record.error_m, force_N);
    work.add(record.f_sent_T_W, record.p_WT);
    energy.add(record.energy_J);
    if ((record.limits & safety::kClampBit) != 0U) ++clamped;
    if (record.fault != last_fault && record.fault != FaultKind::None) {
      if (faults++ == 0) first_fault = record.fault;
    }
    last_fault = record.fault;
  }
};

/// The run of `underact-cli run --fast`. Problems: those of loading the scene.
Result<Figures> figuresOf(const Plan& plan, const scene::Description& scene, const sim::HandScript& hand, int rate_hz) {
  device::SimulatedArm::Options options;
  options.arm = scene::armOf(scene);
  options.model = plan.arm_model;
  options.hand = hand.hand;
  options.rate_hz = rate_hz;
  options.integration = integrationOf(scene.simulation);
  auto arm = std::make_unique<device::SimulatedArm>(options);
  arm->follow(hand);
  servo::Host host(std::move(arm), {.rate_hz = rate_hz, .clock = servo::Clock::Manual});
  const Problems problems = host.load(scene);
  if (!problems.empty()) return problems;
  host.start();
  Figures figures;
  const std::int64_t ticks = std::max<std::int64_t>(1, std::llround(plan.seconds * rate_hz));
  while (figures.ticks.ticks() < ticks) {
    host.run(std::min(kTicksAtOnce, ticks - figures.ticks.ticks()));
    host.drain([&figures](const servo::TickRecord& record) { figures.add(record); });
    while (host.takeFault()) {  // so that the servo has room for the next one
    }
  }
  return figures;
}

const std::vector<std::string> kColumns{"scene",
                                        "hand",
                                        "rate_hz",
                                        "draw",
                                        "mass_kg",
                                        "damping_N_s_per_m",
                                        "stiffness_N_per_m",
                                        "ticks",
                                        "peak_force_N",
                                        "rms_force_N",
                                        "rms_error_mm",
                                        "clamped_ticks",
                                        "faults",
                                        "first_fault",
                                        "work_mJ",
                                        "most_work_mJ",
                                        "energy_mJ",
                                        "lowest_energy_mJ"};

/// The hand of a cell with that seed.
sim::HandModel drawnHand(const Plan& plan, std::uint64_t seed) {
  sim::HandModel hand;
  std::uint64_t state = seed;
  hand.mass_kg = plan.mass_kg.at(nextShare(state));
  hand.damping_N_s_per_m = plan.damping_N_s_per_m.at(nextShare(state));
  hand.stiffness_N_per_m = plan.stiffness_N_per_m.at(nextShare(state));
  return hand;
}

std::string commandOf(const Plan& plan, std::size_t index, std::uint64_t seed) {
  const Where at = whereIs(plan, index);
  const sim::HandModel hand = drawnHand(plan, seed);
  return CommandWords("underact-cli run")
      .add(plan.scene_names[at.scene])
      .add("--hand", plan.hand_names[at.hand])
      .add("--mass_kg", hand.mass_kg)
      .add("--damping_N_s_per_m", hand.damping_N_s_per_m)
      .add("--stiffness_N_per_m", hand.stiffness_N_per_m)
      .add("--rate", plan.rates_hz[at.rate])
      .add("--seconds", plan.seconds)
      .add("--seed", seed)
      .add("--arm-model", plan.arm_model.name)
      .add("--fast")
      .text();
}

Result<SweepRow> runCell(const Plan& plan, std::size_t index, std::uint64_t seed) {
  const Where at = whereIs(plan, index);
  sim::HandScript hand = plan.hands[at.hand];
  hand.seed = seed;
  hand.hand = drawnHand(plan, seed);
  const int rate_hz = plan.rates_hz[at.rate];
  const Result<Figures> result = figuresOf(plan, plan.scenes[at.scene], hand, rate_hz);
  if (!result) return result.problems();
  const Figures& figures = result.value();
  SweepRow row;
  row.add(plan.scene_names[at.scene]);
  row.add(plan.hand_names[at.hand]);
  row.add(rate_hz);
  row.add(at.draw);
  row.add(hand.hand.mass_kg);
  row.add(hand.hand.damping_N_s_per_m);
  row.add(hand.hand.stiffness_N_per_m);
  row.add(figures.ticks.ticks());
  row.add(figures.ticks.peakForce_N());
  row.add(figures.ticks.rmsForce_N());
  row.add(kMillimetrePerMetre * figures.ticks.rmsError_m());
  row.add(figures.clamped);
  row.add(figures.faults);
  row.add(name(figures.first_fault));
  row.add(1e3 * figures.work.all_J());
  row.add(1e3 * figures.work.max_J());
  row.add(1e3 * figures.energy.last_J());
  row.add(1e3 * figures.energy.lowest_J());
  return row;
}

void append(Problems& problems, const Problems& more) {
  problems.insert(problems.end(), more.begin(), more.end());
}

/// Remembers the contents of a file. A file that cannot be read is reported where it is needed.
void remember(const std::string& path, Cells& cells) {
  const Result<std::string> text = json::readTextFile(path, "an input", kLargestFile);
  if (text) cells.files.emplace_back(path, checksumOf(text.value()));
}

/// The file, and what the reading program made of it, which is a program of its own.
void rememberMesh(const scene::Mesh& mesh, Cells& cells) {
  cells.files.emplace_back(mesh.file, mesh.loaded_checksum);
  if (mesh.surface) cells.files.emplace_back(mesh.file + " as read", checksumOf(std::to_string(mesh.surface->mark)));
}

void readScenes(const std::vector<std::string>& paths, Plan& plan, Cells& cells, Problems& problems) {
  for (const std::string& path : paths) {
    remember(path, cells);
    Result<scene::Description> scene = scene::readSceneFile(path);
    if (!scene) {
      append(problems, scene.problems());
      continue;
    }
    const Result<tick::TickProgram> program = scene::loadAndCompile(scene.value());
    if (!program) append(problems, program.problems());
    for (const scene::Constraint& constraint : scene.value().constraints) {
      if (const auto* mesh = std::get_if<scene::Mesh>(&constraint.shape)) rememberMesh(*mesh, cells);
      if (const auto* curve = std::get_if<scene::Curve>(&constraint.shape))
        remember(scene::pathOf(curve->file, scene.value()), cells);
    }
    plan.scenes.push_back(std::move(scene).value());
    plan.scene_names.push_back(path);
  }
}

void readHands(const std::vector<std::string>& names, Plan& plan, Cells& cells, Problems& problems) {
  for (const std::string& name : names) {
    Result<sim::HandScript> hand = cli::findHand(name, 0);
    if (!hand) {
      append(problems, hand.problems());
      continue;
    }
    const auto built_in = sim::builtInHands();
    if (std::none_of(built_in.begin(), built_in.end(), [&](const auto& one) { return name == one.name; }))
      remember(name, cells);
    plan.hands.push_back(std::move(hand).value());
    plan.hand_names.push_back(name);
  }
}

Result<Cells> make(Options& options) {
  const auto plan = std::make_shared<Plan>();
  Cells cells;
  for (const std::int64_t rate_hz : options.integers("rate_hz", 100, 10'000))
    plan->rates_hz.push_back(static_cast<int>(rate_hz));
  plan->draws = static_cast<std::size_t>(options.integer("draws", 1, kMaxDraws));
  plan->seconds = options.number("seconds", 1e-4, kLongest_s);
  plan->mass_kg = options.range("mass_kg", 1e-3, 1e3);
  plan->damping_N_s_per_m = options.range("damping_N_s_per_m", 0.0, 1e6);
  plan->stiffness_N_per_m = options.range("stiffness_N_per_m", 0.0, 1e9);
  const std::string& model = options.text("arm-model");
  if (const sim::ArmModel* found = sim::findArmModel(model)) {
    plan->arm_model = *found;
  } else {
    std::vector<std::string> names;
    for (const sim::ArmModel& one : sim::armModels()) names.push_back(one.name);
    options.note("arm-model", "It must be " + json::listed(names) + "; here it is " + json::shown(model) + ".");
  }
  const bool is_paired = options.choice("paired", {"no", "yes"}) == 1;
  Problems problems = options.problems();
  readScenes(options.texts("scene"), *plan, cells, problems);
  readHands(options.texts("hand"), *plan, cells, problems);
  if (!problems.empty()) return problems;
  cells.count = plan->scenes.size() * plan->hands.size() * plan->rates_hz.size() * plan->draws;
  cells.columns = kColumns;
  cells.run = [plan](std::size_t index, std::uint64_t seed) { return runCell(*plan, index, seed); };
  cells.command = [plan](std::size_t index, std::uint64_t seed) { return commandOf(*plan, index, seed); };
  if (is_paired) cells.seed_cell = [plan](std::size_t index) { return whereIs(*plan, index).draw; };
  return cells;
}

}  // namespace hands_kind

SweepKind handsKind() {
  return {"hands",
          "What does the arm do in hands that differ in mass, damping, stiffness and tremor?",
          {{"scene", "Scene files", {}, true},
           {"hand", "Built-in hands or hand files; of a file only its path", {"tremor"}, true},
           {"rate_hz", "Ticks per second", {"1000"}, true},
           {"draws", "Hands drawn at random for each scene, hand and rate", {"10"}},
           {"paired", "yes: a draw is the same hand with the same seed in each scene, hand and rate", {"no"}},
           {"seconds", "Duration of each run by the arm's clock, s", {"2"}},
           {"mass_kg", "Mass of the hand, kg: a number, or LOW:HIGH for a uniform draw", {"0.05:0.2"}},
           {"damping_N_s_per_m", "Damping of the hand, N s/m, likewise", {"2:8"}},
           {"stiffness_N_per_m", "Stiffness of the hand, N/m, likewise", {"150:600"}},
           {"arm-model", "Model of the simulated arm", {std::string(sim::kDefaultArmModel)}}},
          hands_kind::make};
}

}  // namespace underact::sweep
