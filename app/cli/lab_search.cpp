#include <iomanip>
#include <memory>
#include <ostream>

#include "app/cli/command.h"
#include "app/cli/hands.h"
#include "app/cli/json_object.h"
#include "app/cli/scene_file.h"
#include "core/base/printed.h"
#include "core/base/units.h"
#include "core/lab/search_tradeoff.h"
#include "core/scene/fields.h"
#include "core/scene/scene_arm.h"

namespace underact::cli {
namespace {

constexpr double kLongestSearch_s = 600.0;

struct SearchOptions {
  std::string scene, hand = "sweep";
  double seconds = 10.0;
  int rate_hz = 1000;
  std::uint64_t seed = 1;
  bool json = false;
};

JsonObject figuresObject(const lab::SearchFigures& figures) {
  JsonObject object;
  object.addText("search", wordOf(scene::kSearchWords, figures.search));
  object.addNumber("p50_us", figures.p50_us);
  object.addNumber("p99_us", figures.p99_us);
  object.addNumber("max_us", figures.max_us);
  object.addNumber("worst_error_mm", kMillimetrePerMetre * figures.worst_m);
  object.addNumber("share_beside", figures.share_beside);
  object.addNumber("share_unproved", figures.share_unproved);
  return object;
}

void printTrade(const std::string& name, const lab::SearchTradeoff& trade, std::ostream& out) {
  out << printed(name) << ", " << trade.pieces << (trade.is_mesh ? " triangles\n" : " pieces\n");
  out << "search     p50 us   p99 us   max us   worst error mm   beside   not proved\n";
  for (const lab::SearchFigures& figures : trade.searches) {
    out << std::left << std::setw(8) << wordOf(scene::kSearchWords, figures.search) << std::right << std::fixed
        << std::setprecision(2) << std::setw(9) << figures.p50_us << std::setw(9) << figures.p99_us << std::setw(9)
        << figures.max_us << std::setprecision(6) << std::setw(17) << kMillimetrePerMetre * figures.worst_m
        << std::setprecision(1) << std::setw(8) << 100.0 * figures.share_beside << " %" << std::setw(10)
        << 100.0 * figures.share_unproved << " %\n";
  }
}

Exit searches(const SearchOptions& options, const Streams& streams) {
  const Result<LoadedScene> loaded = loadScene(options.scene, streams);
  if (!loaded) return fail(loaded.problems(), streams);
  const Result<sim::HandScript> hand = findHand(options.hand, options.seed);
  if (!hand) return fail(hand.problems(), exitOfHand(options.hand, hand.problems()), streams);
  const auto ticks = static_cast<int>(options.seconds * options.rate_hz);
  const std::vector<lab::SearchTradeoff> trades = lab::measureSearchTradeoff(
      loaded.value().program, sim::madeFor(scene::armOf(loaded.value().description), hand.value()), options.rate_hz,
      ticks);
  if (trades.empty()) {
    streams.err << options.scene << ": This scene has no mesh and no curve, so there is nothing to search.\n";
    return Exit::BadInput;
  }
  for (const lab::SearchTradeoff& trade : trades) {
    const std::string& name = loaded.value().description.constraints[trade.constraint].name;
    if (!options.json) {
      printTrade(name, trade, streams.out);
      continue;
    }
    JsonObject object;
    object.addText("constraint", name);
    object.addText("of", trade.is_mesh ? "triangles" : "pieces");
    object.addInteger("count", static_cast<std::int64_t>(trade.pieces));
    std::vector<JsonObject> rows;
    for (const lab::SearchFigures& figures : trade.searches) rows.push_back(figuresObject(figures));
    object.addList("searches", rows);
    streams.out << object.text() << '\n';
  }
  return Exit::Success;
}

}  // namespace

void addLabSearch(Command lab, const Streams& streams, Exit& exit) {
  auto options = std::make_shared<SearchOptions>();
  const Command command = lab.add("search",
                                  "Time and error of each method of finding the nearest point on a scene's meshes and "
                                  "curves, along the path of a hand");
  command.option("SCENE", options->scene, "A scene with a mesh or a curve").required();
  command.option("--hand", options->hand, "still, sweep, probe, tremor, stab, or a hand file").showDefault();
  command.option("--seconds", options->seconds, "Duration of the motion, s")
      .range(0.001, kLongestSearch_s)
      .showDefault();
  command.option("--rate", options->rate_hz, "Ticks per second").range(1, 100000).showDefault();
  command.option("--seed", options->seed, "Seed of the hand").showDefault();
  command.flag("--json", options->json, "One JSON object per constraint instead of a table");
  command.whenChosen([options, &streams, &exit] { exit = searches(*options, streams); });
}

}  // namespace underact::cli
