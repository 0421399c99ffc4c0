#pragma once
#include <algorithm>
#include <chrono>
#include <cstdio>
#include <string>
#include <vector>

#include "tests/bench/mesh/case.h"

namespace underact::bench {

using Clock = std::chrono::steady_clock;

inline double since_us(Clock::time_point begin) {
  return std::chrono::duration<double, std::micro>(Clock::now() - begin).count();
}

inline double shareOf(std::vector<double> values, double share) {
  const auto at = values.begin() + static_cast<std::ptrdiff_t>(share * static_cast<double>(values.size() - 1));
  std::nth_element(values.begin(), at, values.end());
  return *at;
}

/// What reading the clock twice costs by itself: taken off each time.
inline double clockCost_us() {
  std::vector<double> nothing(100000);
  for (double& one : nothing) one = since_us(Clock::now());
  return shareOf(nothing, 0.5);
}

/// Each query is timed by itself, the list five times over after once without a clock; the middle one of a query's five
/// times counts, so that what else the machine did meanwhile does not. ask: gives the squared distance; each turn
/// begins with a copy of it that remembers nothing.
template <class Ask>
Times timesOf(const std::vector<Vec3>& list, const Ask& ask, std::vector<double>& squared) {
  constexpr std::size_t kTurns = 5;
  const double cost_us = clockCost_us();
  std::vector<std::vector<double>> times(list.size(), std::vector<double>(kTurns));
  std::vector<double> answers(list.size());
  for (std::size_t turn = 0; turn <= kTurns; ++turn) {
    Ask fresh = ask;
    for (std::size_t i = 0; i < list.size(); ++i) {
      const Clock::time_point begin = Clock::now();
      answers[i] = fresh(list[i]);
      const double taken_us = since_us(begin);
      if (turn > 0) times[i][turn - 1] = std::max(0.0, taken_us - cost_us);
    }
  }
  squared.insert(squared.end(), answers.begin(), answers.end());
  std::vector<double> middle;
  for (std::vector<double>& of_one : times) middle.push_back(shareOf(of_one, 0.5));
  return {shareOf(middle, 0.5), shareOf(middle, 0.99)};
}

/// Asks both lists, prints the line and writes the answers beside: PATH.0, PATH.1 ..., in the order of the lines.
class Teller {
 public:
  Teller(const Case& one, std::string answers) : case_(one), answers_(std::move(answers)) {}

  template <class Ask>
  void tell(Line line, const Ask& ask) {
    std::vector<double> squared;
    line.random = timesOf(case_.random_M, ask, squared);
    line.path = timesOf(case_.path_M, ask, squared);
    if (!writeAnswers(squared, answers_ + "." + std::to_string(told_++))) line.note += " (answers not written)";
    std::printf("%s\n", textOf(line).c_str());
    std::fflush(stdout);
  }

 private:
  const Case& case_;
  std::string answers_;
  int told_ = 0;
};

/// How long something took, and by how much the memory in use grew.
template <class Build>
Line built(const char* by, const Build& build) {
  Line line{by};
  const double before_MB = memory_MB();
  const Clock::time_point begin = Clock::now();
  build();
  line.build_ms = since_us(begin) / 1e3;
  line.grown_MB = memory_MB() - before_MB;
  return line;
}

}  // namespace underact::bench
