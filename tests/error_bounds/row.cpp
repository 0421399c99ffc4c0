#include "tests/error_bounds/row.h"

#include <algorithm>
#include <cmath>
#include <cstring>

namespace underact::error_bounds {
namespace {

/// A total order of doubles, NaN among them.
std::uint64_t bitsOf(double number) {
  std::uint64_t bits = 0;
  std::memcpy(&bits, &number, sizeof bits);
  return bits;
}

bool isBefore(const std::vector<double>& a, const std::vector<double>& b) {
  return std::lexicographical_compare(a.begin(), a.end(), b.begin(), b.end(),
                                      [](double x, double y) { return bitsOf(x) < bitsOf(y); });
}

/// An error that is not a number counts as infinite.
double plain(double error_ulp) {
  return std::isnan(error_ulp) ? kInfinity : error_ulp;
}

}  // namespace

Worst worse(const Worst& a, const Worst& b) {
  const bool takes_b = b.cases > 0 && (a.cases == 0 || b.error_ulp > a.error_ulp ||
                                       (b.error_ulp == a.error_ulp && isBefore(b.input, a.input)));
  Worst both = takes_b ? b : a;
  both.cases = a.cases + b.cases;
  both.degenerate = a.degenerate + b.degenerate;
  return both;
}

Worst measure(const Row& row, std::uint64_t seed, int count) {
  Worst worst;
  const int cases = std::max(1, count / row.cost);
  for (int index = 0; index < cases; ++index) {
    Input input(caseSeed(seed, static_cast<std::uint64_t>(index)));
    const Outcome outcome = row.judge(input);
    worst = worse(worst, {plain(outcome.error_ulp), input.numbers(), 1, outcome.is_degenerate ? 1 : 0});
  }
  return worst;
}

Result<Outcome> rerunCase(const Row& row, const std::vector<double>& input) {
  Input given(input);
  const Outcome outcome = row.judge(given);
  if (given.isShort()) {
    return Problems{{"The case has " + std::to_string(input.size()) +
                         " numbers, but now it takes another count: make the kept cases again.",
                     {"", 0, 0, row.key}}};
  }
  return Outcome{plain(outcome.error_ulp), outcome.is_degenerate};
}

std::string wordsOf(const Row& row, const std::vector<double>& input) {
  Input given(input);
  row.judge(given);
  return given.words();
}

const char* name(Kind kind) {
  switch (kind) {
    case Kind::Base:
      return "base";
    case Kind::Shape:
      return "shape";
    case Kind::Target:
      return "target";
    case Kind::Arm:
      return "arm";
    case Kind::Chain:
      return "chain";
    case Kind::Solver:
      return "solver";
    case Kind::Law:
      return "law";
    case Kind::Filter:
      return "filter";
    case Kind::Gate:
      return "gate";
    case Kind::Plant:
      return "plant";
    case Kind::Tick:
      return "tick";
    case Kind::Drift:
      return "drift";
  }
  return "";
}

}  // namespace underact::error_bounds
