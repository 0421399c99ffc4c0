#pragma once
#include <string>
#include <vector>

#include "core/trade/table.h"

namespace underact::trade {

/// One choice of one scene: all that could be chosen, measured, and so where the scene stands in it.
struct Standing {
  const Choice* choice = nullptr;
  Settings base;                 // with which all was measured but for what the choice is about
  std::vector<Summary> options;  // those with a way to run; what the scene has is kAsItIs, where it is none of them
};
inline constexpr const char* kAsItIs = "as it is";

/// What was measured of the option that the settings have; null: it was not.
const Summary* measuredOf(const Standing& standing, const Settings& settings);

/// The one that is recommended; null: none is within the bound.
const Summary* recommendedOf(const Standing& standing);

/// In words, what the settings have in what the choice is about: "1000 Hz", "low-pass, tau_ms 1.6".
std::string valueText(const Choice& choice, const scene::Description& scene, const Settings& settings);

/// Each choice that the scene offers, each by itself, the rest as the scene has it at the servo's rate. scene: with its
/// meshes loaded. What goes_on() ended early holds the choices that were done.
std::vector<Standing> measureStandings(const scene::Description& scene, const std::vector<NamedHand>& hands,
                                       double seconds, int rate_hz, const Progress& goes_on);

}  // namespace underact::trade
