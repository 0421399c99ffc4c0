#pragma once
#include <cstdint>
#include <deque>
#include <optional>
#include <vector>

#include "core/lesson/lesson.h"

namespace underact::lesson {

/// What is known of a check so far. A new one knows nothing.
struct CheckState {
  bool solved = false;
  Values now{};                         // what was measured last, or when it was solved; of a place, how far it is
  bool measured = false;                // now is of a tick
  std::size_t missed = 0;               // 1 + the place in Check::meanwhile of one that does not hold; 0: all do
  double meanwhile_now = 0.0;           // of that one
  std::int64_t last_ns = 0;             // of the last tick
  double held_s = 0.0;                  // Hold: how long it has been there
  std::vector<bool> visited;            // Visit: place by place
  double least = 0.0, most = 0.0;       // Span: since meanwhile holds
  bool spanning = false;                // least and most are known
  int side = 0;                         // Cross: of the value, on which it was last far enough; 0: on none yet
  std::deque<std::int64_t> crossed_ns;  // Cross: when it went to the other side, lately
  std::optional<double> answer;         // to a question, the last one: a number, or the number of a choice
  bool is_wrong = false;                // the answer was
};

/// The state after a tick. A solved one stays as it is. seen.tick.time_ns must not fall; where it jumps by more than
/// kLongestGap_s (a pause, another session), what has to last begins anew.
CheckState afterTick(const Check& check, CheckState state, const Seen& seen);

/// The state after an answer to the check's question: a number, or the number of a choice from 1. Where the answer is
/// measured, it is what the last tick showed; before the first tick none is right.
CheckState afterAnswer(const Check& check, CheckState state, double answer);

inline constexpr double kLongestGap_s = 0.5;

/// The quantity as a number: its one value, the part that is meant, or the size of a whole.
double numberOf(const Measure& measure, const Values& values);

/// How far values are from a place in the measure's own way.
double distanceTo(const Measure& measure, const Values& values, const std::vector<double>& place);

/// Whether a step is done: each of its checks is.
bool isSolved(const std::vector<CheckState>& states);

}  // namespace underact::lesson
