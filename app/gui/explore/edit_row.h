#pragma once
#include <QHBoxLayout>
#include <QPushButton>
#include <QVBoxLayout>
#include <array>
#include <functional>

#include "app/gui/explore/history.h"
#include "app/gui/kit/actions.h"

namespace underact::gui {

/// The four buttons below an explorer's table, in this order.
struct EditRow {
  QPushButton *add = nullptr, *remove = nullptr, *undo = nullptr, *redo = nullptr;
};

/// In a row; each does the command of its name: "KEY.add", "KEY.remove", "KEY.undo", "KEY.redo".
inline void layEditRow(QVBoxLayout* column, const EditRow& buttons, Actions& actions, const QString& key) {
  auto* row = new QHBoxLayout;
  row->setSpacing(4);
  const std::array<std::pair<QPushButton*, const char*>, 4> all{
      {{buttons.add, "add"}, {buttons.remove, "remove"}, {buttons.undo, "undo"}, {buttons.redo, "redo"}}};
  for (const auto& [button, name] : all) {
    row->addWidget(button);
    QObject::connect(button, &QPushButton::clicked, button,
                     [&actions, command = key + "." + name] { actions.perform(command); });
  }
  column->addLayout(row);
}

/// "KEY.undo" and "KEY.redo". shown: after each.
template <class State>
void addHistoryCommands(Actions& actions, const QString& key, History<State>& history, std::function<void()> shown) {
  const auto add = [&](const char* name, bool (History<State>::*step)()) {
    actions.addCommand(key + "." + name, [&history, step, shown](const QVariantList&) {
      const bool done = (history.*step)();
      shown();
      return done;
    });
  };
  add("undo", &History<State>::undo);
  add("redo", &History<State>::redo);
}

}  // namespace underact::gui
