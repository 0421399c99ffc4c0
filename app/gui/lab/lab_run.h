#pragma once
#include <vector>

#include "app/gui/kit/background.h"
#include "core/trade/front.h"
#include "core/trade/standing.h"

namespace underact::gui {

/// What is measured: a scene as it is, its meshes loaded, at the servo's rate, in some hands.
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

/// All of it, in any thread; where the state is cancelled it ends soon, and what came of it is a part.
LabResult measureLab(const LabOrder& order, WorkState& state);

/// The built-in hands, or the one of that name; none: there is no such one.
std::vector<trade::NamedHand> handsOf(const std::string& name);

}  // namespace underact::gui
