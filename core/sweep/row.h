#pragma once
#include <concepts>
#include <cstddef>
#include <string>
#include <string_view>

namespace underact::sweep {

/// One line of the result, built field by field, as CSV.
class SweepRow {
 public:
  /// A number that reads back to the same double; "nan", "inf" and "-inf" where it is not finite.
  void add(double value);
  void add(std::integral auto value) { addRaw(std::to_string(value)); }
  /// A text, in quotes where it has a comma, a quote or a space at an end (RFC 4180). Line ends become spaces, since a
  /// row is one line.
  void add(std::string_view text);
  void add(const char* text) { add(std::string_view(text)); }
  void add(const std::string& text) { add(std::string_view(text)); }

  std::size_t fields() const { return fields_; }
  const std::string& text() const { return text_; }

 private:
  void addRaw(std::string_view field);
  std::string text_;
  std::size_t fields_ = 0;
};

}  // namespace underact::sweep
