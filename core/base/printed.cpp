#include "core/base/printed.h"

#include <algorithm>

namespace underact {
namespace {

/// The number of the character at `at`, and its bytes; 0 bytes: this is not UTF-8. Source: RFC 3629, section 4.
struct Character {
  unsigned number = 0;
  std::size_t bytes = 0;
};
Character characterAt(std::string_view text, std::size_t at) noexcept {
  const auto lead = static_cast<unsigned char>(text[at]);
  if (lead < 0x80) return {lead, 1};
  const std::size_t bytes = lead >= 0xF5 ? 0 : lead >= 0xF0 ? 4 : lead >= 0xE0 ? 3 : lead >= 0xC2 ? 2 : 0;
  if (bytes == 0 || at + bytes > text.size()) return {};
  unsigned number = lead & (0x7FU >> bytes);
  for (std::size_t next = at + 1; next < at + bytes; ++next) {
    const auto tail = static_cast<unsigned char>(text[next]);
    if ((tail & 0xC0U) != 0x80U) return {};
    number = number << 6U | (tail & 0x3FU);
  }
  const bool is_overlong = number < (bytes == 3 ? 0x800U : bytes == 4 ? 0x10000U : 0x80U);
  return is_overlong || (number >> 11U) == 0x1B || number > 0x10FFFF ? Character{} : Character{number, bytes};
}

bool isControl(unsigned number) noexcept {
  const auto within = [number](unsigned first, unsigned last) { return number >= first && number <= last; };
  return number < 0x20 || within(0x7F, 0x9F) || number == 0x061C || within(0x200E, 0x200F) || within(0x2028, 0x202E) ||
         within(0x2066, 0x2069);
}

}  // namespace

std::size_t characterLength(std::string_view text, std::size_t at) noexcept {
  return at < text.size() ? characterAt(text, at).bytes : 0;
}

std::size_t controlLength(std::string_view text, std::size_t at) noexcept {
  const Character here = characterAt(text, at);
  return isControl(here.number) ? here.bytes : 0;
}

std::string shownControl(std::string_view text) {
  constexpr const char* kDigits = "0123456789abcdef";
  const unsigned number = characterAt(text, 0).number;
  if (number == '\n') return "\\n";
  if (number == '\t') return "\\t";
  if (number == '\r') return "\\r";
  std::string shown = "\\u";
  for (unsigned shift = 16; shift > 0; shift -= 4) shown += kDigits[number >> (shift - 4) & 15U];
  return shown;
}

std::string printed(std::string_view words) {
  std::string text;
  text.reserve(words.size());
  for (std::size_t at = 0; at < words.size();) {
    const std::size_t bytes = characterLength(words, at);
    if (bytes == 0)
      text += "\xEF\xBF\xBD";
    else
      text += controlLength(words, at) > 0 ? shownControl(words.substr(at)) : std::string(words.substr(at, bytes));
    at += std::max<std::size_t>(1, bytes);
  }
  return text;
}

}  // namespace underact
