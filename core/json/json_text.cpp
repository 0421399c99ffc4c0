#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>

#include "core/base/printed.h"
#include "core/json/json.h"
#include "core/json/text.h"

namespace underact::json {

std::string numberText(double value) {
  if (!std::isfinite(value)) return "null";
  if (value == 0.0 && std::signbit(value)) return "-0.0";  // Python reads "-0" as an integer, which has no sign
  std::array<char, 32> buffer{};
  const std::to_chars_result written = std::to_chars(buffer.data(), buffer.data() + buffer.size(), value);
  return {buffer.data(), written.ptr};
}

std::string quotedText(std::string_view text) {
  std::string result = "\"";
  for (std::size_t at = 0; at < text.size();) {
    const auto c = static_cast<unsigned char>(text[at]);
    const std::size_t length = codePointLength(text, at);
    if (length == 0) {
      result += "\xEF\xBF\xBD";  // U+FFFD for what is not UTF-8: what is written can always be read
    } else if (c == '"' || c == '\\') {
      result += {'\\', text[at]};
    } else if (controlLength(text, at) > 0) {  // of Unicode, too: a terminal shows JSON as it is written
      result += shownControl(text.substr(at));
    } else {
      result += text.substr(at, length);
    }
    at += std::max<std::size_t>(1, length);
  }
  return result + "\"";
}

}  // namespace underact::json
