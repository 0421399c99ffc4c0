#pragma once
#include <optional>
#include <string>
#include <string_view>

#include "core/base/sentence.h"

namespace underact::helper {

/// The greatest number of characters of a sentence sent by a helper, all of them those of plain English.
inline constexpr std::size_t kMaxLetters = 500;

/// The sentence with its patterns, so that a window can translate it. One longer than kMaxLetters is cut, and is then
/// plain English.
std::string encodeSentence(const Sentence& sentence);

/// The sentence of such characters, which are not trusted: none where sentences are nested more than kMaxNested deep,
/// where it would grow beyond kLongestSentence, or where characters are left over. Of no characters, an empty one.
std::optional<Sentence> decodeSentence(std::string_view letters);
inline constexpr int kMaxNested = 8;
inline constexpr std::size_t kLongestSentence = 1000;

}  // namespace underact::helper
