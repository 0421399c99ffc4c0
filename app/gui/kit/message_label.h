#pragma once
#include <QString>

class QLabel;
class QWidget;

namespace underact::gui {

/// name: of the object, for stories and style sheets; spoken: its name for screen readers; tip: empty: none.
void nameWidget(QWidget* widget, const QString& name, const QString& spoken, const QString& tip = {});

/// A label for sentences set later: wrapped, plain text (no markup) and selectable.
/// spoken: its name for screen readers; role: of the style sheet, "" for plain text.
QLabel* messageLabel(const char* name, const QString& spoken, const char* role, QWidget* parent);

/// Sets the text if it differs: setting an equal text would still repaint the label.
void updateText(QLabel* label, const QString& text);

/// Shows a message, and hides the label if the text is empty.
void showMessage(QLabel* label, const QString& text);

/// The title above the rows of a part of a panel.
QLabel* sectionTitle(const QString& text, QWidget* parent);

}  // namespace underact::gui
