#include "app/gui/language/language_actions.h"

#include <QAction>
#include <QActionGroup>

#include "app/gui/kit/actions.h"
#include "app/gui/kit/problems_dialog.h"
#include "app/gui/kit/words.h"
#include "app/gui/model/language.h"

namespace underact::gui {

void addLanguageActions(Actions& actions, QWidget* window) {
  struct Row {
    QString key, text, shortcut, tip;
  };
  // Languages are called by their own names.
  const Row rows[] = {
      {"system", tr("Follow the &system"), "Ctrl+Alt+Shift+1", tr("Uses the system's language from the next start.")},
      {"en", "&English", "Ctrl+Alt+Shift+2", tr("Uses English from the next start.")},
      {"de", "&Deutsch", "Ctrl+Alt+Shift+3", tr("Uses German from the next start.")}};
  auto* group = new QActionGroup(&actions);
  for (const Row& row : rows) {
    QAction* action =
        actions.add({"language." + row.key, row.text, QKeySequence(row.shortcut), row.tip, {}, {}, true},
                    [window, key = row.key](const QVariantList&) {
                      if (key == chosenLanguage()) return true;
                      chooseLanguage(key);
                      showProblemsBox("dialog.language", tr("Language"),
                                      tr("The language changes when you next start Underact."), {}, window);
                      return true;
                    });
    group->addAction(action);
    action->setChecked(chosenLanguage() == row.key);
  }
}

}  // namespace underact::gui
