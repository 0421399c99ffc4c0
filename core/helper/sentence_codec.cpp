#include "core/helper/sentence_codec.h"

#include <algorithm>
#include <vector>

namespace underact::helper {
namespace {

// The format: number of places, pattern, end of line; then the sentences in its places, likewise.
constexpr char kEnd = '\n';
constexpr int kMaxPlaces = 9;

std::string plain(std::string text) {
  for (char& c : text) c = c >= ' ' && c <= '~' ? c : '?';
  return text;
}

std::string allLettersOf(const Sentence& sentence) {
  std::string text(1, static_cast<char>('0' + sentence.places().size()));
  text += plain(sentence.pattern().empty() ? std::string(sentence) : sentence.pattern()) + kEnd;
  for (const Sentence& place : sentence.places()) text += allLettersOf(place);
  return text;
}

/// The length of a filled pattern, before it is filled: each place may occur many times.
std::size_t lengthOf(std::string_view pattern, const std::vector<Sentence>& places) {
  std::size_t length = pattern.size();
  for (std::size_t at = 0; at + 1 < pattern.size(); ++at) {
    const auto place = static_cast<std::size_t>(pattern[at + 1] - '1');
    if (pattern[at] == '%' && pattern[at + 1] >= '1' && place < places.size()) length += places[place].size();
  }
  return length;
}

/// The first sentence of the letters, which are taken off.
std::optional<Sentence> take(std::string_view& letters, int nested) {
  const std::size_t end = letters.find(kEnd);
  if (nested > kMaxNested || end == std::string_view::npos || end == 0) return {};
  const int places = letters.front() - '0';
  const std::string pattern = plain(std::string(letters.substr(1, end - 1)));
  letters.remove_prefix(end + 1);
  if (places < 0 || places > kMaxPlaces) return {};
  std::vector<Sentence> in_places;
  for (int place = 0; place < places; ++place) {
    std::optional<Sentence> one = take(letters, nested + 1);
    if (!one) return {};
    in_places.push_back(std::move(*one));
  }
  if (lengthOf(pattern, in_places) > kLongestSentence) return {};
  return phrase(pattern, std::move(in_places));
}

}  // namespace

std::string encodeSentence(const Sentence& sentence) {
  if (sentence.empty()) return {};
  const std::string letters = allLettersOf(sentence);
  if (letters.size() <= kMaxLetters) return letters;
  return allLettersOf(Sentence(sentence.substr(0, kMaxLetters - 2)));  // in English alone, as far as it goes
}

std::optional<Sentence> decodeSentence(std::string_view letters) {
  if (letters.empty()) return Sentence();
  if (letters.size() > kMaxLetters) return {};
  std::optional<Sentence> sentence = take(letters, 1);
  return letters.empty() ? sentence : std::nullopt;
}

}  // namespace underact::helper
