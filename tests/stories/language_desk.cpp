#include "tests/stories/language_desk.h"

#include <gtest/gtest.h>

#include <QAbstractButton>
#include <QComboBox>
#include <QCoreApplication>
#include <QHeaderView>
#include <QLabel>
#include <QMutex>
#include <QPushButton>
#include <QStyle>
#include <QStyleOptionComboBox>

namespace underact::gui::test {

class German::Listener : public QTranslator {
 public:
  Listener() { EXPECT_TRUE(words_.load(":/languages/underact_de.qm")); }
  bool isEmpty() const override { return false; }
  QString translate(const char* context, const char* text, const char* comment, int n) const override {
    const QString found = words_.translate(context, text, comment, n);
    const QString where(context);
    const bool is_qts_own = where.startsWith('Q') && where != "QObject";
    if (found.isEmpty() && !is_qts_own && *text != '\0') {
      const QMutexLocker lock(&mutex_);
      missing_.insert(where + ": " + text);
    }
    return found;
  }
  QStringList missing() const {
    const QMutexLocker lock(&mutex_);
    return missing_.values();
  }

 private:
  QTranslator words_;
  mutable QMutex mutex_;  // scenes are read beside the window's thread
  mutable QSet<QString> missing_;
};

German::German() : listener_(new Listener) {
  speak("de");
  QCoreApplication::installTranslator(listener_);
}

German::~German() {
  delete listener_;
  speak("en");
}

QStringList German::missing() const {
  return listener_->missing();
}

namespace {

/// Of a table's columns.
QStringList cutHeads(const QWidget& widget) {
  QStringList cut;
  const auto* head = qobject_cast<const QHeaderView*>(&widget);
  if (head == nullptr || head->orientation() != Qt::Horizontal) return cut;
  for (int column = 0; column < head->count(); ++column) {
    const QString title = head->model()->headerData(column, Qt::Horizontal).toString();
    const QSize words = head->fontMetrics().size(0, title);  // Qt's own hint is that of bold ones
    if (!head->isSectionHidden(column) && head->sectionSize(column) < words.width())
      cut << head->parent()->objectName() + ": " + title;
  }
  return cut;
}

constexpr int kFrame_px = 4;  // of a button, and room for the focus

QString wordsOf(const QWidget& widget) {
  if (const auto* label = qobject_cast<const QLabel*>(&widget)) return label->text();
  if (const auto* button = qobject_cast<const QAbstractButton*>(&widget)) return button->text();
  const auto* choice = qobject_cast<const QComboBox*>(&widget);
  return choice != nullptr ? choice->currentText() : QString();
}

bool isCut(const QWidget& widget) {
  const auto* label = qobject_cast<const QLabel*>(&widget);
  if (label != nullptr && label->wordWrap()) return label->height() < label->heightForWidth(label->width());
  if (const auto* choice = qobject_cast<const QComboBox*>(&widget)) {
    QStyleOptionComboBox option;
    option.initFrom(choice);
    const QRect field = choice->style()->subControlRect(QStyle::CC_ComboBox, &option, QStyle::SC_ComboBoxEditField);
    return field.width() < choice->fontMetrics().horizontalAdvance(choice->currentText());
  }
  if (const auto* button = qobject_cast<const QPushButton*>(&widget)) {  // its hint is wider than its words need
    const int icon = button->icon().isNull() ? 0 : button->iconSize().width() + 4;
    const int words = button->fontMetrics().size(Qt::TextShowMnemonic, button->text()).width();
    return button->width() < words + icon + 2 * kFrame_px;
  }
  return widget.width() < widget.sizeHint().width();
}

}  // namespace

QStringList cutWords(const QWidget& widget) {
  QStringList cut;
  for (const QWidget* part : widget.findChildren<QWidget*>()) {
    if (!part->isVisible()) continue;
    cut << cutHeads(*part);
    const QString words = wordsOf(*part);
    if (!words.isEmpty() && isCut(*part)) cut << part->objectName() + ": " + words;
  }
  return cut;
}

}  // namespace underact::gui::test
