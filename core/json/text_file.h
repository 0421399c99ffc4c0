#pragma once
#include <cstddef>
#include <string>

#include "core/base/result.h"

namespace underact::json {

inline constexpr std::size_t kLargestFile = std::size_t{16} << 20;

/// All of a file of at most `largest` bytes. what: for the sentence, as "a scene". Problems: one, without a line: those
/// of NamedFile::open() and readAll(). Never waits: a pipe is refused.
Result<std::string> readTextFile(const std::string& path, const Sentence& what, std::size_t largest = kLargestFile);

}  // namespace underact::json
