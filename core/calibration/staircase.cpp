#include "core/calibration/staircase.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace underact::calibration {

constexpr std::size_t kRunIn = 2;  // initial reversals that are not counted

Staircase beginStaircase(const StaircaseRule& rule) {
  Staircase staircase;
  staircase.rule = rule;
  staircase.difference = rule.first;
  return staircase;
}

Staircase answered(Staircase staircase, bool right) {
  const StaircaseRule& rule = staircase.rule;
  ++staircase.trials;
  staircase.right_now = right ? staircase.right_now + 1 : 0;
  if (right && staircase.right_now < rule.right_in_a_row) return staircase;
  const int direction = right ? -1 : 1;
  if (staircase.direction == -direction) staircase.reversals.push_back(staircase.difference);
  staircase.direction = direction;
  staircase.right_now = 0;
  const double factor = staircase.reversals.size() < kRunIn ? rule.coarse : rule.fine;
  const double next = right ? staircase.difference / factor : staircase.difference * factor;
  staircase.difference = std::clamp(next, rule.min, rule.max);
  return staircase;
}

bool isDone(const Staircase& staircase) {
  return static_cast<int>(staircase.reversals.size()) >= staircase.rule.reversals ||
         staircase.trials >= staircase.rule.max_trials;
}

std::optional<Threshold> thresholdOf(const Staircase& staircase) {
  if (staircase.reversals.size() < kRunIn + 2) return std::nullopt;
  const double count = static_cast<double>(staircase.reversals.size() - kRunIn);
  double sum = 0.0, squares = 0.0;
  for (std::size_t i = kRunIn; i < staircase.reversals.size(); ++i) sum += std::log(staircase.reversals[i]);
  const double mean = sum / count;
  for (std::size_t i = kRunIn; i < staircase.reversals.size(); ++i) {
    squares += (std::log(staircase.reversals[i]) - mean) * (std::log(staircase.reversals[i]) - mean);
  }
  const double deviation = std::sqrt(squares / (count - 1.0));
  return Threshold{std::exp(mean), std::exp(mean - deviation), std::exp(mean + deviation)};
}

}  // namespace underact::calibration
