#include "app/gui/feature/feature.h"

#include "app/gui/visitor/visitor_mode.h"

namespace underact::gui {
namespace {

void makeVisitor(const FeatureParts& parts, ServoListeners& listeners) {
  listeners.push_back(new VisitorMode(parts));
}

}  // namespace

FeatureRow visitorFeature() {
  return {.pages = {{"demonstrator", "classes#visitors"}, {"dialog.no_visitors", "classes#visitors"}},
          .make = makeVisitor};
}

}  // namespace underact::gui
