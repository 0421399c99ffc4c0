#pragma once
#include <cstdint>
#include <string>
#include <vector>

#include "core/base/result.h"
#include "tests/error_bounds/input.h"

namespace underact::error_bounds {

/// The error of a case, in ulp of the scale that the row's promise names. Infinite where the result is of the wrong
/// kind (not finite, not unique although it should be, ...).
struct Outcome {
  double error_ulp = 0.0;
  bool is_degenerate = false;  // the code reported it, correctly; nothing else was judged
};

/// The group that a row is listed with.
enum class Kind : std::uint8_t { Base, Shape, Target, Arm, Chain, Solver, Law, Filter, Gate, Plant, Tick, Drift };

/// One property that is tested at the extremes.
struct Row {
  const char* key;
  Kind kind;
  const char* asked;
  const char* promise;       // ulp of what
  double promised_ulp;       // how many
  int cost;                  // relative cost: one case for so many of a cheap row
  Outcome (*judge)(Input&);  // draws a case, evaluates code and oracle, compares
};

/// The worst of many cases, and their number.
struct Worst {
  double error_ulp = 0.0;
  std::vector<double> input;  // the numbers of that case, in the order in which the row asks for them
  std::int64_t cases = 0;
  std::int64_t degenerate = 0;
};

/// The worse of two results (the greater error, of equals the smaller input, number by number), with the sums of
/// counts: so the order in which many are combined does not matter.
Worst worse(const Worst& a, const Worst& b);

/// Runs cases of a row. count: for a cheap row; an expensive one runs count / cost cases, at least one. The same for
/// the same arguments, on every machine.
Worst measure(const Row& row, std::uint64_t seed, int count);

/// Runs one case again, from its numbers. Problem: their count differs from what the row asks for.
Result<Outcome> rerunCase(const Row& row, const std::vector<double>& input);

/// The case in words: the name of each number, and the number.
std::string wordsOf(const Row& row, const std::vector<double>& input);

/// "base", "shape" and so on: the enumerator in small letters.
const char* name(Kind kind);

}  // namespace underact::error_bounds
