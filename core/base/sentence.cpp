#include "core/base/sentence.h"

#include "core/base/translate.h"

namespace underact {

std::string filled(std::string_view pattern, const std::vector<std::string>& words) {
  std::string made;
  for (std::size_t at = 0; at < pattern.size(); ++at) {
    const bool is_place =
        pattern[at] == '%' && at + 1 < pattern.size() && pattern[at + 1] >= '1' && pattern[at + 1] <= '9';
    const std::size_t number = is_place ? static_cast<std::size_t>(pattern[at + 1] - '1') : words.size();
    if (number < words.size()) {
      made += words[number];
      ++at;
    } else {
      made += pattern[at];
    }
  }
  return made;
}

Sentence said(std::string pattern, std::vector<Sentence> places) {
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

Sentence oneAfterAnother(const std::vector<Sentence>& sentences) {
  Sentence all;
  for (const Sentence& one : sentences) {
    if (!one.empty()) all = all.empty() ? one : said(QT_TRANSLATE_NOOP("problem", "%1 %2"), {all, one});
  }
  return all;
}

}  // namespace underact
