#include "core/base/sentence.h"

#include <charconv>
#include <cmath>

#include "core/base/translate.h"

namespace underact {

std::string filled(std::string_view pattern, const std::vector<std::string>& words) {
  std::string made;
  for (std::size_t at = 0; at < pattern.size(); ++at) {
    const bool is_place =
        pattern[at] == '%' && at + 1 < pattern.size() && pattern[at + 1] >= '1' && pattern[at + 1] <= '9';
    const std::size_t number = is_place ? static_cast<std::size_t>(pattern[at + 1] - '1') : words.size();
    if (number < words.size()) {
      const bool is_vowel = words[number].find_first_of("aeio") == 0;
      if (is_vowel && (made == "A " || made == "a " || made.ends_with(" a "))) made.insert(made.size() - 1, "n");
      made += words[number];
      ++at;
    } else {
      made += pattern[at];
    }
  }
  return made;
}

Sentence phrase(std::string pattern, std::vector<Sentence> places) {
  Sentence sentence(filled(pattern, {places.begin(), places.end()}));
  sentence.pattern_ = std::move(pattern);
  sentence.places_ = std::move(places);
  return sentence;
}

Sentence shownNumber(std::string digits) {
  Sentence number(std::move(digits));
  number.is_number_ = true;
  return number;
}

Sentence shownNumber(double value, int decimals) {
  if (!std::isfinite(value)) return shownNumber("–");
  char text[400];  // of the largest double, too
  const double rounded = std::abs(value) < 0.5 * std::pow(10.0, -decimals) ? 0.0 : value;
  const auto end = std::to_chars(text, text + sizeof text, rounded, std::chars_format::fixed, decimals).ptr;
  return shownNumber(std::string(text, end));
}

Sentence oneAfterAnother(const std::vector<Sentence>& sentences) {
  Sentence all;
  for (const Sentence& one : sentences) {
    if (!one.empty()) all = all.empty() ? one : phrase(TRANSLATE_NOOP("problem", "%1 %2"), {all, one});
  }
  return all;
}

}  // namespace underact
