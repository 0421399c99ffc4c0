#include "app/cli/hands.h"

#include <algorithm>
#include <filesystem>
#include <span>
#include <utility>

#include "app/cli/scene_file.h"
#include "core/json/text.h"

namespace underact::cli {
namespace {

bool isBuiltIn(const std::string& hand) {
  const std::span<const sim::BuiltInHand> hands = sim::builtInHands();
  return std::any_of(hands.begin(), hands.end(), [&](const sim::BuiltInHand& one) { return hand == one.name; });
}

/// Text that does not look like a file is taken as a name, so that the answer to a typo lists the names.
bool isFileName(const std::string& hand) {
  return hand.find_first_of("./\\") != std::string::npos || std::filesystem::exists(hand);
}

}  // namespace

Result<sim::HandScript> findHand(const std::string& hand, std::uint64_t seed) {
  if (isBuiltIn(hand) || !isFileName(hand)) return sim::builtInHand(hand, seed);
  return sim::readHandFile(hand);
}

std::string contentOfHand(const std::string& hand) {
  if (isBuiltIn(hand) || !isFileName(hand)) return {};
  Result<std::string> text = json::readTextFile(hand, "a hand");
  return text ? std::move(text).value() : std::string();
}

Exit exitOfHand(const std::string& hand, const Problems& problems) {
  return isFileName(hand) ? exitOf(problems) : Exit::Usage;
}

}  // namespace underact::cli
