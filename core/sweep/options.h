#pragma once
#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "core/base/result.h"

namespace underact::sweep {

/// An option of a kind, as the command line and a sweep's file have it.
struct Option {
  std::string name;                // "rate_hz"; on the command line --rate_hz
  std::string what;                // one sentence, for --help
  std::vector<std::string> usual;  // where nothing is said; empty: something must be
  bool many = false;               // takes more than one value
};

/// A number that each cell draws for itself, evenly; low = high: a fixed one.
struct Range {
  double low = 0.0, high = 0.0;
  /// share: in [0, 1), as nextShare() gives it.
  double at(double share) const { return low + share * (high - low); }
};

/// What was said for each option, or what is usual; read by a kind's make().
class Options {
 public:
  /// What was said: for each option its values, as text.
  using Values = std::map<std::string, std::vector<std::string>>;
  /// Problems: an option that no kind of these rows has, one without a value, several values where one is asked for.
  static Result<Options> from(const std::vector<Option>& rows, const Values& said);

  // Each notes a problem, and gives something harmless, where a value is not what it should be; the name must be that
  // of a row. low, high: the bounds of a value, both allowed.
  const std::vector<std::string>& texts(const std::string& name) const;
  const std::string& text(const std::string& name) const { return texts(name).front(); }
  double number(const std::string& name, double low, double high);
  std::vector<double> numbers(const std::string& name, double low, double high);
  std::int64_t integer(const std::string& name, std::int64_t low, std::int64_t high);
  std::vector<std::int64_t> integers(const std::string& name, std::int64_t low, std::int64_t high);
  /// "0.1", or "0.05:0.2" for low and high of what is drawn.
  Range range(const std::string& name, double low, double high);
  /// Notes a problem with an option that no bounds can tell.
  void note(const std::string& name, const std::string& sentence);
  /// All that was noted so far.
  const Problems& problems() const { return problems_; }

  /// All options in the order of their names, as one line of JSON: equal texts are equal options.
  std::string canonical() const;

 private:
  Values values_;
  Problems problems_;
};

}  // namespace underact::sweep
