#include "tests/stories/access_desk.h"

#include <gtest/gtest.h>

#include <QAbstractItemView>
#include <QAbstractScrollArea>
#include <QAccessible>
#include <QApplication>
#include <QComboBox>
#include <QHeaderView>
#include <QLabel>
#include <QPlainTextEdit>
#include <QTabBar>
#include <QTextEdit>

#include "app/gui/kit/larger_font.h"

namespace underact::gui::test {
namespace {

bool hasLetter(const QString& text) {
  return std::any_of(text.begin(), text.end(), [](QChar sign) { return sign.isLetter(); });
}

/// One that draws itself: of ours, with nothing in it. A frame that points at another says nothing itself, and what
/// stands in a ChartWidget or the view to be drawn on is no part of its own.
bool isPicture(const QWidget& widget) {
  if (widget.inherits("underact::gui::ChartWidget") || widget.inherits("underact::gui::SceneView")) return true;
  if (widget.inherits("underact::gui::GlSurface") || widget.inherits("underact::gui::Spotlight")) return false;
  const bool is_ours = QByteArray(widget.metaObject()->className()).startsWith("underact::gui::");
  for (const char* kind :
       {"QAbstractButton", "QAbstractSlider", "QAbstractSpinBox", "QComboBox", "QLineEdit", "QLabel"})
    if (widget.inherits(kind)) return false;
  return is_ours && widget.layout() == nullptr && widget.findChild<QWidget*>() == nullptr;
}

QStringList wrongWithColumns(const QAbstractItemView& view) {
  const auto* head = view.findChild<QHeaderView*>();
  QStringList wrong;
  for (int column = 0; head != nullptr && !head->isHidden() && column < head->count(); ++column) {
    if (head->orientation() != Qt::Horizontal) break;
    const QString title = view.model()->headerData(column, Qt::Horizontal, Qt::DisplayRole).toString();
    const QString spoken = view.model()->headerData(column, Qt::Horizontal, Qt::AccessibleTextRole).toString();
    if (!head->isSectionHidden(column) && title.isEmpty() && spoken.isEmpty())
      wrong << idOf(&view) + QString(": column %1 has no head").arg(column);
  }
  return wrong;
}

/// Where Tab would go on inside instead of leaving.
bool keepsTab(const QWidget& widget) {
  if (const auto* view = qobject_cast<const QAbstractItemView*>(&widget)) return view->tabKeyNavigation();
  if (const auto* text = qobject_cast<const QTextEdit*>(&widget))
    return !text->isReadOnly() && !text->tabChangesFocus();
  const auto* plain = qobject_cast<const QPlainTextEdit*>(&widget);
  return plain != nullptr && !plain->isReadOnly() && !plain->tabChangesFocus();
}

/// On Linux Qt says what is chosen as a chooser's name: the name itself has to come from a label, or as a description.
QString nameOfChooser(const QComboBox& box) {
  const QAccessibleInterface* const spoken = QAccessible::queryAccessibleInterface(const_cast<QComboBox*>(&box));
  const bool has_label = !spoken->relations(QAccessible::Label).isEmpty();
  return has_label || spoken->text(QAccessible::Description).contains(box.accessibleName()) ? box.accessibleName()
                                                                                            : QString();
}

QString wrongWithName(const QWidget& widget) {
  const auto* box = qobject_cast<const QComboBox*>(&widget);
  const QString name = box != nullptr ? nameOfChooser(*box) : spokenName(widget);
  if (name.isEmpty()) return "has no name";
  if (!hasLetter(name)) return "says nothing: " + name;
  if (name.contains('&')) return "says its mnemonic: " + name;
  return {};
}

QString wrongWithRole(QWidget& widget) {
  const QAccessibleInterface* const spoken = QAccessible::queryAccessibleInterface(&widget);
  const bool has_role = spoken != nullptr && spoken->role() != QAccessible::NoRole &&
                        spoken->role() != QAccessible::Client && spoken->role() != QAccessible::Pane;
  return has_role ? QString() : "has no role";
}

}  // namespace

QString idOf(const QWidget* widget) {
  if (widget == nullptr) return "nothing";
  const QString id = QString("%1 %2").arg(widget->metaObject()->className(), widget->objectName());
  const bool has_place = !widget->objectName().isEmpty() || widget->parentWidget() == nullptr;
  return has_place ? id : QString("%1in %2").arg(id, idOf(widget->parentWidget()));
}

LargeText::LargeText() : defaults_(QApplication::font()) {
  QApplication::setFont(larger(defaults_, 2.0));
}

LargeText::~LargeText() {
  QApplication::setFont(defaults_);
}

void bringPanel(Story& story, const QString& key) {
  story.perform("dock." + key, false);  // one that is on already is not raised
  EXPECT_TRUE(story.perform("dock." + key, true)) << key.toStdString();
  story.run(1);
  story.settle();
}

QList<QWidget*> focusable(QWidget& root) {
  QList<QWidget*> found;
  for (QWidget* widget : QList<QWidget*>{&root} + root.findChildren<QWidget*>()) {
    if ((widget->focusPolicy() & Qt::TabFocus) == 0 || widget->focusProxy() != nullptr) continue;
    if (widget->window() != root.window() || widget->objectName().startsWith("qt_")) continue;
    const auto* const tabs = qobject_cast<QTabBar*>(widget);  // of docks that are not there
    if (tabs != nullptr && (!tabs->isVisible() || tabs->count() == 0)) continue;
    if (qobject_cast<QComboBox*>(widget->parent()) != nullptr) continue;
    found << widget;
  }
  return found;
}

QList<QWidget*> reachable(QWidget& root) {
  QList<QWidget*> found = focusable(root);
  found.removeIf([](const QWidget* widget) { return !widget->isVisible() || !widget->isEnabled(); });
  return found;
}

QString spokenName(const QWidget& widget) {
  const QAccessibleInterface* const spoken = QAccessible::queryAccessibleInterface(const_cast<QWidget*>(&widget));
  return spoken == nullptr ? QString() : spoken->text(QAccessible::Name);
}

QStringList wronglyNamed(QWidget& root) {
  QStringList wrong;
  QHash<QString, const QWidget*> known;
  for (QWidget* widget : focusable(root)) {
    for (const QString& what : {wrongWithName(*widget), wrongWithRole(*widget)})
      if (!what.isEmpty()) wrong << idOf(widget) + " " + what;
    if (keepsTab(*widget)) wrong << idOf(widget) + " keeps the Tab key";
    if (const auto* view = qobject_cast<QAbstractItemView*>(widget)) wrong << wrongWithColumns(*view);
    if (!widget->isVisible()) continue;
    const bool is_box = qobject_cast<QComboBox*>(widget) != nullptr;
    const QString name = is_box ? widget->accessibleName() : spokenName(*widget);
    const QWidget*& other = known[name];
    if (other != nullptr) wrong << idOf(widget) + " is called as is " + idOf(other) + ": " + name;
    other = widget;
  }
  for (QWidget* widget : root.findChildren<QWidget*>()) {
    const auto* label = qobject_cast<QLabel*>(widget);
    const bool has_words = label != nullptr && !label->text().isEmpty() && !Qt::mightBeRichText(label->text());
    if (has_words && !spokenName(*label).contains(QString(label->text()).remove('&')))
      wrong << idOf(label) + " does not say its words: " + label->text();
    if (!isPicture(*widget) || widget->window() != root.window()) continue;
    for (const QString& what : {wrongWithName(*widget), wrongWithRole(*widget)})
      if (!what.isEmpty()) wrong << idOf(widget) + ", a picture, " + what;
    const QAccessibleInterface* const spoken = QAccessible::queryAccessibleInterface(widget);
    if (spoken != nullptr && spoken->text(QAccessible::Description).isEmpty())
      wrong << idOf(widget) + ", a picture, has no description";
  }
  return wrong;
}

}  // namespace underact::gui::test
