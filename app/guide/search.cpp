#include "app/guide/search.h"

#include <algorithm>
#include <cctype>

namespace underact::guide {
namespace {

constexpr int kInTitle = 12, kInPageTitle = 5, kInText = 1, kMaxInText = 5, kWhole = 2;
constexpr std::size_t kAround = 60;  // bytes of an excerpt to each side

/// Small letters: of ASCII, and of the Latin and Greek letters that a page may have (two bytes in UTF-8).
std::string lowered(std::string_view text) {
  std::string made(text);
  for (std::size_t i = 0; i < made.size(); ++i) {
    const auto byte = static_cast<unsigned char>(made[i]);
    if (byte < 0x80) made[i] = static_cast<char>(std::tolower(byte));
    if (byte != 0xC3 || i + 1 == made.size()) continue;
    const auto next = static_cast<unsigned char>(made[++i]);
    if (next >= 0x80 && next <= 0x9E && next != 0x97) made[i] = static_cast<char>(next + 0x20);
  }
  return made;
}

bool isInWord(char letter) {
  const auto byte = static_cast<unsigned char>(letter);
  return byte >= 0x80 || std::isalnum(byte) != 0 || letter == '_';
}

std::vector<std::string> sortedWords(std::string_view text) {
  std::vector<std::string> words = searchWords(text);
  std::sort(words.begin(), words.end());
  return words;
}

/// How often a word is among others: each that begins with it, a whole one kWhole times.
int countOf(const std::string& word, const std::vector<std::string>& words, int max) {
  int count = 0;
  for (auto at = std::lower_bound(words.begin(), words.end(), word); at != words.end() && count < max; ++at) {
    if (at->compare(0, word.size(), word) != 0) break;
    count += at->size() == word.size() ? kWhole : 1;
  }
  return std::min(count, max);
}

/// The position of the word in the text, at the start of a word.
std::size_t placeOf(const std::string& word, const std::string& lower) {
  for (std::size_t at = lower.find(word); at != std::string::npos; at = lower.find(word, at + 1)) {
    if (at == 0 || !isInWord(lower[at - 1])) return at;
  }
  return std::string::npos;
}

/// Moved to the start of a code point, so that no letter is cut.
std::size_t atLetter(const std::string& text, std::size_t at) {
  while (at > 0 && at < text.size() && (static_cast<unsigned char>(text[at]) & 0xC0U) == 0x80U) --at;
  return std::min(at, text.size());
}

std::string excerptOf(const std::string& text, const std::vector<std::string>& words) {
  const std::string lower = lowered(text);
  std::size_t at = 0, size = kAround;  // a section that is found by its title alone: its beginning
  for (const std::string& word : words) {
    const std::size_t place = placeOf(word, lower);
    if (place == std::string::npos) continue;
    at = place, size = word.size();
    break;
  }
  const std::size_t from = atLetter(text, at > kAround ? at - kAround : 0);
  const std::size_t end = atLetter(text, std::min(at + size + kAround, text.size()));
  std::string part = text.substr(from, end - from);
  std::replace(part.begin(), part.end(), '\n', ' ');
  return (from > 0 ? "…" : "") + part + (end < text.size() ? "…" : "");
}

}  // namespace

std::vector<std::string> searchWords(std::string_view typed) {
  const std::string lower = lowered(typed);
  std::vector<std::string> words;
  std::string word;
  for (const char letter : lower + " ") {
    if (isInWord(letter)) {
      word += letter;
    } else if (!word.empty()) {
      words.push_back(std::move(word));
      word.clear();
    }
  }
  return words;
}

Search::Search(const Guide& guide) {
  for (const Entry& entry : guide.entries) {
    for (const page::Page::Section& section : entry.page.sections) {
      if (section.title.empty() && section.text.empty()) continue;
      sections_.push_back({{entry.name, entry.page.title, section.anchor, section.title, {}, 0},
                           section.text,
                           sortedWords(section.title),
                           sortedWords(section.text),
                           sortedWords(entry.page.title + " " + entry.name)});
    }
  }
}

std::vector<Hit> Search::find(std::string_view typed, std::size_t max) const {
  const std::vector<std::string> words = searchWords(typed);
  std::vector<Hit> hits;
  if (words.empty()) return hits;
  for (const Section& section : sections_) {
    int score = 0;
    bool has_all = true;
    for (const std::string& word : words) {
      const int in_title = countOf(word, section.title_words, kWhole);
      const int in_text = countOf(word, section.words, kMaxInText);
      const int in_page = countOf(word, section.page_words, kWhole);
      has_all = has_all && in_title + in_text > 0;
      score += kInTitle * in_title + kInText * in_text + kInPageTitle * in_page;
    }
    if (!has_all) continue;
    hits.push_back(section.hit);
    hits.back().score = score;
    hits.back().excerpt = excerptOf(section.text, words);
  }
  std::stable_sort(hits.begin(), hits.end(), [](const Hit& a, const Hit& b) { return a.score > b.score; });
  hits.resize(std::min(hits.size(), max));
  return hits;
}

}  // namespace underact::guide
