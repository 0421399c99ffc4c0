#pragma once
#include <cstddef>

namespace underact::json {

/// The words of a file for the values of an enumeration; the first is the default.
template <class Enum>
struct Word {
  const char* word;
  Enum value;
};

/// The word of a value; of one that has none, the first.
template <class Enum, std::size_t kCount>
const char* wordOf(const Word<Enum> (&words)[kCount], Enum value) {
  for (const Word<Enum>& word : words) {
    if (word.value == value) return word.word;
  }
  return words[0].word;
}

}  // namespace underact::json
