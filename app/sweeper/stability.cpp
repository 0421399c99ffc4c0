#include <algorithm>
#include <memory>
#include <utility>

#include "app/sweeper/catalogue.h"
#include "app/sweeper/command_words.h"
#include "core/base/random.h"
#include "core/base/units.h"
#include "core/json/text.h"
#include "core/stability/maps.h"

namespace underact::sweep {
namespace stability_kind {

constexpr std::int64_t kMaxDraws = 10'000'000;
constexpr const char* kDrawn = "drawn";

/// The walls of the maps, and the ranges from which others are drawn.
struct Plan {
  std::vector<std::pair<const char*, stability::Variant>> walls;
  std::size_t draws = 0;
  std::vector<std::int64_t> rates_hz;
  Range mass_kg, damping_N_s_per_m, hand_stiffness_N_per_m, friction_N, kd_N_s_per_m, delay_ticks;
};

stability::Variant drawnWall(const Plan& plan, std::uint64_t seed) {
  std::uint64_t state = seed;
  stability::Variant drawn{kDrawn, {}};
  stability::SampledWall& wall = drawn.wall;
  wall.mass_kg = plan.mass_kg.at(nextShare(state));
  wall.damping_N_s_per_m = plan.damping_N_s_per_m.at(nextShare(state));
  wall.hand_stiffness_N_per_m = plan.hand_stiffness_N_per_m.at(nextShare(state));
  wall.friction_N = plan.friction_N.at(nextShare(state));
  wall.kd_N_s_per_m = plan.kd_N_s_per_m.at(nextShare(state));
  const Range ticks{plan.delay_ticks.low, plan.delay_ticks.high + 1.0};  // integers, equally likely
  wall.delay_ticks = static_cast<int>(std::min(ticks.at(nextShare(state)), plan.delay_ticks.high));
  const auto rates = static_cast<double>(plan.rates_hz.size());
  wall.period_ns = 1'000'000'000 / plan.rates_hz[static_cast<std::size_t>(rates * nextShare(state))];
  return drawn;
}

const std::vector<std::string> kColumns{"map",
                                        "variant",
                                        "rate_hz",
                                        "delay_ticks",
                                        "mass_kg",
                                        "damping_N_s_per_m",
                                        "hand_stiffness_N_per_m",
                                        "friction_N",
                                        "encoder_steps",
                                        "kd_N_s_per_m",
                                        "simulated_N_per_m",
                                        "exact_N_per_m",
                                        "passive_N_per_m",
                                        "colgate_schenkel_N_per_m",
                                        "gil_hulin_N_per_m",
                                        "label_at_nominal",
                                        "amplitude_mm_at_nominal"};

stability::Variant variantOf(const Plan& plan, std::size_t index, std::uint64_t seed) {
  return index >= plan.walls.size() ? drawnWall(plan, seed) : plan.walls[index].second;
}

std::string commandOf(const Plan& plan, std::size_t index, std::uint64_t seed) {
  const stability::SampledWall wall = variantOf(plan, index, seed).wall;
  CommandWords words("underact-cli lab stability");
  words.add("--mass_kg", wall.mass_kg)
      .add("--damping_N_s_per_m", wall.damping_N_s_per_m)
      .add("--kd_N_s_per_m", wall.kd_N_s_per_m)
      .add("--rate_hz", 1'000'000'000 / wall.period_ns)
      .add("--delay_ticks", wall.delay_ticks)
      .add("--hand_stiffness_N_per_m", wall.hand_stiffness_N_per_m)
      .add("--friction_N", wall.friction_N)
      .add("--encoder_steps", wall.coarseness);
  if (const auto* low_pass = std::get_if<control::LowPass>(&wall.velocity))
    words.add("--filter", "low_pass").add("--filter_s", low_pass->time_constant_s);
  if (std::holds_alternative<control::AdaptiveWindow>(wall.velocity)) words.add("--filter", "adaptive_window");
  if (std::holds_alternative<control::Kalman>(wall.velocity)) words.add("--filter", "kalman");
  return words.add("--stiffness_N_per_m", stability::kNominal_N_per_m).add("--json").text();
}

Result<SweepRow> runCell(const Plan& plan, std::size_t index, std::uint64_t seed) {
  const bool is_drawn = index >= plan.walls.size();
  const stability::Variant variant = variantOf(plan, index, seed);
  const stability::SampledWall& wall = variant.wall;
  const stability::Limits limits = stability::limitsOf(wall);
  const stability::TrialResult nominal = stability::tryWall(wall, stability::kNominal_N_per_m);
  SweepRow row;
  row.add(is_drawn ? kDrawn : plan.walls[index].first);
  row.add(variant.name);
  row.add(1'000'000'000 / wall.period_ns);
  row.add(wall.delay_ticks);
  row.add(wall.mass_kg);
  row.add(wall.damping_N_s_per_m);
  row.add(wall.hand_stiffness_N_per_m);
  row.add(wall.friction_N);
  row.add(wall.coarseness);
  row.add(wall.kd_N_s_per_m);
  row.add(limits.simulated_N_per_m);
  row.add(limits.exact_N_per_m.value_or(kNotANumber));
  row.add(limits.passive_N_per_m);
  row.add(limits.colgate_schenkel_N_per_m);
  row.add(limits.gil_hulin_N_per_m);
  row.add(name(nominal.behaviour));
  row.add(kMillimetrePerMetre * nominal.amplitude_m);
  return row;
}

void addMap(const stability::WallMap& map, Plan& plan) {
  for (const stability::Variant& variant : map.variants) {
    for (const double kd : stability::mapDampings_N_s_per_m()) {
      plan.walls.emplace_back(map.key, variant);
      plan.walls.back().second.wall.kd_N_s_per_m = kd;
    }
  }
}

void readMaps(Options& options, Plan& plan) {
  for (const std::string& wanted : options.texts("map")) {
    if (wanted == "none") continue;
    std::vector<std::string> known{"all", "none"};
    bool found = wanted == "all";
    for (const stability::WallMap& map : stability::wallMaps()) {
      known.emplace_back(map.key);
      if (wanted != "all" && wanted != map.key) continue;
      addMap(map, plan);
      found = true;
    }
    if (!found)
      options.note("map", "There is no map " + json::shown(wanted) + "; there are " + json::listed(known, "and") + ".");
  }
}

Result<Cells> make(Options& options) {
  const auto plan = std::make_shared<Plan>();
  readMaps(options, *plan);
  plan->draws = static_cast<std::size_t>(options.integer("draws", 0, kMaxDraws));
  plan->rates_hz = options.integers("rate_hz", 1, 10'000);
  plan->mass_kg = options.range("mass_kg", 1e-6, 1e3);
  plan->damping_N_s_per_m = options.range("damping_N_s_per_m", 0.0, 1e4);
  plan->hand_stiffness_N_per_m = options.range("hand_stiffness_N_per_m", 0.0, 1e6);
  plan->friction_N = options.range("friction_N", 0.0, 1e3);
  plan->kd_N_s_per_m = options.range("kd_N_s_per_m", 0.0, 1e4);
  plan->delay_ticks = options.range("delay_ticks", 0.0, stability::kMaxDelay);
  if (!options.problems().empty()) return options.problems();
  Cells cells;
  cells.count = plan->walls.size() + plan->draws;
  cells.columns = kColumns;
  cells.run = [plan](std::size_t index, std::uint64_t seed) { return runCell(*plan, index, seed); };
  cells.command = [plan](std::size_t index, std::uint64_t seed) { return commandOf(*plan, index, seed); };
  return cells;
}

}  // namespace stability_kind

SweepKind stabilityKind() {
  return {
      "stability",
      "How stiff can a wall be before it buzzes: by bisection in the simulated loop, by eigenvalues, and by formulas?",
      {{"map", "Maps of the lab: rate, delay, hand, filter, quantization, friction; all; none", {"all"}, true},
       {"draws", "Further walls, drawn at random from the ranges below", {"0"}},
       {"rate_hz", "Samples per second of the drawn walls: one of these", {"1000"}, true},
       {"mass_kg", "Mass of arm and hand, kg: a number, or LOW:HIGH for a uniform draw", {"0.045"}},
       {"damping_N_s_per_m", "Damping of arm and hand, N s/m", {"0.1"}},
       {"hand_stiffness_N_per_m", "Stiffness of the hand, N/m", {"0"}},
       {"friction_N", "Coulomb friction of the arm, N", {"0"}},
       {"kd_N_s_per_m", "Damping of the wall, N s/m", {"0"}},
       {"delay_ticks", "Whole periods between a sample and its force", {"0"}}},
      stability_kind::make};
}

}  // namespace underact::sweep
