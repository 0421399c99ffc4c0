#include "tests/error_bounds/input.h"

#include <array>
#include <charconv>
#include <sstream>

namespace underact::error_bounds {

std::string textOf(double number) {
  if (number != number) return "nan";  // regardless of its sign and payload
  std::array<char, 40> text{};
  const auto end = std::to_chars(text.data(), text.data() + text.size(), number);
  return {text.data(), end.ptr};
}

std::string Input::words() const {
  std::istringstream names(name_);
  std::string all;
  for (const double number : numbers_) {
    std::string name;
    names >> name;
    all += (all.empty() ? "" : " ") + name + " " + textOf(number);
  }
  return all;
}

}  // namespace underact::error_bounds
