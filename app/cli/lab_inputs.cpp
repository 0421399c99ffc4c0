#include "app/cli/lab_inputs.h"

#include <filesystem>
#include <ostream>

#include "app/cli/hands.h"
#include "app/cli/scene_file.h"
#include "app/cli/shipped.h"

namespace underact::cli {
namespace {

std::string stemOf(const std::string& file) {
  return std::filesystem::path(file).stem().string();
}

std::vector<std::string> builtInNames() {
  std::vector<std::string> names;
  for (const sim::BuiltInHand& hand : sim::builtInHands()) names.emplace_back(hand.name);
  return names;
}

}  // namespace

std::optional<std::vector<tradeoff::NamedScene>> labScenes(const std::vector<std::string>& files,
                                                           const Streams& streams, Exit& exit) {
  const Result<std::vector<std::string>> chosen = files.empty() ? shippedScenes() : files;
  if (!chosen) {
    exit = fail(chosen.problems(), Exit::File, streams);
    return {};
  }
  std::vector<tradeoff::NamedScene> scenes;
  for (const std::string& file : chosen.value()) {
    Result<LoadedScene> loaded = loadScene(file, streams);
    if (!loaded) {
      exit = fail(loaded.problems(), streams);
      return {};
    }
    scenes.push_back({stemOf(file), std::move(loaded).value().description});
  }
  return scenes;
}

std::optional<std::vector<tradeoff::NamedHand>> labHands(const std::vector<std::string>& names, std::uint64_t seed,
                                                         const Streams& streams, Exit& exit) {
  std::vector<tradeoff::NamedHand> hands;
  for (const std::string& name : names.empty() ? builtInNames() : names) {
    Result<sim::HandScript> hand = findHand(name, seed);
    if (!hand) {
      exit = fail(hand.problems(), exitOfHand(name, hand.problems()), streams);
      return {};
    }
    hands.push_back({stemOf(name), std::move(hand).value()});
  }
  return hands;
}

}  // namespace underact::cli
