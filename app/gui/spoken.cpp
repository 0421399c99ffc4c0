#include "app/gui/spoken.h"

#include <QAccessibleWidget>
#include <QBasicTimer>
#include <QEvent>
#include <QLabel>
#include <QTextDocumentFragment>
#include <QTimerEvent>

#include "app/gui/calibration/staircase_chart.h"
#include "app/gui/gallery/figure_picture.h"
#include "app/gui/hands/axis_bar.h"
#include "app/gui/kinematics/distance_bar.h"
#include "app/gui/lab/front_chart.h"
#include "app/gui/plot/chart_widget.h"
#include "app/gui/registration/marks_picture.h"
#include "app/gui/servo/lateness_chart.h"
#include "app/gui/servo/share_bar.h"
#include "app/gui/view/scene_view.h"

namespace underact::gui {
namespace {

constexpr int kPause_ms = 500;  // between two tellings of one label: a number that runs would drown all else

QString wordsOf(const QLabel& label) {
  const bool is_rich =
      label.textFormat() == Qt::RichText || (label.textFormat() == Qt::AutoText && Qt::mightBeRichText(label.text()));
  const QString words = is_rich ? QTextDocumentFragment::fromHtml(label.text()).toPlainText() : label.text();
  return label.buddy() == nullptr ? words : QString(words).remove('&');
}

/// Tells that a label says something else now. Qt does so for labels without a name of their own alone.
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

/// As Qt's own for a label, but that a name of its own stands before the words in place of them.
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

template <class... Kind>
bool isOneOf(const QWidget* widget) {
  return (... || (qobject_cast<const Kind*>(widget) != nullptr));
}

QAccessibleInterface* makeSpoken(const QString&, QObject* object) {
  if (object == nullptr || !object->isWidgetType()) return nullptr;
  auto* widget = static_cast<QWidget*>(object);
  if (auto* label = qobject_cast<QLabel*>(widget)) return new SpokenLabel(label);
  if (isOneOf<ChartWidget, LatenessChart, FrontChart, StaircaseChart>(widget))
    return new QAccessibleWidget(widget, QAccessible::Chart);
  if (isOneOf<AxisBar, DistanceBar, ShareBar, MarksPicture, FigurePicture>(widget))
    return new QAccessibleWidget(widget, QAccessible::Graphic);
  if (isOneOf<SceneView>(widget)) return new QAccessibleWidget(widget, QAccessible::Canvas);
  return nullptr;  // Qt's own answer
}

}  // namespace

void speakOwnWidgets() {
  QAccessible::installFactory(&makeSpoken);
}

}  // namespace underact::gui
