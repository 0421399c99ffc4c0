#pragma once
#include <QString>

class QAction;
class QPushButton;
class QToolButton;
class QWidget;

namespace underact::gui {

/// A push button that is pressed by Enter only when it has the focus. spoken: its name for screen readers; empty: its
/// text.
QPushButton* pushButton(const QString& name, const QString& text, const QString& tip, QWidget* parent,
                        const QString& spoken = {});

/// A flat icon button for an action.
QToolButton* iconButton(const QString& name, QAction* does, const QString& spoken, QWidget* parent);

}  // namespace underact::gui
