#pragma once
#include <span>
#include <string>
#include <vector>

#include "tests/support/random.h"

namespace underact::test {

/// A text with one to three changes: a byte, a token, a cut, or a span that comes again.
inline std::string mutated(Random& random, std::string text, std::span<const char* const> tokens) {
  for (std::size_t count = 1 + random.below(3); count > 0; --count) {
    const std::size_t at = random.below(text.size() + 1);
    switch (random.below(4)) {
      case 0:
        text.insert(at, 1, static_cast<char>(random.bits()));
        break;
      case 1:
        text.insert(at, tokens[random.below(tokens.size())]);
        break;
      case 2:
        text.erase(at, random.below(30));
        break;
      default:
        text.insert(random.below(text.size() + 1), text.substr(at, random.below(60)));
    }
  }
  return text;
}

}  // namespace underact::test
