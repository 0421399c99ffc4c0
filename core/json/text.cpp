#include "core/json/text.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstdint>
#include <limits>
#include <numeric>

#include "core/base/foreign_file.h"
#include "core/base/printed.h"
#include "core/base/translate.h"
#include "core/base/types.h"
#include "core/json/json.h"
#include "core/system/named_file.h"

namespace underact::json {
namespace {

constexpr std::size_t kLongestShown = 40;  // code points
constexpr std::size_t kLongestWord = 64;   // bytes; longer ones are not typing errors
constexpr std::size_t kMaxEdits = 12;      // nor are more differences than these

/// Whether a number outside the range of double is too large rather than too small: by the position of its first digit.
bool isLarge(std::string_view number) {
  const std::size_t exponent_at = std::min(number.find_first_of("eE"), number.size());
  const std::string_view digits = number.substr(0, exponent_at);
  const std::size_t first = digits.find_first_of("123456789");
  if (first == std::string_view::npos) return false;
  const std::size_t point = std::min(digits.find('.'), digits.size());
  const auto before = static_cast<std::int64_t>(point) - static_cast<std::int64_t>(first);
  std::string_view exponent = number.substr(std::min(exponent_at + 1, number.size()));
  if (!exponent.empty() && exponent.front() == '+') exponent.remove_prefix(1);
  std::int64_t power = 0;
  const std::from_chars_result read = std::from_chars(exponent.data(), exponent.data() + exponent.size(), power);
  if (read.ec == std::errc::result_out_of_range) return exponent.front() != '-';
  return power > -before;
}

char lower(char c) {
  return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
}

/// The Levenshtein distance, ignoring case, where it is at most `most`; otherwise a greater number. Only the band
/// beside the diagonal can matter then, so the cost is that of the shorter word times `most`.
std::size_t editDistance(std::string_view a, std::string_view b, std::size_t max) {
  if (std::max(a.size(), b.size()) - std::min(a.size(), b.size()) > max) return max + 1;
  std::vector<std::size_t> row(b.size() + 1, max + 1);
  std::iota(row.begin(), row.begin() + static_cast<std::ptrdiff_t>(std::min(b.size(), max) + 1), std::size_t{0});
  for (std::size_t i = 0; i < a.size(); ++i) {
    const std::size_t first = i > max ? i - max : 0;
    std::size_t diagonal = row[first];
    row[first] = first == 0 ? i + 1 : max + 1;
    for (std::size_t j = first; j < std::min(b.size(), i + max + 1); ++j) {
      const std::size_t changed = diagonal + (lower(a[i]) == lower(b[j]) ? 0 : 1);
      diagonal = row[j + 1];
      row[j + 1] = std::min({changed, row[j] + 1, row[j + 1] + 1});
    }
  }
  return row.back();
}

std::string_view stem(std::string_view word) {
  return word.substr(0, word.find('_'));
}

}  // namespace

std::size_t codePointLength(std::string_view text, std::size_t at) {
  return characterLength(text, at);
}

double numberOf(std::string_view text) {
  double number = 0.0;
  const std::from_chars_result read = std::from_chars(text.data(), text.data() + text.size(), number);
  if (read.ec != std::errc::result_out_of_range) return number;
  return std::copysign(isLarge(text) ? kInfinity : 0.0, text.front() == '-' ? -1.0 : 1.0);
}

std::optional<double> wholeNumber(std::string_view text) {
  double number = 0.0;
  const std::from_chars_result read = std::from_chars(text.data(), text.data() + text.size(), number);
  if (read.ec != std::errc() || read.ptr != text.data() + text.size() || !std::isfinite(number)) return std::nullopt;
  return number;
}

std::string shown(std::string_view text) {
  std::size_t end = 0;
  for (std::size_t count = 0; count < kLongestShown && end < text.size(); ++count) {
    end += std::max<std::size_t>(1, codePointLength(text, end));
  }
  return quotedText(end < text.size() ? std::string(text.substr(0, end)) + "..." : std::string(text));
}

std::string plainKey(std::string_view key) {
  const bool plain = key.size() <= kLongestWord && std::all_of(key.begin(), key.end(), [](char c) {
                       return (c >= '0' && c <= '9') || (lower(c) >= 'a' && lower(c) <= 'z') || c == '_' || c == '$';
                     });
  return plain ? std::string(key) : shown(key);
}

std::string nearestWord(std::string_view word, const std::vector<std::string>& known) {
  std::string nearest;
  std::size_t best = std::numeric_limits<std::size_t>::max();
  if (word.empty() || word.size() > kLongestWord) return nearest;
  const std::size_t max = word.size() < 4 ? 1 : std::clamp<std::size_t>(word.size() / 3, 2, kMaxEdits);
  for (const std::string& candidate : known) {
    const bool same_stem = stem(word) == stem(candidate);
    const bool shorter = word == stem(candidate);  // radius for radius_mm, kp for kp_N_per_mm
    const std::size_t distance = shorter ? 0 : editDistance(word, candidate, max);
    if (distance > max) continue;
    const std::size_t cost = distance + (same_stem ? 0 : 2);  // kd_N_per_mm is a slip for kd_..., not for kp_...
    if (cost >= best) continue;
    best = cost;
    nearest = candidate;
  }
  return nearest;
}

Sentence listed(const std::vector<std::string>& words, const char* last) {
  if (words.empty()) return {};
  std::string before;
  for (std::size_t index = 0; index + 1 < words.size(); ++index)
    before += (index == 0 ? "" : ", ") + quotedText(words[index]);
  if (before.empty()) return quotedText(words.back());
  return phrase(
      last == std::string_view("or") ? TRANSLATE_NOOP("problem", "%1 or %2") : TRANSLATE_NOOP("problem", "%1 and %2"),
      {before, quotedText(words.back())});
}

Result<std::string> readTextFile(const std::string& path, const Sentence& what, std::size_t largest) {
  const Result<system::NamedFile> file = system::NamedFile::open(path, what);
  if (!file) return file.problems();
  Result<std::string> text = file.value().readAll(largest);
  if (Sentence foreign = text ? foreignKind(text.value()) : Sentence(); !foreign.empty())
    return Problems{{std::move(foreign), {path}}};
  return text;
}

}  // namespace underact::json
