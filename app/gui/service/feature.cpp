#include "app/gui/feature/feature.h"

#include "app/gui/service/live_service.h"

namespace underact::gui {
namespace {

void makeService(const FeatureParts& parts, ServoListeners& listeners) {
  listeners.push_back(new LiveService(parts.actions, parts.steered, parts.window));
}

}  // namespace

FeatureRow serviceFeature() {
  return {.pages = {{"status.service", "live_service#in-the-window"}}, .make = makeService};
}

}  // namespace underact::gui
