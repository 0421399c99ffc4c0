#pragma once
#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "core/base/result.h"
#include "core/extremes/input.h"

namespace underact::extremes {

/// What of a case's answer is off, in units of what the row promises by: ulp of a scale that its promise names.
/// Infinite where the answer is wrong in kind (not finite, not unique where it is, ...).
struct Outcome {
  double error_ulp = 0.0;
  bool is_degenerate = false;  // the code said so, rightly: nothing but that was judged
};

/// What a row asks: the group that it is listed with.
enum class Kind : std::uint8_t { Base, Shape, Target, Arm, Chain, Solver, Law, Filter, Gate, Plant, Tick, Drift };

/// One thing that is asked at the extremes.
struct Row {
  const char* key;
  Kind kind;
  const char* asked;
  const char* promise;       // ulp of what
  double promised_ulp;       // how many
  int cost;                  // one case for each so many of a cheap row
  Outcome (*judge)(Input&);  // draws a case, asks the code and the oracle, compares
};

/// The worst of many cases, and how many there were.
struct Worst {
  double error_ulp = 0.0;
  std::vector<double> input;  // the numbers of that case, in the order in which the row asks for them
  std::int64_t cases = 0;
  std::int64_t degenerate = 0;
};

/// Both together: the greater error (of equals the smaller input, number by number), and the sums. So it is the same in
/// whatever order many are put together.
Worst worse(const Worst& a, const Worst& b);

/// count: of a cheap row; a dear one makes count / cost cases, at least one. The same for the same arguments, on every
/// machine and however calls are spread. stop: asked before each case, true ends it early; may be empty.
Worst measure(const Row& row, std::uint64_t seed, int count, const std::function<bool()>& stop = {});

/// One case again, from its numbers. A problem where they are not as many as the row asks for.
Result<Outcome> judgeAgain(const Row& row, const std::vector<double>& input);

/// The case in words: the name of each number, and the number.
std::string wordsOf(const Row& row, const std::vector<double>& input);

/// "base", "shape" and so on: the enumerator in small letters.
const char* name(Kind kind);

}  // namespace underact::extremes
