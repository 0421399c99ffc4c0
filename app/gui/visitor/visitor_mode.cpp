#include "app/gui/visitor/visitor_mode.h"

#include <QAction>
#include <QApplication>
#include <QDockWidget>
#include <QVBoxLayout>
#include <utility>

#include "app/gui/kit/actions.h"
#include "app/gui/kit/larger_font.h"
#include "app/gui/kit/problems_dialog.h"
#include "app/gui/kit/words.h"
#include "app/gui/model/document.h"
#include "app/gui/model/settings.h"
#include "app/gui/view/hand.h"
#include "app/gui/visitor/demonstrator_panel.h"
#include "app/gui/visitor/drag_hint.h"
#include "app/gui/visitor/title_card.h"
#include "device/simulated_arm.h"

namespace underact::gui {
namespace {

constexpr double kVisitorType = 1.4;  // font scale of the view
constexpr double kMoved_m = 0.002;    // more than the noise of an arm at rest
constexpr double kWayOut_s = 15.0;    // it is said how to leave
constexpr double kAlone_s = 6.0;      // after the last touch it is shown how to drag
constexpr double kSettling_s = 3.0;   // a new scene moves the tip by itself

QString named(const QString& key) {
  return QStringLiteral("visitor.") + key;
}

}  // namespace

/// What is restored at the end.
struct VisitorMode::Before {
  Qt::WindowStates state;
  QRect geometry;
  Qt::ContextMenuPolicy context_menus;
  QFont view_font;
  Layers layers;
  Viewpoint viewpoint;
  bool was_running;
  std::optional<sim::HandSetpoint> hand;
};

VisitorMode::VisitorMode(const FeatureParts& parts)
    : QObject(parts.window),
      parts_(parts),
      card_(new TitleCard(parts.middle.parentWidget())),
      hint_(new DragHint(parts.view)),
      chrome_(parts.window) {
  parts.middle.addWidget(card_);
  parts_.actions.add(
      {named("start"),
       tr("&Visitor mode"),
       {},
       tr("Full screen for visitors: shows scenes in turn with reduced force and locks everything else."),
       "visitor"},
      [this](const QVariantList& scenes) { return start(scenes.value(0).toStringList()); });
  parts_.actions
      .add({named("demonstrator"), tr("&Demonstrator's panel"), QKeySequence("Ctrl+Alt+Shift+U"),
            tr("In visitor mode: choose the scenes, their duration and the force, or leave the mode.")},
           [this](const QVariantList&) {
             showPanel();
             return true;
           })
      ->setEnabled(false);
  connect(card_, &TitleCard::nextAsked, this, [this] {
    pressed_ = true;
    show(index_ + 1);
  });
  connect(card_, &TitleCard::startAsked, this, [this] {
    pressed_ = true;
    allowForce();
  });
}

VisitorMode::~VisitorMode() = default;

Problems VisitorMode::refusalNow() const {
  Problems problems;
  const auto no = [&problems](const QString& sentence) { problems.push_back({sentence.toStdString(), {}}); };
  if (parts_.document.isTryingOut()) no(tr("A measurement is using a scene of its own. End it first."));
  for (const QString& busy : parts_.busy_reason()) no(busy);
  return problems;
}

bool VisitorMode::start(const QStringList& scenes) {
  if (isOn()) return false;
  Problems problems = refusalNow();
  visitor_settings_ = readVisitorSettings();
  if (!scenes.isEmpty()) visitor_settings_.scenes = scenes;
  if (problems.empty()) problems = parts_.control.setForceShare(0.01 * visitor_settings_.force_percent);
  if (!problems.empty()) {
    showProblemsBox("dialog.no_visitors", tr("Visitor mode"), tr("Visitor mode was not started."), problems,
                    parts_.window);
    return false;
  }
  before_ = std::make_unique<Before>(Before{parts_.window->windowState(),
                                            parts_.window->geometry(),
                                            parts_.window->contextMenuPolicy(),
                                            parts_.view.font(),
                                            parts_.view.layers(),
                                            parts_.view.viewpoint(),
                                            parts_.servo.running(),
                                            {}});
  if (parts_.hand.arm() != nullptr) before_->hand = parts_.hand.setpoint();
  began_s_ = touched_s_ = static_cast<double>(parts_.servo.snapshot().ticks) / parts_.servo.rateHz();
  carousel_ = {};
  carousel_.setDwell(visitor_settings_.dwell_s);
  lock();
  restoreWindow();
  load(visitor_settings_.scenes);
  return true;
}

/// Leaves only the view and the card, full screen.
void VisitorMode::restoreWindow() {
  for (QWidget* other : QApplication::topLevelWidgets()) {
    const bool is_docked = other == parts_.window || qobject_cast<QDockWidget*>(other) != nullptr;
    if (!is_docked && other->isVisible()) other->close();
  }
  chrome_.hideChrome(WindowChrome::Keep::Nothing);
  parts_.window->setContextMenuPolicy(Qt::PreventContextMenu);
  parts_.window->setWindowState(parts_.window->windowState() | Qt::WindowFullScreen);
  parts_.view.setLayers(quietLayers());  // no frames, and no box with ticks
  parts_.view.setFont(larger(before_->view_font, kVisitorType));
  card_->setScene(tr("Loading"), {}, {});
  card_->fitInto(parts_.window->height());
  card_->show();
  parts_.view.setFocus(Qt::OtherFocusReason);
}

void VisitorMode::lock() {
  parts_.actions.find(named("demonstrator"))->setEnabled(true);
  parts_.actions.allowOnly({"session.stop", named("demonstrator")});
}

void VisitorMode::leave() {
  if (!isOn()) return;
  load_.reset();
  if (panel_ != nullptr) panel_->close();
  card_->hide();
  hint_->present(false);
  parts_.actions.allowAll();
  parts_.actions.find(named("demonstrator"))->setEnabled(false);
  if (!before_->was_running) parts_.control.stop();
  static_cast<void>(parts_.control.setForceShare(1.0));  // cannot fail: recording is locked
  parts_.document.putBackOwn();
  scenes_.clear();
  parts_.view.setLayers(before_->layers);
  parts_.view.setFont(before_->view_font);
  parts_.window->setContextMenuPolicy(before_->context_menus);
  parts_.window->setWindowState(before_->state);
  parts_.window->setGeometry(before_->geometry);
  chrome_.showChrome();
  parts_.view.setViewpoint(before_->viewpoint);
  before_.reset();
}

void VisitorMode::load(const QStringList& paths) {
  load_ = std::make_unique<Background<ShownScenes>>(
      [paths, left_handed = parts_.document.isLeftHanded()](WorkState& state) {
        return loadShownScenes(paths, left_handed, {.progress = {}, .cancelled = &state.cancelled});
      });
}

void VisitorMode::takeLoaded() {
  std::optional<ShownScenes> loaded = load_ ? load_->take() : std::nullopt;
  if (!loaded) return;
  load_.reset();
  if (panel_ != nullptr) {
    panel_->tell(loaded->scenes.empty()      ? tr("None of these scenes can be shown; the previous ones stay.")
                 : loaded->refused.isEmpty() ? QString()
                                             : tr("Cannot be shown: %1").arg(loaded->refused.join(", ")));
  }
  if (loaded->scenes.empty()) {
    if (scenes_.empty()) card_->setScene(tr("No scene can be shown"), loaded->refused.join(", "), {});
    return;
  }
  scenes_ = std::move(loaded->scenes);
  show(0);
}

void VisitorMode::show(std::size_t index) {
  if (scenes_.empty()) return;
  index_ = index % scenes_.size();
  const ShownScene& shown = scenes_[index_];
  // It compiled when it was loaded. A scene of the same kind replaces the other smoothly; others are ramped.
  static_cast<void>(parts_.document.showRecorded(shown.scene));
  card_->setScene(shown.title, shown.feel, shown.try_this);
  carousel_.showed(time_s_);
  shown_s_ = time_s_;
}

/// Restores everything for the next visitor.
void VisitorMode::reset() {
  parts_.view.setViewpoint({before_->viewpoint.camera, true});
  if (before_->hand) {
    before_->hand->holds = true;  // at its place until the next visitor takes it
    parts_.hand.moveTo(*before_->hand);
    parts_.hand.rest();
  }
  show(0);
}

/// A simulated arm moves only by its hand, so the hand is checked; for other arms, the tip.
bool VisitorMode::isTouched(const servo::Snapshot& snapshot, double time_s) {
  if (std::exchange(pressed_, false)) return true;
  if (parts_.hand.arm() != nullptr) return parts_.hand.moves();
  const bool moved = (snapshot.report.p_WT - rest_p_WT_).norm() > kMoved_m;
  if (moved) rest_p_WT_ = snapshot.report.p_WT;
  return moved && time_s - shown_s_ > kSettling_s;
}

/// Only the demonstrator's panel ends visitor mode, but the end of the desktop session is never blocked.
bool VisitorMode::mayClose() const {
  return !isOn() || qApp->isSavingSession();
}

void VisitorMode::poll(const servo::Snapshot&) {
  if (!isOn()) return;
  const servo::Snapshot snapshot = parts_.servo.snapshot();  // another scene may have taken effect since
  takeLoaded();
  time_s_ = static_cast<double>(snapshot.ticks) / parts_.servo.rateHz();
  tellState(snapshot);
  const bool touched = isTouched(snapshot, time_s_);
  presentHints(touched);
  switch (carousel_.at(time_s_, touched)) {
    case Carousel::Step::Stay:
      break;
    case Carousel::Step::Next:
      show(index_ + 1);
      break;
    case Carousel::Step::Reset:
      reset();
      break;
  }
}

/// To whom it may concern: how to leave, at first; how to begin, while nobody does.
void VisitorMode::presentHints(bool touched) {
  if (touched) touched_s_ = time_s_;
  card_->showWayOut(time_s_ - began_s_ < kWayOut_s);
  const bool can_drag = parts_.hand.arm() != nullptr && parts_.servo.running() && panel_ == nullptr;
  hint_->present(can_drag && !scenes_.empty() && time_s_ - touched_s_ > kAlone_s);
}

void VisitorMode::setTheme(const Theme& theme) {
  hint_->setTheme(theme);
}

void VisitorMode::tellState(const servo::Snapshot& snapshot) {
  const bool faulted = snapshot.mode == servo::Mode::Faulted;
  if (snapshot.mode == servo::Mode::Running) trouble_.clear();
  QString trouble = trouble_;
  if (trouble.isEmpty() && faulted) trouble = sentenceText(describe(snapshot.report.fault));
  card_->setState(!parts_.servo.running(), trouble);
}

/// The force returns only on request. An arm that its driver has lost is reopened first.
void VisitorMode::allowForce() {
  trouble_.clear();
  if (!parts_.servo.trouble().empty()) {
    const Problems problems = parts_.control.restart();
    if (!problems.empty()) {
      trouble_ = tr("The arm could not be reopened. %1").arg(sentencesOf(problems));
      return;
    }
  }
  parts_.control.start();
}

void VisitorMode::showPanel() {
  if (!isOn()) return;
  if (panel_ == nullptr) {
    panel_ = new DemonstratorPanel(visitor_settings_, parts_.window);
    connect(panel_, &DemonstratorPanel::changed, this, [this] { setVisitorSettings(panel_->visitorSettings()); });
    connect(panel_, &DemonstratorPanel::stopAsked, this, [this] { parts_.actions.perform("session.stop"); });
    connect(panel_, &DemonstratorPanel::leaveAsked, this, &VisitorMode::leave, Qt::QueuedConnection);
  }
  panel_->show();
  panel_->raise();
  panel_->activateWindow();
}

void VisitorMode::setVisitorSettings(const VisitorSettings& visitor_settings) {
  const bool others = visitor_settings.scenes != visitor_settings_.scenes;
  visitor_settings_ = visitor_settings;
  writeVisitorSettings(visitor_settings_);
  carousel_.setDwell(visitor_settings_.dwell_s);
  static_cast<void>(parts_.control.setForceShare(0.01 * visitor_settings_.force_percent));
  if (visitor_settings_.scenes.isEmpty())
    panel_->tell(tr("No scene is selected; the previous ones stay."));
  else if (others)
    load(visitor_settings_.scenes);
}

}  // namespace underact::gui
