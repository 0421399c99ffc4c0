#include "app/gui/feature/feature.h"

#include "app/gui/fault/fault_watch.h"

namespace underact::gui {
namespace {

void makeFault(const FeatureParts& parts, ServoListeners& listeners) {
  listeners.push_back(new FaultWatch(parts));
}

}  // namespace

FeatureRow faultFeature() {
  return {.pages = {{"dialog.fault", "faults"}}, .make = makeFault};
}

}  // namespace underact::gui
