#pragma once
#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "core/base/result.h"

namespace underact::sweep {

/// An option of a kind, on the command line and in a sweep's file.
struct Option {
  std::string name;                        // "rate_hz"; on the command line --rate_hz
  std::string what;                        // one sentence, for --help
  std::vector<std::string> default_value;  // the default; empty: the option is required
  bool many = false;                       // takes more than one value
};

/// A number that each cell draws, uniformly; low = high: a fixed one.
struct Range {
  double low = 0.0, high = 0.0;
  /// share: in [0, 1), as nextShare() gives it.
  double at(double share) const { return low + share * (high - low); }
};

/// The values of all options, given or default; read by a kind's make().
class Options {
 public:
  /// The given values of each option, as text.
  using Values = std::map<std::string, std::vector<std::string>>;
  /// Problems: an option that is not in the rows, one without a value, several values for one that takes one.
  static Result<Options> from(const std::vector<Option>& rows, const Values& given);

  // Each notes a problem, and gives a harmless value, where a value is not allowed; the name must be that of a row.
  // low, high: the bounds of a value, both allowed.
  const std::vector<std::string>& texts(const std::string& name) const;
  const std::string& text(const std::string& name) const { return texts(name).front(); }
  double number(const std::string& name, double low, double high);
  std::vector<double> numbers(const std::string& name, double low, double high);
  std::int64_t integer(const std::string& name, std::int64_t low, std::int64_t high);
  std::vector<std::int64_t> integers(const std::string& name, std::int64_t low, std::int64_t high);
  /// "0.1", or "0.05:0.2" for the bounds of a range to draw from.
  Range range(const std::string& name, double low, double high);
  /// The index among words of the value.
  std::size_t choice(const std::string& name, const std::vector<std::string>& words);
  /// Notes a problem with an option beyond its bounds, for checks by the kind itself.
  void note(const std::string& name, const std::string& sentence);
  /// The problems noted so far.
  const Problems& problems() const { return problems_; }

  /// All options in the order of their names, as one line of JSON: equal texts are equal options.
  std::string canonical() const;

 private:
  Values values_;
  Problems problems_;
};

}  // namespace underact::sweep
