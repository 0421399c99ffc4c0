#include "app/gui/palette/entries.h"

#include <QAbstractSpinBox>
#include <QAction>
#include <QCheckBox>
#include <QComboBox>
#include <QDockWidget>
#include <QPointer>
#include <QScrollArea>
#include <QSet>
#include <algorithm>

#include "app/gui/feature/panel.h"
#include "app/gui/kit/actions.h"
#include "app/gui/kit/words.h"
#include "app/gui/palette/words.h"

namespace underact::gui {
namespace {

using Translations = QMultiHash<QString, QString>;

QString plainText(const QAction& action) {
  return action.text().remove('&');
}

/// The text, in each language, then what explains it.
QStringList searched(const QString& text, const QStringList& more, const Translations& others) {
  const QString own = searchText(text);
  QStringList all{own};
  all << others.values(own);
  for (const QString& one : more) {
    const QString explained = searchText(one);
    all << explained << others.values(explained);
  }
  return all;
}

void addActions(std::vector<PaletteEntry>& entries, Actions& actions, const Translations& others) {
  for (const QString& name : actions.names()) {
    const QAction* const action = actions.find(name);
    if (action == nullptr || name.startsWith("menu.")) continue;  // a command with arguments; a button with a menu
    entries.push_back({plainText(*action), tr("Command"), action->shortcut().toString(QKeySequence::NativeText),
                       searched(plainText(*action), {action->statusTip(), name}, others),
                       action->isEnabled() && actions.allows(name), [&actions, name] { actions.perform(name); }});
  }
}

void addChoices(std::vector<PaletteEntry>& entries, Actions& actions, const Translations& others) {
  for (const Choice& one : actions.choices())
    entries.push_back(
        {one.text, one.kind, {}, searched(one.text, {one.kind}, others), actions.allows(one.action), [&actions, one] {
           actions.perform(one.action, one.argument);
         }});
}

bool isField(const QWidget& widget) {
  return !widget.accessibleName().isEmpty() &&
         (qobject_cast<const QAbstractSpinBox*>(&widget) != nullptr ||
          qobject_cast<const QComboBox*>(&widget) != nullptr || qobject_cast<const QCheckBox*>(&widget) != nullptr);
}

void goTo(Actions& actions, const QString& dock, QWidget* field) {
  actions.perform(dock, true);
  for (QWidget* above = field->parentWidget(); above != nullptr; above = above->parentWidget()) {
    if (auto* const area = qobject_cast<QScrollArea*>(above)) area->ensureWidgetVisible(field);
  }
  field->setFocus(Qt::ShortcutFocusReason);
}

/// Hidden ones belong to another kind of scene.
void addFields(std::vector<PaletteEntry>& entries, Actions& actions, const QMainWindow& window,
               const Translations& others) {
  for (const QDockWidget* const dock : docksOf(&window)) {
    QSet<QString> names;
    for (QWidget* const field : dock->findChildren<QWidget*>()) {
      if (!isField(*field) || !field->isVisibleTo(dock) || names.contains(field->accessibleName())) continue;
      names.insert(field->accessibleName());
      entries.push_back({field->accessibleName(),
                         dock->windowTitle(),
                         {},
                         searched(field->accessibleName(), {dock->windowTitle()}, others),
                         field->isEnabled(),
                         [&actions, name = dock->objectName(), field = QPointer(field)] {
                           if (field != nullptr) goTo(actions, name, field);
                         }});
    }
  }
}

}  // namespace

std::vector<PaletteEntry> paletteEntries(Actions& actions, const QMainWindow& window) {
  const Translations others = otherLanguages();
  std::vector<PaletteEntry> entries;
  addActions(entries, actions, others);
  addChoices(entries, actions, others);
  addFields(entries, actions, window, others);
  return entries;
}

std::vector<const PaletteEntry*> fitting(const std::vector<PaletteEntry>& entries, const QString& typed) {
  std::vector<std::pair<int, const PaletteEntry*>> found;
  for (const PaletteEntry& entry : entries) {
    if (const int fit = fitOf(typed, entry.searched); fit > 0) found.emplace_back(2 * fit + entry.is_possible, &entry);
  }
  std::stable_sort(found.begin(), found.end(),
                   [](const auto& one, const auto& other) { return one.first > other.first; });
  std::vector<const PaletteEntry*> fits;
  for (const auto& [fit, entry] : found) fits.push_back(entry);
  return fits;
}

}  // namespace underact::gui
