#include "app/gui/feature/feature.h"

#include "app/gui/visitor/visitor_mode.h"

namespace underact::gui {
namespace {

void makeVisitor(const FeatureParts& parts, ServoListeners& listeners) {
  listeners.push_back(new VisitorMode(parts));
}

}  // namespace

FeatureRow visitorFeature() {
  return {.pages = {{"demonstrator", "visitor"}, {"dialog.no_visitors", "visitor"}}, .make = makeVisitor};
}

}  // namespace underact::gui
