#include "app/gui/kit/actions.h"

#include <QAction>
#include <QActionGroup>
#include <QWidget>
#include <utility>

namespace underact::gui {

Actions::Actions(QWidget* window) : QObject(window), window_(window) {}

QAction* Actions::add(const ActionInfo& info, Run run) {
  auto* action = new QAction(info.text, this);
  action->setObjectName("action." + info.name);
  action->setShortcut(info.shortcut);
  action->setShortcutContext(Qt::ApplicationShortcut);
  action->setStatusTip(info.tip);
  const QString keys = info.shortcut.toString(QKeySequence::NativeText);
  action->setToolTip(keys.isEmpty() ? info.tip : tr("%1 (%2)").arg(info.tip, keys));
  action->setIconText(info.button.isEmpty() ? QString(info.text).remove('&') : info.button);
  action->setCheckable(info.checkable);
  connect(action, &QAction::triggered, this, [this, name = info.name, run, action](bool on) {
    const bool done = allows(name) && run(action->isCheckable() ? QVariantList{on} : QVariantList{});
    if (!done && action->isCheckable()) action->setChecked(!on);  // refused: restore the check mark
  });
  window_->addAction(action);  // so that its shortcut works everywhere
  actions_.insert(info.name, action);
  icons_.insert(info.name, info.icon);
  addCommand(info.name, std::move(run));
  return action;
}

void Actions::addCommand(const QString& name, Run run) {
  names_ << name;
  runs_.insert(name, std::move(run));
}

QAction* Actions::find(const QString& name) const {
  return actions_.value(name, nullptr);
}

bool Actions::perform(const QString& name, const QVariantList& arguments) {
  QAction* action = find(name);
  if (!allows(name) || (action != nullptr && !action->isEnabled())) return false;
  const auto run = runs_.constFind(name);
  if (run == runs_.constEnd()) return false;
  if (action != nullptr && action->isCheckable()) {
    if (arguments.isEmpty() || arguments.first().toBool() != action->isChecked()) action->trigger();
    return true;
  }
  return (*run)(arguments);
}

std::vector<Choice> Actions::choices() const {
  std::vector<Choice> all;
  for (const auto& make : choices_) {
    for (Choice& one : make()) all.push_back(std::move(one));
  }
  return all;
}

void Actions::allowOnly(const QSet<QString>& names) {
  allowed_ = names;
  enableGroups(false);
  emit locked();
}

void Actions::allowAll() {
  allowed_.reset();
  enableGroups(true);
}

/// In an exclusive group, the check mark moves before the action can be refused.
void Actions::enableGroups(bool on) {
  for (QAction* action : std::as_const(actions_)) {
    if (action->actionGroup() != nullptr) action->actionGroup()->setEnabled(on);
  }
}

void Actions::setIcons(const std::function<QIcon(const QString& icon)>& painted) {
  for (auto entry = icons_.constBegin(); entry != icons_.constEnd(); ++entry) {
    if (!entry.value().isEmpty()) actions_.value(entry.key())->setIcon(painted(entry.value()));
  }
}

}  // namespace underact::gui
