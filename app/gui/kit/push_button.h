#pragma once
#include <QString>

class QAction;
class QPushButton;
class QToolButton;
class QWidget;

namespace underact::gui {

/// A push button that Enter elsewhere does not press. spoken: what a screen reader calls it; empty: its text.
QPushButton* pushButton(const QString& name, const QString& text, const QString& tip, QWidget* parent,
                        const QString& spoken = {});

/// A flat button, for an icon, that does what an action does.
QToolButton* iconButton(const QString& name, QAction* does, const QString& spoken, QWidget* parent);

}  // namespace underact::gui
