#include "app/gui/feature/feature.h"

#include <QMainWindow>

#include "app/gui/fault/fault_watch.h"

namespace underact::gui {
namespace {

void makeFault(const FeatureParts& parts, ServoListeners& listeners) {
  listeners.push_back(new FaultWatch(parts.servo, parts.control, parts.rate, parts.actions, parts.window));
}

}  // namespace

FeatureRow faultFeature() {
  return {.pages = {{"dialog.fault", "faults"}}, .make = makeFault};
}

}  // namespace underact::gui
