#include "app/gui/welcome/welcome.h"

#include <QAccessible>
#include <QAction>
#include <QCoreApplication>
#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>
#include <QToolButton>
#include <QVBoxLayout>
#include <algorithm>
#include <cmath>

#include "app/gui/kit/actions.h"
#include "app/gui/kit/message_label.h"
#include "app/gui/kit/push_button.h"
#include "app/gui/kit/words.h"
#include "app/gui/model/document.h"
#include "app/gui/model/servo_rate.h"
#include "app/gui/model/settings.h"
#include "app/gui/view/hand.h"
#include "app/gui/view/scene_view.h"
#include "app/gui/welcome/spotlight.h"
#include "core/base/units.h"
#include "core/scene/scene_arm.h"

namespace underact::gui {
namespace {

constexpr double kPush_N = 0.05;  // five times the last digit of the force shown: enough to be felt
constexpr double kTurn_rad = 15.0 * kRadPerDegree;
constexpr int kConfirmed_s = 4;
constexpr int kSettles_ticks = 1000;
constexpr int kRoomy_lines = 34;  // of the view, from which on all of the card has room beside the stylus
constexpr int kMargin_px = 16, kAway_px = 12, kTriad_px = 88;  // the view's triad is at the bottom left

struct PushRow {
  const char *type, *words;
};
// Walls and surfaces can be pushed into, the others not. Whole sentences, because articles differ between languages.
// First: of a type that is not in the list.
constexpr PushRow kPushRows[] = {
    {"", QT_TRANSLATE_NOOP("welcome", "Push into the surface: drag the stylus with the mouse.")},
    {"point", QT_TRANSLATE_NOOP("welcome", "Pull the stylus away from the point: drag it with the mouse.")},
    {"sphere", QT_TRANSLATE_NOOP("welcome", "Push into the sphere: drag the stylus with the mouse.")},
    {"line", QT_TRANSLATE_NOOP("welcome", "Pull the stylus away from the line: drag it with the mouse.")},
    {"plane", QT_TRANSLATE_NOOP("welcome", "Push into the plane: drag the stylus with the mouse.")},
    {"circle", QT_TRANSLATE_NOOP("welcome", "Pull the stylus away from the circle: drag it with the mouse.")},
    {"cylinder", QT_TRANSLATE_NOOP("welcome", "Push into the cylinder: drag the stylus with the mouse.")},
    {"box", QT_TRANSLATE_NOOP("welcome", "Push into the box: drag the stylus with the mouse.")},
    {"mesh", QT_TRANSLATE_NOOP("welcome", "Push into the mesh: drag the stylus with the mouse.")},
    {"curve", QT_TRANSLATE_NOOP("welcome", "Pull the stylus away from the curve: drag it with the mouse.")},
    {"virtual_manipulator",
     QT_TRANSLATE_NOOP("welcome",
                       "Pull the stylus away from the end effector of the virtual robot: drag it with the mouse.")}};

QString pushWords(const scene::Description& scene) {
  const std::string type = scene.constraints.empty() ? "sphere" : scene::typeName(scene.constraints.front().shape);
  const auto* row = std::find_if(std::begin(kPushRows), std::end(kPushRows),
                                 [&type](const PushRow& one) { return type == one.type; });
  return QCoreApplication::translate("welcome", (row == std::end(kPushRows) ? kPushRows : row)->words);
}

double wristTurn_rad(const arm::JointAngles& from, const arm::JointAngles& to) {
  double max = 0.0;
  for (std::size_t joint = 3; joint < from.size(); ++joint) max = std::max(max, std::abs(to[joint] - from[joint]));
  return max;
}

}  // namespace

Welcome::Welcome(const FeatureParts& parts)
    : QFrame(&parts.view),
      view_(parts.view),
      hand_(parts.hand),
      document_(parts.document),
      actions_(parts.actions),
      rate_(parts.rate),
      servo_(parts.servo),
      spotlight_(new Spotlight("welcome.frame", parts.window)),
      title_(sectionTitle({}, this)),
      purpose_(new QWidget(this)),
      confirmed_(messageLabel("welcome.confirmed", tr("What you just did"), "", this)),
      live_(messageLabel("welcome.live", tr("Force now"), "quiet", this)),
      was_seen_(parts.settings.has_pushed),
      is_asked_(!was_seen_) {
  setObjectName("welcome");
  setAccessibleName(tr("Welcome: three things to try"));
  setProperty("role", "card");
  setAttribute(Qt::WA_NoMousePropagation);  // a drag on the card must not rotate the view behind it
  hide();
  build(parts.actions);
  parts.actions.add(
      {"help.welcome", tr("&Welcome"), {}, tr("Three things to try first: push, move a slider, turn the stylus.")},
      [this](const QVariantList&) {
        ask();
        return true;
      });
  connect(&document_, &Document::opened, this, [this] { tell(); });
  connect(&document_, &Document::editedHere, this, [this] { edited_ = true; });
}

void Welcome::build(Actions& actions) {
  title_->setObjectName("welcome.title");
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(16, 12, 16, 12);
  column->setSpacing(8);
  column->addWidget(title_);
  const char* const names[] = {"welcome.push", "welcome.slider", "welcome.turn"};
  for (int thing = 0; thing < kThings; ++thing) {
    QLabel*& row = rows_[static_cast<std::size_t>(thing)];
    row = messageLabel(names[thing], tr("To try"), "", this);
    column->addWidget(row);
  }
  column->addWidget(confirmed_);
  column->addWidget(live_);
  column->addWidget(purpose_);
  auto* const asked = new QVBoxLayout(purpose_);
  asked->setContentsMargins({});
  asked->addWidget(messageLabel("welcome.ask", tr("What do you want to do?"), "", purpose_));
  purpose_->findChild<QLabel*>("welcome.ask")
      ->setText(tr("What do you want to do? You can change it at the top right."));
  auto* const purposes = new QHBoxLayout;
  for (const QString& name : actions.names()) {
    if (!name.startsWith("purpose.")) continue;
    auto* const choice = new QToolButton(purpose_);
    choice->setDefaultAction(actions.find(name));
    nameWidget(choice, "welcome." + name, actions.find(name)->text());
    choice->setFocusPolicy(Qt::StrongFocus);
    purposes->addWidget(choice);
  }
  purposes->addStretch();
  asked->addLayout(purposes);
  auto* tour = pushButton("welcome.tour", tr("Tour of the window"), tr("A tour of the window in eight stops."), this);
  auto* leave =
      pushButton("welcome.close", tr("Close"), tr("Closes this card. You find it again in the Help menu."), this);
  auto* buttons = new QHBoxLayout;
  buttons->addWidget(tour);
  buttons->addStretch();
  buttons->addWidget(leave);
  column->addLayout(buttons);
  connect(leave, &QPushButton::clicked, this, &Welcome::close);
  connect(tour, &QPushButton::clicked, this, [this, &actions] {
    close();
    actions.perform("help.tour");
  });
  setFixedWidth(24 * fontMetrics().averageCharWidth() + 2 * fontMetrics().horizontalAdvance("Drag the stylus"));
  tell();
}

void Welcome::ask() {
  is_asked_ = true;
  is_done_ = {};
  edited_ = false;
  began_rad_.reset();
  leaves_at_tick_ = -1;
  confirmed_->clear();
  tell();
}

void Welcome::close() {
  is_asked_ = false;
  was_seen_ = true;
  if (isAncestorOf(view_.window()->focusWidget())) view_.setFocus(Qt::OtherFocusReason);
}

void Welcome::tell() {
  const QString texts[] = {pushWords(document_.scene()),
                           tr("Move a slider, here the stiffness. To feel it, turn on Keep holding (F6) and "
                              "push a little first."),
                           tr("Turn the stylus: hold Ctrl and drag it.")};
  for (std::size_t thing = 0; thing < kThings; ++thing) {
    rows_[thing]->setText((is_done_[thing] ? QString::fromUtf8("✓  ") : QString::fromUtf8("○  ")) + texts[thing]);
    rows_[thing]->setAccessibleDescription(is_done_[thing] ? tr("Done") : tr("Not done yet"));
    QFont font = this->font();
    font.setBold(static_cast<Thing>(thing) == next());
    rows_[thing]->setFont(font);
    rows_[thing]->setVisible(!is_folded_ || static_cast<Thing>(thing) == next());
  }
  purpose_->setVisible(!is_folded_);
  live_->setVisible(!is_folded_);
  title_->setText(tr("Three things to try: %1 of 3 done").arg(std::count(is_done_.begin(), is_done_.end(), true)));
  confirmed_->setVisible(!confirmed_->text().isEmpty());
}

void Welcome::done(Thing thing, const QString& sentence) {
  if (is_done_[thing]) return;
  is_done_[thing] = true;
  was_seen_ = next() == kThings;
  confirmed_->setText(was_seen_ ? sentence + " " + tr("You find this card again in the Help menu.") : sentence);
  tell();
  QAccessibleEvent alert(confirmed_, QAccessible::Alert);
  QAccessible::updateAccessibility(&alert);
}

void Welcome::watch(const servo::Snapshot& snapshot) {
  const tick::TickReport& report = snapshot.report;
  if (!began_rad_) began_rad_ = report.sample.q_rad;
  const double force_N = report.force.f_T_W().norm();
  if (hand_.moves() && force_N > kPush_N) done(Push, tr("The arm pushes back."));
  if (edited_) done(Slider, tr("You feel the change at once."));
  if (hand_.moves() && wristTurn_rad(*began_rad_, report.sample.q_rad) > kTurn_rad)
    done(Turn, tr("The stylus has turned; in some scenes this moves the target."));
  if (next() == kThings && leaves_at_tick_ < 0) leaves_at_tick_ = snapshot.ticks;
  tellForce(report);
}

/// The numbers of the gauge, and what to do where the limit hides what a slider changes.
void Welcome::tellForce(const tick::TickReport& report) {
  const double limit_N = scene::armOf(document_.scene()).continuous_force_N * servo_.forceShare();
  const QString now =
      tr("Force now: %1 of %2 N.").arg(numberText(report.force.f_T_W().norm(), 2), numberText(limit_N, 2));
  updateText(live_, report.cut_N > 0.0 ? now + " " + tr("That is the limit: push less deeply to feel a slider.") : now);
}

Welcome::Thing Welcome::next() const {
  return static_cast<Thing>(std::find(is_done_.begin(), is_done_.end(), false) - is_done_.begin());
}

/// Of the next thing to do, in the window.
QRect Welcome::nextPlace() const {
  if (next() == Slider) {
    const auto* row = view_.window()->findChild<QWidget*>("panel.gains.kp.x");
    return row == nullptr ? QRect() : Spotlight::seenRect(*row);
  }
  if (next() == kThings) return {};
  const QRect stylus =
      view_.stylusOnScreen().toAlignedRect().adjusted(-kAway_px, -kAway_px, kAway_px, kAway_px) & view_.rect();
  return stylus.translated(view_.mapTo(view_.window(), QPoint()));
}

void Welcome::remember(Settings& settings) {
  settings.has_pushed = was_seen_;
}

void Welcome::present(const servo::Snapshot& snapshot) {
  const QAction* const leaves_lesson = actions_.find("lesson.leave");  // a lesson says itself what to do
  const bool may_show = !actions_.isLocked() && (leaves_lesson == nullptr || !leaves_lesson->isEnabled());
  // The card is about the mouse, so it is of no use to someone who holds a real arm.
  const bool is_seen = may_show && is_asked_ && hand_.arm() != nullptr && snapshot.ticks > 0 && document_.isOpen();
  if (is_seen) {
    watch(snapshot);
    if (leaves_at_tick_ >= 0 && snapshot.ticks - leaves_at_tick_ > kConfirmed_s * std::int64_t{rate_.hz()}) close();
  }
  const bool shows = is_seen && is_asked_;
  if (shows != is_shown_) {
    is_shown_ = shows;
    setVisible(shows);
    makeRoom();
    if (shows) {
      spotlight_->pointAt([this] { return nextPlace(); });
    } else {
      spotlight_->pointNowhere();
    }
  }
  if (!shows) return;
  if (const bool folds = view_.height() < kRoomy_lines * fontMetrics().lineSpacing(); folds != is_folded_) {
    is_folded_ = folds;
    tell();
    makeRoom();
  }
  if (snapshot.ticks < kSettles_ticks) move(0, 0);  // the view has not found its place yet: neither has the card
  place();
  spotlight_->follow();
}

// The arm stands below the card.
void Welcome::makeRoom() {
  layout()->activate();
  view_.setTaken(is_shown_ ? kMargin_px + heightForWidth(width()) + kAway_px : 0);
}

// It moves only to make way for the stylus or to fit a smaller window.
void Welcome::place() {
  resize(width(), heightForWidth(width()));
  const QRect stylus = view_.stylusOnScreen().toAlignedRect().adjusted(-kAway_px, -kAway_px, kAway_px, kAway_px);
  if (view_.rect().contains(geometry()) && !geometry().intersects(stylus) && !pos().isNull()) return;
  const int right = view_.width() - width() - kMargin_px, bottom = view_.height() - height() - kMargin_px;
  const int middle = bottom / 2, centre = right / 2;
  const QPoint corners[] = {{kMargin_px, kMargin_px},
                            {right, kMargin_px},
                            {kMargin_px, bottom - kTriad_px},
                            {right, bottom - kTriad_px},
                            {kMargin_px, bottom},
                            {right, bottom},
                            {kMargin_px, middle},
                            {right, middle},
                            {centre, kMargin_px},
                            {centre, bottom}};  // over the axes and the gauge where it has to be
  const auto* banner = view_.findChild<QWidget*>("view.stopped");
  const QRect stopped = banner == nullptr || banner->isHidden() ? QRect() : banner->geometry();
  const auto is_free = [&](const QPoint& corner) {
    const QRect there(corner, size());
    return !there.intersects(stylus) && !there.intersects(stopped);
  };
  const QPoint* chosen = std::find_if(std::begin(corners), std::end(corners), is_free);
  move(chosen == std::end(corners) ? corners[0] : *chosen);
  raise();
}

void Welcome::setTheme(const Theme& theme) {
  spotlight_->setTheme(theme);
}

}  // namespace underact::gui
