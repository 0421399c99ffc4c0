#include <memory>

#include "app/sweeper/catalogue.h"
#include "app/sweeper/command_words.h"
#include "core/error_bounds/catalogue.h"
#include "core/json/text.h"

namespace underact::sweep {
namespace extremes_kind {

constexpr std::int64_t kMostSeeds = 10'000'000, kMostCases = 100'000'000;

struct Plan {
  std::vector<const error_bounds::Row*> rows;
  std::size_t seeds = 0;
  int count = 0;
};

Result<Row> runCell(const Plan& plan, std::size_t index, std::uint64_t seed) {
  const error_bounds::Row& asked = *plan.rows[index / plan.seeds];
  const error_bounds::Worst worst = error_bounds::measure(asked, seed, plan.count);
  Row row;
  row.add(asked.key);
  row.add(worst.error_ulp);
  row.add(asked.promised_ulp);
  row.add(worst.error_ulp <= asked.promised_ulp ? "kept" : "broken");
  row.add(worst.cases);
  row.add(worst.degenerate);
  row.add(wordsOf(asked, worst.input));
  return row;
}

std::string commandOf(const Plan& plan, std::size_t index, std::uint64_t seed) {
  return CommandWords("underact-cli lab extremes")
      .add("--only", plan.rows[index / plan.seeds]->key)
      .add("--count", plan.count)
      .add("--seed", seed)
      .add("--json")
      .text();
}

void readRows(Options& options, Plan& plan) {
  for (const std::string& wanted : options.texts("only")) {
    bool found = false;
    std::vector<std::string> known{"all"};
    for (const error_bounds::Row& row : error_bounds::catalogue()) {
      known.emplace_back(row.key);
      if (wanted != "all" && wanted != row.key) continue;
      plan.rows.push_back(&row);
      found = true;
    }
    if (found) continue;
    const std::string near = json::nearestWord(wanted, known);
    options.note("only",
                 "There is no row " + json::shown(wanted) + "." +
                     (near.empty() ? " `underact-cli lab extremes` lists them." : " Did you mean \"" + near + "\"?"));
  }
}

Result<Cells> make(Options& options) {
  const auto plan = std::make_shared<Plan>();
  readRows(options, *plan);
  plan->seeds = static_cast<std::size_t>(options.integer("seeds", 1, kMostSeeds));
  plan->count = static_cast<int>(options.integer("count", 1, kMostCases));
  if (!options.problems().empty()) return options.problems();
  Cells cells;
  cells.count = plan->rows.size() * plan->seeds;
  cells.columns = {"row", "error_ulp", "promised_ulp", "promise", "cases", "degenerate", "worst_case"};
  cells.run = [plan](std::size_t index, std::uint64_t seed) { return runCell(*plan, index, seed); };
  cells.command = [plan](std::size_t index, std::uint64_t seed) { return commandOf(*plan, index, seed); };
  return cells;
}

}  // namespace extremes_kind

Kind extremesKind() {
  return {"extremes",
          "Does every number keep its promise at the extremes: scales, degenerate cases, strange samples, hours?",
          {{"only", "Rows of `lab extremes`; all", {"all"}, true},
           {"seeds", "Cells per row, each with its own seed", {"8"}},
           {"count", "Cases of a cheap row in a cell; an expensive row runs a fraction of them", {"20000"}}},
          extremes_kind::make};
}

}  // namespace underact::sweep
