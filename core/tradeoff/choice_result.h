#pragma once
#include <string>
#include <vector>

#include "core/tradeoff/table.h"

namespace underact::tradeoff {

/// One choice for one scene: all options, measured, and the one that the scene has.
struct ChoiceResult {
  const Choice* choice = nullptr;
  Settings base;                 // the settings common to all options
  std::vector<Summary> options;  // those that can be run; kAsItIs for the scene's own value, if not among them
};
inline constexpr const char* kAsItIs = "as it is";

/// The measurement of the option that the settings have; null: none.
const Summary* measuredOf(const ChoiceResult& choice_result, const Settings& settings);

/// The recommended option; null: none is within the bound.
const Summary* recommendedOf(const ChoiceResult& choice_result);

/// The value of the choice in the settings, in words: "1000 Hz", "low-pass, tau_ms 1.6".
std::string valueText(const Choice& choice, const scene::Description& scene, const Settings& settings);

/// Measures each choice that applies to the scene, with all other settings as in the scene and at the servo's rate.
/// scene: with its meshes loaded. If goes_on() ended it early, the result holds the choices that were done.
std::vector<ChoiceResult> measureChoices(const scene::Description& scene, const std::vector<NamedHand>& hands,
                                         double seconds, int rate_hz, const Progress& goes_on);

}  // namespace underact::tradeoff
