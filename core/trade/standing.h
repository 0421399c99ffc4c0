#pragma once
#include <string>
#include <vector>

#include "core/trade/table.h"

namespace underact::trade {

/// One choice of one scene, with all its options measured, and the scene's own among them.
struct Standing {
  const Choice* choice = nullptr;
  Settings base;                 // of all measurements, except for what the choice affects
  std::vector<Summary> options;  // those that can be run; the scene's own is kAsItIs if it is none of them
};
inline constexpr const char* kAsItIs = "as it is";

/// The measurement of the option in the settings; null: it was not measured.
const Summary* measuredOf(const Standing& standing, const Settings& settings);

/// The one that is recommended; null: none is within the bound.
const Summary* recommendedOf(const Standing& standing);

/// The option in the settings, in words: "1000 Hz", "low-pass, tau_ms 1.6".
std::string valueText(const Choice& choice, const scene::Description& scene, const Settings& settings);

/// Each choice that the scene offers, on its own, with the other settings of the scene at the servo's rate. scene: with
/// its meshes loaded. What goes_on() ended early holds the choices that were done.
std::vector<Standing> measureStandings(const scene::Description& scene, const std::vector<NamedHand>& hands,
                                       double seconds, int rate_hz, const Progress& goes_on);

}  // namespace underact::trade
