#include <benchmark/benchmark.h>

#include "core/chain/inverse.h"
#include "tests/bench/kinematics/table.h"

namespace underact::bench {
namespace {

/// In closed form, where the arm has one.
Lines closedForm(const Cases& cases) {
  Line line{cases.arm.name, "inverse, all branches", "underact"};
  const chain::Inverse inverse = chain::inverseOf(cases.chain);
  if (!inverse.isClosed()) return {};
  line.median_ns = medianOf(cases.q.size(),
                            [&](std::size_t i) { benchmark::DoNotOptimize(chain::solveAll(inverse, cases.X_WT[i])); });
  Score score;
  std::size_t answers = 0;
  for (const Pose& X_WT : cases.X_WT) {
    const chain::InverseSolutions found = chain::solveAll(inverse, X_WT);
    for (std::size_t i = 0; i < found.count; ++i) score.add(chain::forward(cases.chain, found.all[i].q), X_WT);
    answers += found.count;
  }
  score.into(line);
  line.note = std::to_string(answers) + " answers";
  return {line};
}

Line numericByOurs(const Cases& cases, const std::vector<std::vector<double>>& seeds, int restarts, const char* task) {
  Line line{cases.arm.name, task, "underact"};
  chain::NumericOptions options;
  options.restarts = restarts;
  const auto solve = [&](std::size_t i) {
    return chain::solveNumerically(cases.chain, cases.X_WT[i], seeds[i], options);
  };
  line.median_ns = medianOf(cases.q.size(), [&](std::size_t i) { benchmark::DoNotOptimize(solve(i)); });
  Score score;
  int steps = 0, starts = 0;
  for (std::size_t i = 0; i < cases.q.size(); ++i) {
    const chain::NumericSolution found = solve(i);
    score.add(chain::forward(cases.chain, std::span<const double>(found.q).first(cases.arm.rows.size())),
              cases.X_WT[i]);
    steps += found.steps;
    starts += 1 + found.restarts_used;
  }
  score.into(line);
  const double count = static_cast<double>(cases.q.size());
  line.note = std::to_string(steps / count).substr(0, 4) + " steps, " + std::to_string(starts / count).substr(0, 4) +
              " starts each";
  return line;
}

}  // namespace

Lines ours(const Cases& cases) {
  const std::size_t count = cases.q.size();
  Line forward{cases.arm.name, "forward", "underact"}, both{cases.arm.name, "forward and Jacobian", "underact"};
  forward.median_ns =
      medianOf(count, [&](std::size_t i) { benchmark::DoNotOptimize(chain::forward(cases.chain, cases.q[i])); });
  both.median_ns =
      medianOf(count, [&](std::size_t i) { benchmark::DoNotOptimize(chain::kinematics(cases.chain, cases.q[i])); });
  Lines lines{forward, both};
  for (const Line& line : closedForm(cases)) lines.push_back(line);
  lines.push_back(numericByOurs(cases, cases.near, 0, "inverse, one, from 0.1 rad off"));
  lines.push_back(numericByOurs(cases, cases.far, 0, "inverse, one, from anywhere"));
  lines.push_back(numericByOurs(cases, cases.far, kRestarts, "inverse, one, with 20 restarts"));
  return lines;
}

}  // namespace underact::bench
