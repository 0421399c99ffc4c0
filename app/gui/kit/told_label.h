#pragma once
#include <QString>

class QLabel;
class QWidget;

namespace underact::gui {

/// name: of the object, for stories and style sheets; spoken: what a screen reader calls it; tip: empty: it has none.
void nameWidget(QWidget* widget, const QString& name, const QString& spoken, const QString& tip = {});

/// A label for sentences that come later: they wrap, stand as they are (no markup) and can be selected.
/// spoken: what a screen reader calls it; role: of the style sheet, "" for plain words.
QLabel* toldLabel(const char* name, const QString& spoken, const char* role, QWidget* parent);

/// The text, where it is another one: a label that is told the same draws itself all the same.
void putText(QLabel* label, const QString& text);

/// The same, and the label is there only while there is a text.
void tellIn(QLabel* label, const QString& text);

/// What stands above the rows of a part of a panel.
QLabel* sectionTitle(const QString& text, QWidget* parent);

}  // namespace underact::gui
