#include "app/gui/feature/feature.h"

#include "app/gui/compare/compare_tool.h"

namespace underact::gui {
namespace {

void makeCompare(const FeatureParts& parts, ServoListeners& listeners) {
  listeners.push_back(new CompareTool(parts));
}

}  // namespace

FeatureRow compareFeature() {
  return {.pages = {{"compare", "classes#two-scenes-on-one-motion"},
                    {"dialog.compare_scene", "classes#two-scenes-on-one-motion"}},
          .make = makeCompare};
}

}  // namespace underact::gui
