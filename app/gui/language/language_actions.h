#pragma once

class QWidget;

namespace underact::gui {

class Actions;

/// language.system, language.en, language.de: the language from the next start on. window: parent of the message.
void addLanguageActions(Actions& actions, QWidget* window);

}  // namespace underact::gui
