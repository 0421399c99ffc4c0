#include "app/gui/lab/lab_panel.h"

#include <QLabel>
#include <QVBoxLayout>
#include <utility>

#include "app/gui/kit/actions.h"
#include "app/gui/kit/message_label.h"
#include "app/gui/kit/panel_scroll.h"
#include "app/gui/kit/words.h"
#include "app/gui/lab/choice_list.h"
#include "app/gui/lab/lab_words.h"
#include "app/gui/lab/measuring_part.h"
#include "app/gui/lab/walk_part.h"
#include "app/gui/model/arm_in_use.h"
#include "app/gui/model/document.h"
#include "app/gui/model/servo_rate.h"
#include "core/scene/compile.h"
#include "core/scene/edit.h"
#include "core/tick/cost.h"
#include "core/tradeoff/duration.h"

namespace underact::gui {
namespace {

constexpr int kPollRun_ms = 50;

double predictedTick_ns(const scene::Description& scene) {
  const Result<tick::TickProgram> program = scene::compile(scene);
  return program ? tick::predictedCost_ns(program.value()) : 0.0;
}

}  // namespace

LabPanel::LabPanel(const Parts& parts, QWidget* parent) : Panel(parent), parts_(parts) {
  build();
  addCommands();
  connect(&poll_timer_, &QTimer::timeout, this, &LabPanel::pollRun);
  connect(&parts_.document, &Document::opened, this, &LabPanel::sceneOpened);
  connect(&parts_.document, &Document::edited, this, &LabPanel::sceneEdited);
  connect(&parts_.rate, &ServoRate::changed, this, [this] { stale_ = true; });
  connect(&parts_.arm_in_use, &ArmInUse::changed, this, &LabPanel::armChanged);
  forget(measuringText());
}

void LabPanel::build() {
  auto* content = new QWidget;
  auto* column = new QVBoxLayout(content);
  column->setContentsMargins(8, 8, 8, 8);
  column->setSpacing(4);
  column->addWidget(measuring_ = new MeasuringPart(content));
  column->addWidget(walk_ = new WalkPart(content));
  column->addWidget(sectionTitle(tr("Choices of this scene"), content));
  column->addWidget(tick_ = messageLabel("panel.lab.tick", tr("Predicted time of a tick"), "quiet", content));
  column->addSpacing(4);
  column->addWidget(choices_ = new ChoiceList(content));
  column->addStretch(1);
  fillWithScroll(this, content);
  poll_timer_.setInterval(kPollRun_ms);
  connect(measuring_, &MeasuringPart::measureAsked, this,
          [this] { measure(measuring_->hand(), measuring_->seconds()); });
  connect(measuring_, &MeasuringPart::cancelAsked, this, &LabPanel::cancel);
  connect(measuring_, &MeasuringPart::changed, this, [this] {
    if (run_ == nullptr && result_.choice_results.empty()) measuring_->tell(measuringText(), false);
  });
  connect(walk_, &WalkPart::begun, this, &LabPanel::beginGesture);
  connect(walk_, &WalkPart::stopAsked, this, &LabPanel::walkTo);
  connect(walk_, &WalkPart::backAsked, this, &LabPanel::putBack);
}

void LabPanel::addCommands() {
  parts_.actions.addCommand("lab.measure", [this](const QVariantList& values) {  // hand ("" for all), seconds
    const QString hand = values.isEmpty() ? QString::fromStdString(measuring_->hand()) : values[0].toString();
    return measure(hand.toStdString(), values.size() < 2 ? measuring_->seconds() : values[1].toDouble());
  });
  parts_.actions.addCommand("lab.cancel", [this](const QVariantList&) { return cancel(); });
  parts_.actions.addCommand("lab.walk", [this](const QVariantList& values) {  // a stop, or a share from 0 to 1
    if (values.size() != 1 || front_.empty()) return false;
    beginGesture();
    const bool is_share = values[0].typeId() == QMetaType::Double;
    const double share = values[0].toDouble();
    if (is_share && !(share >= 0.0 && share <= 1.0)) return false;
    return walkTo(is_share ? qRound(share * static_cast<double>(front_.size() - 1)) : values[0].toInt(), true);
  });
  parts_.actions.addCommand("lab.back", [this](const QVariantList&) { return putBack(); });
}

LabPanel::~LabPanel() = default;

tradeoff::Settings LabPanel::now() const {
  return tradeoff::settingsOf(parts_.document.scene(), parts_.rate.hz());
}

bool LabPanel::measure(const std::string& hand, double seconds) {
  const std::vector<tradeoff::NamedHand> hands = handsOf(hand);
  if (run_ != nullptr || hands.empty() || !parts_.document.isOpen() || !(seconds >= 0.1 && seconds <= 60.0))
    return false;
  forget(tr("Measuring. Window and servo keep running; do not change the scene."));
  order_ = {parts_.document.scene(), hands, seconds, parts_.rate.hz()};
  run_ =
      std::make_unique<Background<LabResult>>([order = order_](WorkState& state) { return measureLab(order, state); });
  poll_timer_.start();
  refresh();
  return true;
}

bool LabPanel::cancel() {
  if (run_ == nullptr) return false;
  run_->cancel();
  measuring_->tell(tr("Cancelling: the current run ends first."), false);
  return true;
}

void LabPanel::pollRun() {
  measuring_->setShare(run_->share());
  std::optional<LabResult> result = run_->take();
  if (!result) return;
  poll_timer_.stop();
  const bool is_cancelled = run_->isCancelled();
  run_.reset();
  if (is_cancelled)
    forget(tr("Cancelled. Nothing was kept, since partial results would be misleading."));
  else if (!isMeasuredScene(order_))
    forget(tr("The scene was changed during the measurement, so the results do not apply to it. Measure again."));
  else
    end(std::move(*result));
}

void LabPanel::end(LabResult result) {
  result_ = std::move(result);
  front_.clear();
  for (std::size_t index = 0; index < result_.points.size(); ++index) {
    const tradeoff::Point& point = result_.points[index];
    if (!point.on_front) continue;
    // A substep longer than the period equals the period, so two combinations are the same run: keep the scene's own.
    if (!front_.empty() && result_.points[front_.back()].error_mm == point.error_mm) {
      if (point.is_own) front_.back() = index;
      continue;
    }
    front_.push_back(index);
  }
  if (front_.empty()) {
    measuring_->tell(tr("The finest run of this scene, or every other one, ended in a fault, so nothing can be "
                        "compared. What could be measured is shown below. Lower gains may help."),
                     true);
  } else {
    measuring_->tell(measuredText(), false);
  }
  refresh();
}

void LabPanel::forget(const QString& why) {
  result_ = {};
  front_.clear();
  measuring_->tell(why, false);
  refresh();
}

bool LabPanel::isMeasuredScene(const LabOrder& order) const {
  const tradeoff::Settings own = order.own();
  return scene::isSame(withSettings(parts_.document.scene(), own), withSettings(order.scene, own));
}

/// Whether the current rate was only tried here and not chosen in the servo panel.
bool LabPanel::hasTriedRate() const {
  return !result_.choice_results.empty() && parts_.rate.hz() != order_.rate_hz &&
         parts_.rate.chosen() != parts_.rate.hz();
}

void LabPanel::sceneOpened() {
  cancel();
  if (run_ != nullptr) return;
  // Another scene starts at the previous rate; if that is refused, the panel says so.
  const Problems problems = hasTriedRate() ? parts_.rate.tryOut(order_.rate_hz) : Problems{};
  const QString stays = problems.empty() ? QString() : tr(" The rate stays at %1 Hz. ").arg(parts_.rate.hz());
  forget(measuringText() + stays + sentencesOf(problems));
}

void LabPanel::sceneEdited() {
  if (!result_.choice_results.empty() && !isMeasuredScene(order_)) {
    const QString stays = hasTriedRate() ? tr(" The servo stays at %1 Hz.").arg(parts_.rate.hz()) : QString();
    forget(tr("The scene was changed, so the results no longer apply and have been discarded. Measure again.") + stays);
    return;
  }
  stale_ = true;
}

void LabPanel::present(const servo::Snapshot&) {
  if (stale_ && isSeen()) refresh();
}

void LabPanel::beginGesture() {
  gesture_ = parts_.document.newGesture();
}

Problems LabPanel::setScene(const scene::Description& scene) {
  return parts_.document.edit(scene, tr("speed or accuracy"), gesture_);
}

bool LabPanel::walkTo(int stop, bool rate_too) {
  if (stop < 0 || stop >= static_cast<int>(front_.size())) return false;
  const tradeoff::Point& point = result_.points[pointAt(stop)];
  const Problems problems =
      setScene(point.is_own ? order_.scene : withSettings(parts_.document.scene(), point.settings));
  if (!problems.empty()) measuring_->tell(tr("The scene is unchanged. %1").arg(sentencesOf(problems)), true);
  const bool done = problems.empty() && (!rate_too || setRate(point.settings.rate_hz));
  walk_->setStop(stop);
  refresh();
  return done;
}

bool LabPanel::setRate(int rate_hz) {
  const Problems problems = parts_.rate.tryOut(rate_hz);
  if (problems.empty())
    measuring_->tell(measuredText(), false);
  else
    measuring_->tell(tr("The rate stays at %1 Hz. %2").arg(parts_.rate.hz()).arg(sentencesOf(problems)), true);
  return problems.empty();
}

bool LabPanel::putBack() {
  if (result_.choice_results.empty()) return false;
  beginGesture();
  const Problems problems = setScene(order_.scene);
  if (!problems.empty()) measuring_->tell(tr("The scene is unchanged. %1").arg(sentencesOf(problems)), true);
  const bool done = setRate(order_.rate_hz) && problems.empty();
  refresh();
  return done;
}

std::optional<std::size_t> LabPanel::pointInEffect() const {
  const tradeoff::Settings settings = now();
  for (std::size_t index = 0; index < result_.points.size(); ++index) {
    if (result_.points[index].settings == settings) return index;
  }
  return std::nullopt;
}

void LabPanel::refresh() {
  stale_ = false;
  const bool is_open = parts_.document.isOpen(), is_busy = run_ != nullptr;
  measuring_->setBusy(is_busy, is_open);
  refreshTick();
  refreshWalk();
  choices_->present(is_open ? choiceWords(parts_.document.scene(), now(), result_.choice_results)
                            : std::vector<ChoiceWords>{});
}

void LabPanel::refreshTick() {
  if (!parts_.document.isOpen()) {
    tick_->clear();
    return;
  }
  const double tick_us = 1e-3 * predictedTick_ns(parts_.document.scene());
  const double period_us = 1e6 / parts_.rate.hz();
  tick_->setText(tr("Time of a tick: %1 predicted, %2 % of the period of %3 at %4 Hz.")
                     .arg(timeText(tick_us), numberText(100.0 * tick_us / period_us, 2), timeText(period_us))
                     .arg(parts_.rate.hz()));
}

void LabPanel::refreshWalk() {
  const std::optional<std::size_t> in_effect = front_.empty() ? std::nullopt : pointInEffect();
  const std::optional<std::size_t> chosen =
      walk_->present(result_.points, front_, in_effect, !result_.choice_results.empty());
  if (!front_.empty()) walk_->tell(wordsOf(chosen), differencesText());
}

QString LabPanel::wordsOf(const std::optional<std::size_t>& chosen) const {
  if (!chosen) return tr("The current settings are none of the combinations that were measured.");
  const tradeoff::Point& point = result_.points[*chosen];
  const QString words =
      tr("Processor time per second: %1. Error of the tip's path: %2, of the force: %3 N.")
          .arg(timeText(point.cost_us_per_s), lengthText(point.error_mm), numberText(point.error_N, 4));
  if (point.settings.rate_hz == parts_.rate.hz()) return words;
  return words + ' ' +
         tr("The rate changes to %1 Hz when you let go of the slider; the force is off for a moment then.")
             .arg(point.settings.rate_hz);
}

QString LabPanel::differencesText() const {
  QStringList lines;
  for (const tradeoff::Difference& one : tradeoff::differences(order_.scene, order_.own(), now())) {
    lines << tr("%1: %2 → %3").arg(QString::fromStdString(one.what), optionText(one.before), optionText(one.after));
  }
  return lines.isEmpty() ? tr("Nothing differs from the scene that was measured.") : lines.join('\n');
}

QString LabPanel::measuredText() const {
  return tr("Measured %1 combinations; %2 are best trade-offs.").arg(result_.points.size()).arg(front_.size()) +
         armText();
}

QString LabPanel::measuringText() const {
  if (!parts_.document.isOpen()) return tr("Open a scene to measure it.");
  const scene::Description& scene = parts_.document.scene();
  const double about_s = tradeoff::secondsToMeasure(scene, measuring_->handCount(), measuring_->seconds(),
                                                    parts_.rate.hz(), predictedTick_ns(scene));
  return tr("Nothing has been measured yet. Measure runs this scene on a simulated arm of its own with every "
            "combination of choices, and compares cost and error. This takes about %1; window and servo keep running.")
             .arg(durationText(about_s)) +
         armText();
}

/// Empty unless a measured arm is simulated in the window.
QString LabPanel::armText() const {
  if (!parts_.arm_in_use.isMeasured()) return {};
  return tr(" The arm simulated here has the vendor's values, not those of “%1”.")
      .arg(QString::fromStdString(parts_.arm_in_use.model().name));
}

void LabPanel::armChanged() {
  if (run_ != nullptr) return;
  if (!front_.empty())
    measuring_->tell(measuredText(), false);
  else if (result_.choice_results.empty())
    measuring_->tell(measuringText(), false);
}

void LabPanel::setTheme(const Theme& theme) {
  walk_->setTheme(theme);
}

}  // namespace underact::gui
