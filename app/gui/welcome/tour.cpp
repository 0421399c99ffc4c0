#include "app/gui/welcome/tour.h"

#include <QAccessible>
#include <QAction>
#include <QCoreApplication>
#include <QDockWidget>
#include <QHBoxLayout>
#include <QKeyEvent>
#include <QLabel>
#include <QPushButton>
#include <QVBoxLayout>
#include <array>

#include "app/gui/kit/actions.h"
#include "app/gui/kit/message_label.h"
#include "app/gui/kit/push_button.h"
#include "app/gui/view/scene_view.h"
#include "app/gui/welcome/spotlight.h"

namespace underact::gui {
namespace {

struct Stop {
  const char *widget, *title, *text;
};

constexpr const char* kStylus = "stylus";  // not a widget but a part of the view

constexpr std::array kStops{
    Stop{"view.scene", QT_TRANSLATE_NOOP("tour", "The view"),
         QT_TRANSLATE_NOOP("tour",
                           "What you see here is what you feel, in the arm's own frame. Drag beside the stylus to "
                           "rotate the view; use the wheel to zoom.")},
    Stop{kStylus, QT_TRANSLATE_NOOP("tour", "The stylus"),
         QT_TRANSLATE_NOOP("tour",
                           "Drag it with the mouse to move the hand on the simulated arm; hold Ctrl to turn the "
                           "stylus. The arrow is the force sent to the arm.")},
    Stop{"dock.scenes", QT_TRANSLATE_NOOP("tour", "Scenes"),
         QT_TRANSLATE_NOOP("tour",
                           "The constraints to feel, in teaching order. Below the list you read what to feel, what to "
                           "try, and the equation.")},
    Stop{"dock.feel", QT_TRANSLATE_NOOP("tour", "Feel"),
         QT_TRANSLATE_NOOP("tour",
                           "Stiffness, damping and more. You feel each change while you drag a slider; a double click "
                           "restores the scene's own value.")},
    Stop{"status", QT_TRANSLATE_NOOP("tour", "The status line"),
         QT_TRANSLATE_NOOP("tour",
                           "Always up to date: the state of the servo and its rate, with latency and scheduling in "
                           "the tip, the arm, and the force with its limit, as on the gauge in the view.")},
    Stop{"button.purpose", QT_TRANSLATE_NOOP("tour", "What you do"),
         QT_TRANSLATE_NOOP("tour",
                           "Demonstrate, Teach or Research: each shows the panels, menus and buttons that it takes. "
                           "All panels, at the end of the rail, and Ctrl+Shift+P find the rest.")},
    Stop{"dock.devices", QT_TRANSLATE_NOOP("tour", "Devices"),
         QT_TRANSLATE_NOOP("tour",
                           "Which arms are plugged in, what is missing to use one, and which one is in use. A real arm "
                           "exerts no force until you press Start.")},
    Stop{"button.help.guide", QT_TRANSLATE_NOOP("tour", "Help"),
         QT_TRANSLATE_NOOP("tour",
                           "Opens the guide; F1 does so at the page for whatever has the focus. The Help menu also has "
                           "the list of keys and this tour. Esc stops the force; Shift+Esc does so from anywhere.")}};

QString tourWords(const char* text) {
  return QCoreApplication::translate("tour", text);
}

}  // namespace

int Tour::stops() {
  return static_cast<int>(kStops.size());
}

Tour::Tour(SceneView& view, Actions& actions, QMainWindow* window)
    : QFrame(window), window_(window), view_(view), actions_(actions), spotlight_(new Spotlight("tour.frame", window)) {
  connect(&actions_, &Actions::locked, this, &Tour::end);
  setObjectName("tour");
  setAccessibleName(tr("Tour of the window"));
  setProperty("role", "card");
  setAttribute(Qt::WA_NoMousePropagation);
  hide();
  build();
  actions_.add({"help.tour",
                tr("&Tour of the window"),
                {},
                tr("A tour of the window in eight stops. Esc leaves it at any time.")},
               [this](const QVariantList&) {
                 begin();
                 return true;
               });
}

void Tour::build() {
  title_ = sectionTitle({}, this);
  title_->setObjectName("tour.title");
  text_ = messageLabel("tour.text", tr("What it is for"), "", this);
  count_ = messageLabel("tour.count", tr("Stop of the tour"), "quiet", this);
  count_->setWordWrap(false);
  back_ = pushButton("tour.back", tr("Back"), tr("Goes to the previous stop."), this);
  next_ = pushButton("tour.next", tr("Next"), tr("Goes to the next stop, as does Enter."), this);
  auto* leaves = pushButton("tour.close", tr("Close"), tr("Leaves the tour, as does Esc."), this);
  auto* buttons = new QHBoxLayout;
  buttons->addWidget(count_, 1);
  for (QPushButton* button : {back_, next_, leaves}) buttons->addWidget(button);
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(16, 12, 16, 12);
  column->setSpacing(8);
  column->addWidget(title_);
  column->addWidget(text_);
  column->addLayout(buttons);
  setFixedWidth(52 * fontMetrics().averageCharWidth());
  connect(back_, &QPushButton::clicked, this, [this] { go(stop_ - 1); });
  connect(next_, &QPushButton::clicked, this, [this] { go(stop_ + 1); });
  connect(leaves, &QPushButton::clicked, this, &Tour::end);
}

void Tour::begin() {
  if (stop_ < 0) layout_ = window_->saveState();
  go(0);
}

void Tour::go(int stop) {
  if (stop < 0) return;
  if (stop >= stops()) return end();
  stop_ = stop;
  const Stop& at = kStops[static_cast<std::size_t>(stop)];
  if (auto* dock = window_->findChild<QDockWidget*>(at.widget)) {
    dock->show();
    dock->raise();
  }
  title_->setText(tourWords(at.title));
  text_->setText(tourWords(at.text));
  count_->setText(tr("%1 of %2").arg(stop + 1).arg(stops()));
  back_->setEnabled(stop > 0);
  next_->setText(stop + 1 < stops() ? tr("Next") : tr("Done"));
  setAccessibleDescription(title_->text() + ". " + text_->text());
  is_placed_ = false;
  show();
  spotlight_->pointAt([this] { return where(); });
  follow();
  next_->setFocus(Qt::OtherFocusReason);
  QAccessibleEvent alert(this, QAccessible::Alert);  // a screen reader reads the stop, not only the button
  QAccessible::updateAccessibility(&alert);
}

void Tour::end() {
  if (stop_ < 0) return;
  stop_ = -1;
  hide();
  spotlight_->pointNowhere();
  window_->restoreState(layout_);
  view_.setFocus(Qt::OtherFocusReason);
}

QRect Tour::where() const {
  if (stop_ < 0) return {};
  const char* const name = kStops[static_cast<std::size_t>(stop_)].widget;
  if (name == kStylus) {
    const QRect stylus = view_.stylusOnScreen().toAlignedRect().adjusted(-12, -12, 12, 12) & view_.rect();
    return stylus.translated(view_.mapTo(window_, QPoint()));
  }
  const auto* target = window_->findChild<QWidget*>(name);
  return target == nullptr ? QRect() : Spotlight::seenRect(*target);
}

void Tour::follow() {
  if (stop_ < 0) return;
  spotlight_->follow();
  place(where());
}

// Beside the target if there is room, else in the middle of the window; it then stays as long as it covers nothing.
void Tour::place(const QRect& target) {
  resize(width(), heightForWidth(width()));
  const int gap = 16;
  const QRect room = window_->rect().adjusted(gap, gap, -gap, -gap);
  if (is_placed_ && room.contains(geometry()) && !geometry().intersects(target)) return;
  is_placed_ = true;
  const QPoint middle = target.center() - rect().center();
  const QPoint places[] = {{target.right() + gap, middle.y()},
                           {target.left() - width() - gap, middle.y()},
                           {middle.x(), target.bottom() + gap},
                           {middle.x(), target.top() - height() - gap}};
  QRect chosen(room.center() - rect().center(), size());
  for (const QPoint& place : places) {
    QRect there(place, size());
    there.moveLeft(qBound(room.left(), there.left(), room.right() - there.width()));
    there.moveTop(qBound(room.top(), there.top(), room.bottom() - there.height()));
    if (target.isEmpty() || there.intersects(target)) continue;
    chosen = there;
    break;
  }
  if (chosen != geometry()) setGeometry(chosen);
  raise();
}

void Tour::keyPressEvent(QKeyEvent* event) {
  auto* button = qobject_cast<QPushButton*>(focusWidget());
  const bool enters = event->key() == Qt::Key_Return || event->key() == Qt::Key_Enter;
  if (!enters || button == nullptr) return QFrame::keyPressEvent(event);
  button->click();
}

void Tour::setTheme(const Theme& theme) {
  spotlight_->setTheme(theme);
}

}  // namespace underact::gui
