#pragma once
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "core/base/sentence.h"

namespace underact {

/// The place of a problem: a file (or its substitute), line and column from 1 (0: none), and the path of a key.
struct SourceLocation {
  std::string file = {};
  int line = 0;
  int column = 0;
  std::string key = {};
};

/// What is wrong, in a sentence that its reader can act on, and where.
struct Problem {
  Sentence sentence;
  SourceLocation place = {};
};

/// All problems at once, not only the first.
using Problems = std::vector<Problem>;

/// A value, or the problems that prevented it. For set-up; a tick gives a Fault instead.
template <class T>
class [[nodiscard]] Result {
 public:
  /// Success; a return of the value converts by itself.
  Result(T value) : content_(std::move(value)) {}
  /// Failure. problems: at least one.
  Result(Problems problems) : content_(std::move(problems)) {}
  /// Whether there is a value.
  explicit operator bool() const { return std::holds_alternative<T>(content_); }
  /// The value. Only where there is one: otherwise std::bad_variant_access is thrown, which nobody catches.
  const T& value() const& { return std::get<T>(content_); }
  T& value() & { return std::get<T>(content_); }
  T&& value() && { return std::get<T>(std::move(content_)); }
  /// What is wrong. Only where there is no value.
  const Problems& problems() const { return std::get<Problems>(content_); }

 private:
  std::variant<T, Problems> content_;
};

/// "FILE:LINE:COLUMN: error: KEY: sentence", the line that compilers print and editors jump to.
std::string describe(const Problem& problem);

}  // namespace underact
