#include "app/gui/feature/feature.h"

#include "app/gui/welcome/tour.h"
#include "app/gui/welcome/welcome.h"

namespace underact::gui {
namespace {

void makeWelcome(const FeatureParts& parts, ServoListeners& listeners) {
  listeners.push_back(new Welcome(parts));
  listeners.push_back(new Tour(parts.view, parts.actions, parts.window));
}

}  // namespace

FeatureRow welcomeFeature() {
  return {.pages = {{"welcome", "window#at-the-first-start"}, {"tour", "window#at-the-first-start"}},
          .make = makeWelcome};
}

}  // namespace underact::gui
