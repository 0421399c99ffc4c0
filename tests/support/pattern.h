#pragma once
#include <cstddef>
#include <string>
#include <vector>

namespace underact::test {

struct PatternMatch {
  std::size_t at = 0;               // where it begins in the text
  std::vector<std::string> groups;  // all of it, then each group; empty: one that took no part
};

/// Wherever a pattern, of ECMAScript, is found in a text, one after the other. Here for all tests, as <regex> takes
/// seconds of the compiler's time wherever it is included. Throws std::regex_error for what is no pattern.
std::vector<PatternMatch> matchesOf(const std::string& pattern, const std::string& text);

}  // namespace underact::test
