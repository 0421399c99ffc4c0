#include "app/gui/feature/feature.h"

#include "app/gui/registration/registration_tool.h"

namespace underact::gui {
namespace {

void makeRegistration(const FeatureParts& parts, ServoListeners& listeners) {
  listeners.push_back(new RegistrationTool(parts));
}

}  // namespace

FeatureRow registrationFeature() {
  return {.pages = {{"registration", "registration"}, {"dialog.registration_sheet", "registration"}},
          .make = makeRegistration};
}

}  // namespace underact::gui
