#pragma once
#include <optional>
#include <string>
#include <string_view>

#include "core/base/sentence.h"

namespace underact::helper {

/// Of a sentence on its way from a helper: no more letters than these, and none beyond those of plain English.
inline constexpr std::size_t kMostLetters = 500;

/// The sentence with its patterns, so that a window can say it in its language. No more than kMostLetters: what is too
/// long is cut, and is then plain English.
std::string lettersOf(const Sentence& sentence);

/// Trusts nothing: none where a sentence has sentences in its places more than kMostNested deep, or would grow to more
/// than kLongestSentence when its places are filled, or where letters are left over. Empty of no letters.
std::optional<Sentence> sentenceOf(std::string_view letters);
inline constexpr int kMostNested = 8;
inline constexpr std::size_t kLongestSentence = 1000;

}  // namespace underact::helper
