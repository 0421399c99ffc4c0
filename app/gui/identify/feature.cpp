#include "app/gui/feature/feature.h"

#include "app/gui/identify/identify_tool.h"

namespace underact::gui {
namespace {

void makeIdentify(const FeatureParts& parts, ServoListeners& listeners) {
  listeners.push_back(new IdentifyTool(parts));
}

}  // namespace

FeatureRow identifyFeature() {
  return {.pages = {{"identify", "identify"}, {"dialog.arm_problems", "devices"}}, .make = makeIdentify};
}

}  // namespace underact::gui
