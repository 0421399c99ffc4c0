#pragma once
#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/result.h"
#include "core/base/sentence.h"

namespace underact::json {

/// Bytes of the UTF-8 code point that starts at `at`; 0 where it is invalid (overlong, a surrogate, cut off).
std::size_t codePointLength(std::string_view text, std::size_t at);

/// The double nearest to a number as JSON writes it, whatever the locale; infinite where it is too large, 0 where too
/// small.
double numberOf(std::string_view text);

/// The finite number that all of a text is, as C writes it; none where it is no such number.
std::optional<double> wholeNumber(std::string_view text);

/// What a file says, in quotes and cut short, for use in a sentence.
std::string shown(std::string_view text);

/// A key as it stands in the path of a key: itself, or in quotes and cut short where it is no name.
std::string plainKey(std::string_view key);

/// The known word nearest to `word`; empty where none is near, or `word` is longer than 64 bytes. Cost: at most 2000
/// steps a known word. Readers of files ask by Findings::nearest(), which asks a few times only.
std::string nearestWord(std::string_view word, const std::vector<std::string>& known);

/// "a", "b" or "c"; last: the word before the last of them, "or" or "and".
Sentence listed(const std::vector<std::string>& words, const char* last = "or");

inline constexpr std::size_t kLargestFile = std::size_t{16} << 20;

/// All of a file of at most `largest` bytes. what: for the sentence, as "a scene". Problems: one, without a line: those
/// of NamedFile::open(), readAll() and foreignKind(). Never waits: a pipe is refused.
Result<std::string> readTextFile(const std::string& path, const Sentence& what, std::size_t largest = kLargestFile);

}  // namespace underact::json
