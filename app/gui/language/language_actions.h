#pragma once

class QWidget;

namespace underact::gui {

class Actions;

/// language.system, language.en, language.de: which language the next window speaks; window is told of it.
void addLanguageActions(Actions& actions, QWidget* window);

}  // namespace underact::gui
