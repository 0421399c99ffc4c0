#include "app/gui/feature/feature.h"

#include "app/gui/projector/projector.h"

namespace underact::gui {
namespace {

void makeProjector(const FeatureParts& parts, ServoListeners& listeners) {
  listeners.push_back(new Projector(parts.actions, parts.view, parts.theme, parts.window));
}

}  // namespace

FeatureRow projectorFeature() {
  return {.make = makeProjector};
}

}  // namespace underact::gui
