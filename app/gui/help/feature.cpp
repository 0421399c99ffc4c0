#include "app/gui/feature/feature.h"

#include <QMainWindow>

#include "app/gui/help/help_dialog.h"

namespace underact::gui {
namespace {

void makeHelp(const FeatureParts& parts, ServoListeners&) {
  addHelpActions(parts.actions, parts.window);
}

}  // namespace

FeatureRow helpFeature() {
  return {.pages = {{"dialog.help", "window#mouse-and-keys"}, {"dialog.about", "safety#what-was-never-tried"}},
          .make = makeHelp};
}

}  // namespace underact::gui
