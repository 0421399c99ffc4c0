#include "app/gui/window/yield_letters.h"

#include <QAbstractButton>
#include <QAction>
#include <QKeySequence>
#include <QLabel>
#include <QMainWindow>
#include <QMenuBar>
#include <QSet>

namespace underact::gui {
namespace {

/// Without its mnemonic; "&&", which stands for "&", stays.
QString withoutLetter(QString text) {
  for (qsizetype at = text.indexOf('&'); at >= 0; at = text.indexOf('&', at + 1)) {
    if (text.mid(at, 2) == "&&")
      ++at;
    else
      text.remove(at, 1);
  }
  return text;
}

}  // namespace

void yieldLetters(QMainWindow& window) {
  QSet<QString> taken;
  for (const QAction* menu : window.menuBar()->actions()) taken.insert(QKeySequence::mnemonic(menu->text()).toString());
  for (const QAction* action : window.actions()) taken.insert(action->shortcut().toString());
  const auto isTaken = [&taken](const QString& text) {
    const QString key = QKeySequence::mnemonic(text).toString();
    return !key.isEmpty() && taken.contains(key);
  };
  for (QLabel* label : window.findChildren<QLabel*>())
    if (label->buddy() != nullptr && isTaken(label->text())) label->setText(withoutLetter(label->text()));
  for (QAbstractButton* button : window.findChildren<QAbstractButton*>())
    if (isTaken(button->text())) button->setText(withoutLetter(button->text()));
}

}  // namespace underact::gui
