#pragma once
#include <vector>

#include "app/gui/kit/background.h"
#include "core/tradeoff/choice_result.h"
#include "core/tradeoff/front.h"

namespace underact::gui {

/// The order for a measurement: a scene with its meshes loaded, the servo's rate, and the hands.
struct LabOrder {
  scene::Description scene;
  std::vector<tradeoff::NamedHand> hands;
  double seconds = 2.0;  // of each run
  int rate_hz = 1000;

  tradeoff::Settings own() const { return tradeoff::settingsOf(scene, rate_hz); }
};

struct LabResult {
  std::vector<tradeoff::Point> points;  // the cheapest first; none: the finest run, or every other, ended in a fault
  std::vector<tradeoff::ChoiceResult> choice_results;
};

/// The whole measurement, in any thread. When cancelled it ends soon, and the result is incomplete.
LabResult measureLab(const LabOrder& order, WorkState& state);

/// All built-in hands for an empty name, else the one of that name; empty if there is none.
std::vector<tradeoff::NamedHand> handsOf(const std::string& name);

}  // namespace underact::gui
