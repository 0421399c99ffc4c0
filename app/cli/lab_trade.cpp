#include <algorithm>
#include <memory>
#include <optional>
#include <ostream>

#include "app/cli/command.h"
#include "app/cli/lab_folder.h"
#include "app/cli/lab_inputs.h"
#include "app/cli/progress.h"
#include "app/cli/table.h"
#include "core/system/signals.h"
#include "core/tradeoff/front.h"

namespace underact::cli {
namespace {

constexpr double kLongestTrade_s = 600.0;

struct TradeOptions {
  std::vector<std::string> scenes, hands, choices;
  double seconds = 4.0;
  std::uint64_t seed = 1;
  std::string table = "choices";
  bool json = false;
  std::string out;  // folder; empty: one table on stdout
};

struct TradeTables {
  Table choices{{"choice", "option", "runs", "p50_ns", "p99_ns", "us_per_s", "error", "worst", "unit", "bound",
                 "default", "recommended", "question", "timed", "error_is", "reason", "scene", "hand"}};
  Table rows{
      {"scene", "hand", "choice", "option", "p50_ns", "p99_ns", "us_per_s", "error", "worst", "unit", "default"}};
  Table fronts{{"scene", "us_per_s", "error_mm", "error_N", "on_front", "own", "settings"}};
};

const tradeoff::Choice& choiceOf(const std::string& key) {
  const auto all = tradeoff::choices();
  return *std::find_if(all.begin(), all.end(), [&](const tradeoff::Choice& choice) { return key == choice.key; });
}

void addRows(const std::vector<tradeoff::TradeoffRow>& rows, TradeTables& tables) {
  for (const tradeoff::TradeoffRow& row : rows) {
    const tradeoff::Figures& figures = row.figures;
    tables.rows.add({row.scene, row.hand, row.choice, row.option, figures.cost.p50_ns, figures.cost.p99_ns,
                     figures.cost_us_per_s, figures.error, figures.worst, std::string(choiceOf(row.choice).unit),
                     row.is_default});
  }
  for (const tradeoff::Summary& one : tradeoff::summaryOf(rows)) {
    const tradeoff::Choice& choice = choiceOf(one.choice);
    tables.choices.add({one.choice, one.option, std::int64_t{one.runs}, one.p50_ns, one.p99_ns, one.cost_us_per_s,
                        one.error, one.worst, std::string(choice.unit), choice.bound, one.is_default,
                        one.is_recommended, std::string(choice.question), std::string(choice.cost),
                        std::string(choice.error), std::string(choice.reason), one.scene, one.hand});
  }
}

/// "servo rate 4000 Hz; simulated arm trapezoidal, 50 us": what differs from the scene's own, or "as it is".
std::string settingsText(const scene::Description& scene, const tradeoff::Settings& own,
                         const tradeoff::Settings& settings) {
  std::string text;
  for (const tradeoff::Difference& one : tradeoff::differences(scene, own, settings))
    text += (text.empty() ? "" : "; ") + one.what + " " + one.after;
  return text.empty() ? "as it is" : text;
}

void addFront(const tradeoff::NamedScene& scene, const std::vector<tradeoff::Point>& points, TradeTables& tables) {
  const tradeoff::Settings own = tradeoff::settingsOf(scene.scene, tradeoff::Settings{}.rate_hz);
  for (const tradeoff::Point& point : points) {
    tables.fronts.add({scene.name, point.cost_us_per_s, point.error_mm, point.error_N, point.on_front, point.is_own,
                       settingsText(scene.scene, own, point.settings)});
  }
}

/// Empty: something could not be read; the problem has been printed, and exit is its status.
std::optional<tradeoff::Plan> planOf(const TradeOptions& options, const Streams& streams, Exit& exit) {
  auto hands = labHands(options.hands, options.seed, streams, exit);
  if (!hands) return {};
  auto scenes = labScenes(options.scenes, streams, exit);
  if (!scenes) return {};
  return tradeoff::Plan{std::move(*scenes), std::move(*hands), options.choices, options.seconds};
}

/// The progress of the work; each part has its share.
class Work {
 public:
  Work(double parts, const system::Interrupt& interrupt, const Streams& streams)
      : parts_(parts), interrupt_(interrupt), progress_(streams) {}
  tradeoff::Progress part(double share) {
    const double begun = done_;
    done_ += share;
    return [this, begun, share](double now) {
      progress_.show((begun + share * now) / parts_);
      return !interrupt_.came();
    };
  }

 private:
  double parts_, done_ = 0.0;
  const system::Interrupt& interrupt_;
  Progress progress_;
};

/// The results to print.
struct Asked {
  bool rows, fronts;
  explicit Asked(const TradeOptions& options)
      : rows(!options.out.empty() || options.table != "fronts"),
        fronts(!options.out.empty() || options.table == "fronts") {}
};

TradeTables measure(const tradeoff::Plan& plan, const Asked& asked, const system::Interrupt& interrupt,
                    const Streams& streams) {
  TradeTables tables;
  const auto scenes = static_cast<double>(plan.scenes.size());
  Work work((asked.rows ? scenes : 0.0) + (asked.fronts ? scenes : 0.0), interrupt, streams);
  if (asked.rows) addRows(tradeoff::measureRows(plan, work.part(scenes)), tables);
  if (!asked.fronts || (asked.rows && tables.rows.isEmpty())) return tables;
  for (const tradeoff::NamedScene& scene : plan.scenes) {
    if (interrupt.came()) break;
    addFront(
        scene,
        tradeoff::measurePoints(scene.scene, plan.hands, plan.seconds, tradeoff::Settings{}.rate_hz, work.part(1.0)),
        tables);
  }
  return tables;
}

/// Why there is no result; empty: there is one.
std::string whatIsMissing(const TradeTables& tables, const Asked& asked) {
  if (asked.rows && tables.rows.isEmpty())
    return "Nothing could be measured: the scenes have none of these choices, the hands never touch what the choices "
           "affect, or every run ended in a fault.\n";
  if (asked.fronts && tables.fronts.isEmpty())
    return "No scene has a front: with one of the hands the finest run, or every other run, ended in a fault. --table "
           "choices shows what can be measured nonetheless.\n";
  return {};
}

Exit tradeOf(const TradeOptions& options, const Streams& streams) {
  Exit exit = Exit::Success;
  const std::optional<tradeoff::Plan> plan = planOf(options, streams, exit);
  if (!plan) return exit;
  const system::Interrupt interrupt;
  const Asked asked(options);
  const TradeTables tables = measure(*plan, asked, interrupt, streams);
  const std::string sentence =
      interrupt.came() ? "Stopped before the end. Nothing is printed, because a part would look like the whole.\n"
                       : whatIsMissing(tables, asked);
  if (!sentence.empty()) {
    streams.err << sentence;
    return Exit::BadInput;
  }
  if (!options.out.empty()) {
    return fillFolder(options.out, "trade",
                      {{"trade_choices.csv", &tables.choices},
                       {"trade_rows.csv", &tables.rows},
                       {"trade_fronts.csv", &tables.fronts}},
                      streams);
  }
  const Table& table = options.table == "rows"     ? tables.rows
                       : options.table == "fronts" ? tables.fronts
                                                   : tables.choices;
  options.json ? table.printJson(streams.out) : table.printCsv(streams.out);
  return Exit::Success;
}

}  // namespace

void addLabTrade(Command lab, const Streams& streams, Exit& exit) {
  auto options = std::make_shared<TradeOptions>();
  const Command command =
      lab.add("trade", "Cost and accuracy of each choice between speed and accuracy, for each scene and each hand");
  std::vector<std::string> keys;
  for (const tradeoff::Choice& choice : tradeoff::choices()) keys.emplace_back(choice.key);
  command.option("--scenes", options->scenes, "Scene files, instead of those that ship");
  command.option("--hands", options->hands, "Hands, separated by commas; by default all built-in hands").withCommas();
  command.option("--choices", options->choices, "Choices, separated by commas; by default all")
      .withCommas()
      .oneOf(keys);
  command.option("--seconds", options->seconds, "Duration of each run, s").range(0.1, kLongestTrade_s).showDefault();
  command.option("--seed", options->seed, "Seed of the hands").showDefault();
  command
      .option("--table", options->table,
              "choices: over all runs, with the recommendation; rows: each run; fronts: complete configurations for "
              "each scene")
      .oneOf({"choices", "rows", "fronts"})
      .showDefault();
  command.option("--out", options->out, "Folder for all three tables as CSV, and their pictures");
  command.flag("--json", options->json, "One JSON object per row instead of CSV");
  command.footer(
      "Times are those of this machine; errors are the same each time. Run nothing else at the same time. Of the "
      "choices within the\n"
      "error bound that cost at most a tenth more than the cheapest of these, the most accurate is recommended.");
  command.whenChosen([options, &streams, &exit] { exit = tradeOf(*options, streams); });
}

}  // namespace underact::cli
