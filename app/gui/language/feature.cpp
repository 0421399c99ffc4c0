#include "app/gui/feature/feature.h"

#include <QMainWindow>

#include "app/gui/language/language_actions.h"

namespace underact::gui {
namespace {

void makeLanguage(const FeatureParts& parts, ServoListeners&) {
  addLanguageActions(parts.actions, parts.window);
}

}  // namespace

FeatureRow languageFeature() {
  return {.pages = {{"dialog.language", "window#language"}}, .make = makeLanguage};
}

}  // namespace underact::gui
