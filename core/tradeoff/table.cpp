#include "core/tradeoff/table.h"

#include <algorithm>

#include "core/tradeoff/measures.h"

namespace underact::tradeoff {
namespace {

/// One choice on one scene in one hand.
struct Cell {
  const NamedScene* scene;
  const NamedHand* hand;
  const Choice* choice;
};

std::vector<Cell> cellsOf(const Plan& plan) {
  std::vector<Cell> cells;
  const auto is_asked = [&](const Choice& choice) {
    return plan.choices.empty() ||
           std::find(plan.choices.begin(), plan.choices.end(), choice.key) != plan.choices.end();
  };
  for (const NamedScene& scene : plan.scenes) {
    for (const NamedHand& hand : plan.hands) {
      for (const Choice& choice : choices()) {
        if (is_asked(choice) && choice.applies(scene.scene)) cells.push_back({&scene, &hand, &choice});
      }
    }
  }
  return cells;
}

std::vector<Entry> entriesOf(const Choice& choice, const Settings& base) {
  std::vector<Entry> entries;
  for (const Option& option : choice.options) {
    entries.push_back({option.name, base});
    option.choose(entries.back().settings);
  }
  return entries;
}

}  // namespace

Summary summaryOf(const std::vector<TradeoffRow>& rows, const std::string& choice, const std::string& option) {
  std::vector<double> p50, p99, costs, errors;
  Summary summary{choice, option};
  for (const TradeoffRow& row : rows) {
    if (row.choice != choice || row.option != option) continue;
    p50.push_back(row.figures.cost.p50_ns);
    p99.push_back(row.figures.cost.p99_ns);
    costs.push_back(row.figures.cost_us_per_s);
    errors.push_back(row.figures.error);
    summary.worst = std::max(summary.worst, row.figures.worst);
  }
  summary.runs = static_cast<int>(errors.size());
  if (summary.runs == 0) return summary;
  summary.p50_ns = lab::quantile(p50, 0.5);
  summary.p99_ns = lab::quantile(p99, 0.5);
  summary.cost_us_per_s = lab::quantile(costs, 0.5);
  summary.error = lab::quantile(errors, 0.9);
  const auto run = std::find_if(rows.begin(), rows.end(), [&](const TradeoffRow& row) {
    return row.choice == choice && row.option == option && row.figures.error == summary.error;
  });
  summary.scene = run->scene, summary.hand = run->hand;
  return summary;
}

std::vector<TradeoffRow> measureRows(const Plan& plan, const Progress& goes_on) {
  std::vector<TradeoffRow> rows;
  const std::vector<Cell> cells = cellsOf(plan);
  std::size_t runs = 0, done = 0;
  for (const Cell& cell : cells) runs += cell.choice->options.size();
  const auto tell = [&] { return goes_on(static_cast<double>(done++) / static_cast<double>(runs)); };
  for (const Cell& cell : cells) {
    const Bench bench = benchOf(cell.scene->scene, cell.hand->hand, plan.seconds);
    const Settings own = settingsOf(bench.scene, Settings{}.rate_hz);
    const auto add = [&](const Entry& entry, const Figures& figures) {
      rows.push_back({cell.scene->name, cell.hand->name, cell.choice->key, entry.name, figures,
                      cell.choice->same(own, entry.settings)});
    };
    if (!measureEach(*cell.choice, bench, own, entriesOf(*cell.choice, own), tell, add)) break;
  }
  return rows;
}

void recommend(double bound, std::vector<Summary>& options) {
  double cheapest = kInfinity;
  for (const Summary& option : options) {
    if (option.runs > 0 && option.error <= bound) cheapest = std::min(cheapest, option.cost_us_per_s);
  }
  Summary* best = nullptr;
  for (Summary& option : options) {
    const bool is_eligible =
        option.runs > 0 && option.error <= bound && option.cost_us_per_s <= (1.0 + kSameCost) * cheapest;
    if (is_eligible && (best == nullptr || option.error < best->error)) best = &option;
  }
  if (best != nullptr) best->is_recommended = true;
}

std::vector<Summary> summaryOf(const std::vector<TradeoffRow>& rows) {
  std::vector<Summary> all;
  for (const Choice& choice : choices()) {
    std::vector<Summary> options;
    for (const Option& option : choice.options) {
      Summary summary = summaryOf(rows, choice.key, option.name);
      Settings chosen;
      option.choose(chosen);
      summary.is_default = choice.same(chosen, Settings{});
      if (summary.runs > 0) options.push_back(summary);
    }
    recommend(choice.bound, options);
    all.insert(all.end(), options.begin(), options.end());
  }
  return all;
}

}  // namespace underact::tradeoff
