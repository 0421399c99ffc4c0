#pragma once
#include <cstdint>
#include <deque>
#include <optional>
#include <vector>

#include "core/lesson/lesson.h"

namespace underact::lesson {

/// The state of a check; a new one has seen nothing.
struct CheckState {
  bool solved = false;
  Values now{};                         // what was measured last, or when it was solved; of a place, how far it is
  bool measured = false;                // now is of a tick
  std::size_t missed = 0;               // 1 + the place in Check::meanwhile of one that does not hold; 0: all do
  double meanwhile_now = 0.0;           // of that one
  std::int64_t last_ns = 0;             // of the last tick
  double held_s = 0.0;                  // Hold: how long it has been there
  std::vector<bool> visited;            // Visit: place by place
  double min = 0.0, max = 0.0;          // Span: since meanwhile holds
  bool spanning = false;                // least and most are known
  int side = 0;                         // Cross: of the value, on which it was last far enough; 0: on none yet
  std::deque<std::int64_t> crossed_ns;  // Cross: when it went to the other side, lately
  std::optional<double> answer;         // to a question, the last one: a number, or the number of a choice
  bool is_wrong = false;                // the answer was
  std::vector<double> wrong;            // all wrong answers
};

/// The state after a tick. A solved check stays as it is. seen.tick.time_ns must not decrease; where it jumps by more
/// than kLongestGap_s (a pause, another session), durations begin again.
CheckState afterTick(const Check& check, CheckState state, const Observation& seen);

/// The state after an answer to the check's question: a number, or the number of a choice from 1. Where the answer is
/// measured, the last tick counts; before the first tick no answer is right.
CheckState afterAnswer(const Check& check, CheckState state, double answer);

/// What a wrong answer shows; null: the lesson does not say.
const Misconception* misconceptionOf(const Check& check, double answer);

inline constexpr double kLongestGap_s = 0.5;

/// The quantity as a number: its one value, the part asked for, or the norm of all parts.
double numberOf(const Measure& measure, const Values& values);

/// The distance of the values from a point, in the metric of the measure.
double distanceTo(const Measure& measure, const Values& values, const std::vector<double>& place);

/// Whether a step is done: each of its checks is.
bool isSolved(const std::vector<CheckState>& states);

}  // namespace underact::lesson
