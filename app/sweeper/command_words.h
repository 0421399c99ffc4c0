#pragma once
#include <cstdint>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>

#include "core/json/json.h"

namespace underact::sweep {

/// A text as one word of a POSIX shell: as it is, or in single quotes.
std::string shellWord(std::string_view text);

/// A command for a shell, built word by word; numbers read back to the same double.
class CommandWords {
 public:
  explicit CommandWords(std::string program) : text_(std::move(program)) {}
  /// A positional argument, or a flag.
  CommandWords& add(std::string_view word) {
    text_ += " " + shellWord(word);
    return *this;
  }
  /// An option with its value: text or a number.
  template <class Value>
  CommandWords& add(std::string_view option, const Value& value) {
    add(option);
    if constexpr (std::is_integral_v<Value>)
      return add(std::to_string(value));
    else if constexpr (std::is_floating_point_v<Value>)
      return add(json::numberText(value));
    else
      return add(std::string_view(value));
  }
  const std::string& text() const { return text_; }

 private:
  std::string text_;
};

}  // namespace underact::sweep
