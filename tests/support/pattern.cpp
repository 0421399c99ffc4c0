#include "tests/support/pattern.h"

#include <regex>

namespace underact::test {

std::vector<PatternMatch> matchesOf(const std::string& pattern, const std::string& text) {
  const std::regex compiled(pattern);
  std::vector<PatternMatch> matches;
  for (std::sregex_iterator match(text.begin(), text.end(), compiled), end; match != end; ++match) {
    PatternMatch& next = matches.emplace_back();
    next.at = static_cast<std::size_t>(match->position());
    for (const auto& group : *match) next.groups.push_back(group.str());
  }
  return matches;
}

}  // namespace underact::test
