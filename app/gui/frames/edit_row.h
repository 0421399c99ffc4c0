#pragma once
#include <QHBoxLayout>
#include <QPushButton>
#include <QVBoxLayout>
#include <array>
#include <functional>

#include "app/gui/kit/actions.h"
#include "app/gui/kit/edit.h"

namespace underact::gui {

/// The four buttons below an explorer's table, in this order.
struct EditRow {
  QPushButton *add = nullptr, *remove = nullptr, *undo = nullptr, *redo = nullptr;
};

/// Lays them out in a row; each performs the command of its name: "KEY.add", "KEY.remove", "KEY.undo", "KEY.redo".
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

/// Adds "KEY.undo" and "KEY.redo". shown: called after each.
inline void addUndoCommands(Actions& actions, const QString& key, QUndoStack& stack,
                            const std::function<void()>& shown) {
  actions.addCommand(key + ".undo", [&stack, shown](const QVariantList&) {
    const bool can = stack.canUndo();
    stack.undo();
    shown();
    return can;
  });
  actions.addCommand(key + ".redo", [&stack, shown](const QVariantList&) {
    const bool can = stack.canRedo();
    stack.redo();
    shown();
    return can;
  });
}

}  // namespace underact::gui
