#pragma once
#include <QString>

class QPushButton;
class QWidget;

namespace underact::gui {

/// A push button that Enter elsewhere does not press. spoken: what a screen reader calls it; empty: its text.
QPushButton* pushButton(const QString& name, const QString& text, const QString& tip, QWidget* parent,
                        const QString& spoken = {});

}  // namespace underact::gui
