#include "app/gui/language/language_actions.h"

#include <QAction>
#include <QActionGroup>
#include <QMessageBox>
#include <QPushButton>

#include "app/gui/kit/actions.h"
#include "app/gui/kit/message_label.h"
#include "app/gui/kit/restart.h"
#include "app/gui/kit/words.h"
#include "app/gui/model/language.h"

namespace underact::gui {

namespace {

/// Asks about unsaved edits as closing does; then nothing happens.
void restart(QWidget* window) {
  if (window->close()) programStarter()();
}

void offerRestart(QWidget* window) {
  auto* box = new QMessageBox(QMessageBox::Information, tr("Language"),
                              tr("The language changes when you next start Underact."), QMessageBox::NoButton, window);
  box->setObjectName("dialog.language");
  box->setAttribute(Qt::WA_DeleteOnClose);
  box->setModal(false);
  QPushButton* now = box->addButton(tr("&Restart now"), QMessageBox::AcceptRole);
  nameWidget(now, "dialog.language.restart", tr("Restart now"));
  QPushButton* later = box->addButton(tr("&Later"), QMessageBox::RejectRole);
  nameWidget(later, "dialog.language.later", tr("Later"));
  box->setDefaultButton(later);
  box->setEscapeButton(later);
  QObject::connect(
      now, &QPushButton::clicked, window, [window] { restart(window); }, Qt::QueuedConnection);
  box->show();
}

}  // namespace

void addLanguageActions(Actions& actions, QWidget* window) {
  struct Row {
    QString key, text, tip;
  };
  // Languages are called by their own names.
  const Row rows[] = {{"system", tr("Follow the &system"), tr("Uses the system's language from the next start.")},
                      {"en", "&English", tr("Uses English from the next start.")},
                      {"de", "&Deutsch", tr("Uses German from the next start.")}};
  auto* group = new QActionGroup(&actions);
  for (const Row& row : rows) {
    QAction* action = actions.add({"language." + row.key, row.text, {}, row.tip, {}, {}, true},
                                  [window, key = row.key](const QVariantList&) {
                                    if (key == chosenLanguage()) return true;
                                    chooseLanguage(key);
                                    offerRestart(window);
                                    return true;
                                  });
    group->addAction(action);
    action->setChecked(chosenLanguage() == row.key);
  }
}

}  // namespace underact::gui
