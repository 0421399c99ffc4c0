#pragma once
#include <vector>

#include "app/gui/kit/background.h"
#include "core/trade/front.h"
#include "core/trade/standing.h"

namespace underact::gui {

/// The order for a measurement: a scene with its meshes loaded, the servo's rate, and the hands.
struct LabOrder {
  scene::Description scene;
  std::vector<trade::NamedHand> hands;
  double seconds = 2.0;  // of each run
  int rate_hz = 1000;

  trade::Settings own() const { return trade::settingsOf(scene, rate_hz); }
};

struct LabResult {
  std::vector<trade::Point> points;  // the cheapest first; none: the finest run, or every other, ended in a fault
  std::vector<trade::Standing> standings;
};

/// The whole measurement, in any thread. When cancelled it ends soon, and the result is incomplete.
LabResult measureLab(const LabOrder& order, WorkState& state);

/// All built-in hands for an empty name, else the one of that name; empty if there is none.
std::vector<trade::NamedHand> handsOf(const std::string& name);

}  // namespace underact::gui
