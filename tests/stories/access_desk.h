#pragma once
#include <QAccessible>
#include <QList>
#include <QStringList>

#include "tests/stories/story.h"

namespace underact::gui::test {

// What stories about the keyboard, screen readers and large text share.

/// Twice the text while it lives; windows made before keep theirs.
class LargeText {
 public:
  LargeText();
  ~LargeText();
  LargeText(const LargeText&) = delete;
  LargeText& operator=(const LargeText&) = delete;

 private:
  QFont defaults_;
};

/// To the front, also where it stands behind another tab.
void bringPanel(Story& story, const QString& key);

/// A widget, and all in it, that the Tab key stops at, also where it is not seen now; not the parts that Qt makes
/// inside its own, and nothing of another window.
QList<QWidget*> focusable(QWidget& root);
/// The same, as far as they are seen and enabled.
QList<QWidget*> reachable(QWidget& root);

/// Its class and its name, for a sentence about it.
QString idOf(const QWidget* widget);

/// What a screen reader says of it.
QString spokenName(const QWidget& widget);

/// What is wrong with what a screen reader is told of a widget and all in it, a sentence each: no name, one without a
/// letter, one with a mnemonic's "&", no role; a table's column without a head; a label whose words are not said; a
/// picture without a name or a description; two that are called the same. And what keeps the Tab key.
QStringList wronglyNamed(QWidget& root);

/// Goes through all of a widget by Tab, and back, and says what is wrong: one is left out or comes twice, one stands
/// before the one it comes after, the focus stays inside or is not to be seen where it is.
QStringList wronglyOrdered(Story& story, QWidget& root);

}  // namespace underact::gui::test
