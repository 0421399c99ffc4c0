#include "app/gui/kit/accessible_widgets.h"

#include <QAccessibleWidget>
#include <QBasicTimer>
#include <QEvent>
#include <QLabel>
#include <QTextDocumentFragment>
#include <QTimerEvent>

namespace underact::gui {
namespace {

constexpr const char* kRole = "spoken.role";  // property of a widget that paints itself
constexpr int kPause_ms = 500;  // between two announcements of one label: a changing number would drown everything else

QString wordsOf(const QLabel& label) {
  // Text as Application shows it. A label that is not shown yet does not say so, and as HTML it could name files.
  const bool is_rich = label.textFormat() == Qt::RichText;
  const QString words = is_rich ? QTextDocumentFragment::fromHtml(label.text()).toPlainText() : label.text();
  return label.buddy() == nullptr ? words : QString(words).remove('&');
}

/// Announces that a label's text has changed. Qt does so only for labels without an accessible name.
class LabelWatch : public QObject {
 public:
  explicit LabelWatch(QLabel* label) : QObject(label), label_(label), told_(label->text()) {
    label->installEventFilter(this);
  }

 protected:
  bool eventFilter(QObject*, QEvent* event) override {
    const bool is_new = event->type() == QEvent::Paint && label_->text() != told_;
    if (is_new && !label_->accessibleName().isEmpty() && !pause_.isActive()) pause_.start(kPause_ms, this);
    return false;
  }
  void timerEvent(QTimerEvent* event) override {
    if (event->timerId() != pause_.timerId()) return;
    pause_.stop();
    told_ = label_->text();
    QAccessibleEvent changed(label_, QAccessible::NameChanged);
    QAccessible::updateAccessibility(&changed);
  }

 private:
  QLabel* label_;
  QString told_;
  QBasicTimer pause_;
};

using Link = QPair<QAccessibleInterface*, QAccessible::Relation>;

/// As Qt's own for a label, except that an accessible name is put before the text instead of replacing it.
class SpokenLabel : public QAccessibleWidget {
 public:
  explicit SpokenLabel(QLabel* label) : QAccessibleWidget(label, QAccessible::StaticText) { new LabelWatch(label); }
  QAccessible::Role role() const override {
    return label().pixmap().isNull() ? QAccessible::StaticText : QAccessible::Graphic;
  }
  QString text(QAccessible::Text which) const override {
    if (which != QAccessible::Name) return QAccessibleWidget::text(which);
    const QString name = label().accessibleName(), words = wordsOf(label());
    if (name.isEmpty() || words.isEmpty() || words == name) return name.isEmpty() ? words : name;
    return name + ": " + words;
  }
  QAccessible::State state() const override {
    QAccessible::State state = QAccessibleWidget::state();
    state.readOnly = true;
    return state;
  }
  QVector<Link> relations(QAccessible::Relation match) const override {
    QVector<Link> relations = QAccessibleWidget::relations(match);
    if (match.testFlag(QAccessible::Labelled) && label().buddy() != nullptr)
      relations.append({QAccessible::queryAccessibleInterface(label().buddy()), QAccessible::Labelled});
    return relations;
  }

 private:
  const QLabel& label() const { return *static_cast<const QLabel*>(widget()); }
};

QAccessibleInterface* makeSpoken(const QString&, QObject* object) {
  if (object == nullptr || !object->isWidgetType()) return nullptr;
  auto* widget = static_cast<QWidget*>(object);
  if (auto* label = qobject_cast<QLabel*>(widget)) return new SpokenLabel(label);
  const QVariant role = widget->property(kRole);
  if (role.isValid()) return new QAccessibleWidget(widget, static_cast<QAccessible::Role>(role.toInt()));
  return nullptr;  // use Qt's own
}

}  // namespace

void setAccessibleRole(QWidget* widget, QAccessible::Role role) {
  widget->setProperty(kRole, static_cast<int>(role));
}

void makeWidgetsAccessible() {
  QAccessible::installFactory(&makeSpoken);
}

}  // namespace underact::gui
