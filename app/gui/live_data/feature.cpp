#include "app/gui/feature/feature.h"

#include <QMainWindow>

#include "app/gui/live_data/live_data.h"

namespace underact::gui {
namespace {

void makeLive(const FeatureParts& parts, ServoListeners& listeners) {
  listeners.push_back(
      new LiveData(parts.servo, parts.rate, parts.recording, parts.status, parts.actions, parts.window));
}

}  // namespace

FeatureRow liveDataFeature() {
  return {.pages = {{"dialog.live", "live_data"}, {"dialog.address", "window#this-guide"}}, .make = makeLive};
}

}  // namespace underact::gui
