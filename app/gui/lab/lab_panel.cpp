#include "app/gui/lab/lab_panel.h"

#include <QComboBox>
#include <QLabel>
#include <QProgressBar>
#include <QPushButton>
#include <QSignalBlocker>
#include <QSpinBox>
#include <QStyle>
#include <algorithm>
#include <utility>

#include "app/gui/kit/value_row.h"
#include "app/gui/kit/words.h"
#include "app/gui/lab/choice_list.h"
#include "app/gui/lab/front_chart.h"
#include "app/gui/lab/lab_words.h"
#include "app/gui/model/arm_in_use.h"
#include "app/gui/model/document.h"
#include "app/gui/model/servo_rate.h"
#include "core/scene/compile.h"
#include "core/scene/edit.h"
#include "core/tick/cost.h"
#include "core/trade/duration.h"

namespace underact::gui {
namespace {

double predictedTick_ns(const scene::Description& scene) {
  const Result<tick::TickProgram> program = scene::compile(scene);
  return program ? tick::predictedCost_ns(program.value()) : 0.0;
}

}  // namespace

LabPanel::LabPanel(const Parts& parts, QWidget* parent) : Panel(parent), parts_(parts) {
  build();
  addCommands();
  connect(&looks_, &QTimer::timeout, this, &LabPanel::look);
  connect(&parts_.document, &Document::opened, this, &LabPanel::sceneOpened);
  connect(&parts_.document, &Document::edited, this, &LabPanel::sceneEdited);
  connect(&parts_.rate, &ServoRate::changed, this, [this] { stale_ = true; });
  connect(&parts_.arm_in_use, &ArmInUse::changed, this, &LabPanel::armChanged);
  forget(whatMeasuringDoes());
}

LabPanel::~LabPanel() = default;

trade::Settings LabPanel::now() const {
  return trade::settingsOf(parts_.document.scene(), parts_.rate.hz());
}

bool LabPanel::measure(const std::string& hand, double seconds) {
  const std::vector<trade::NamedHand> hands = handsOf(hand);
  if (run_ != nullptr || hands.empty() || !parts_.document.isOpen() || !(seconds >= 0.1 && seconds <= 60.0))
    return false;
  forget(tr("Measuring. Window and servo go on; leave the scene as it is."));
  order_ = {parts_.document.scene(), hands, seconds, parts_.rate.hz()};
  run_ =
      std::make_unique<Background<LabResult>>([order = order_](WorkState& state) { return measureLab(order, state); });
  looks_.start();
  refresh();
  return true;
}

bool LabPanel::cancel() {
  if (run_ == nullptr) return false;
  run_->cancel();
  tell(tr("Cancelling: the run that is on its way ends first."), false);
  return true;
}

void LabPanel::look() {
  progress_->setValue(static_cast<int>(run_->share() * progress_->maximum()));
  std::optional<LabResult> result = run_->take();
  if (!result) return;
  looks_.stop();
  const bool is_cancelled = run_->isCancelled();
  run_.reset();
  if (is_cancelled)
    forget(tr("Cancelled. Nothing was kept: a part would look like the whole."));
  else if (!isMeasuredScene(order_))
    forget(tr("The scene was changed meanwhile: what was measured is of another one. Measure again."));
  else
    end(std::move(*result));
}

void LabPanel::end(LabResult result) {
  result_ = std::move(result);
  front_.clear();
  for (std::size_t index = 0; index < result_.points.size(); ++index) {
    const trade::Point& point = result_.points[index];
    if (!point.on_front) continue;
    // A substep longer than the period is the period: two ways, one and the same run. Of such the scene's own stays.
    if (!front_.empty() && result_.points[front_.back()].error_mm == point.error_mm) {
      if (point.is_own) front_.back() = index;
      continue;
    }
    front_.push_back(index);
  }
  if (front_.empty()) {
    tell(tr("The finest run of this scene, or each other one, ended in a fault, so there is no front to walk on. What "
            "could be measured stands below. Softer gains may help."),
         true);
  } else {
    tell(whatWasMeasured(), false);
  }
  refresh();
}

void LabPanel::forget(const QString& why) {
  result_ = {};
  front_.clear();
  tell(why, false);
  refresh();
}

bool LabPanel::isMeasuredScene(const LabOrder& order) const {
  const trade::Settings own = order.own();
  return scene::isSame(withSettings(parts_.document.scene(), own), withSettings(order.scene, own));
}

/// A rate that was tried here and that nobody chose to stay.
bool LabPanel::hasTriedRate() const {
  return !result_.standings.empty() && parts_.rate.hz() != order_.rate_hz && parts_.rate.chosen() != parts_.rate.hz();
}

void LabPanel::sceneOpened() {
  cancel();
  if (run_ != nullptr) return;
  // Another scene begins at the rate that was there before; where that is refused, it is told.
  const Problems problems = hasTriedRate() ? parts_.rate.tryOut(order_.rate_hz) : Problems{};
  const QString stays = problems.empty() ? QString() : tr(" The rate stays at %1 Hz. ").arg(parts_.rate.hz());
  forget(whatMeasuringDoes() + stays + sentencesOf(problems));
}

void LabPanel::sceneEdited() {
  if (!result_.standings.empty() && !isMeasuredScene(order_)) {
    const QString stays = hasTriedRate() ? tr(" The servo stays at %1 Hz.").arg(parts_.rate.hz()) : QString();
    forget(tr("The scene was changed: the figures were of another one and are gone. Measure again.") + stays);
    return;
  }
  stale_ = true;
}

void LabPanel::present(const servo::Snapshot&) {
  if (stale_ && isSeen()) refresh();
}

void LabPanel::beginGesture() {
  gesture_ = parts_.document.newGesture();
  since_step_.start();
}

Problems LabPanel::setScene(const scene::Description& scene) {
  return parts_.document.edit(scene, tr("speed or accuracy"), gesture_);
}

bool LabPanel::walkTo(int stop, bool rate_too) {
  if (stop < 0 || stop >= static_cast<int>(front_.size())) return false;
  const trade::Point& point = result_.points[pointAt(stop)];
  const Problems problems =
      setScene(point.is_own ? order_.scene : withSettings(parts_.document.scene(), point.settings));
  if (!problems.empty()) tell(tr("The scene stays. %1").arg(sentencesOf(problems)), true);
  const bool done = problems.empty() && (!rate_too || setRate(point.settings.rate_hz));
  {
    const QSignalBlocker silent(walk_);
    walk_->setValue(stop);
  }
  refresh();
  return done;
}

bool LabPanel::setRate(int rate_hz) {
  const Problems problems = parts_.rate.tryOut(rate_hz);
  if (problems.empty())
    tell(whatWasMeasured(), false);
  else
    tell(tr("The rate stays at %1 Hz. %2").arg(parts_.rate.hz()).arg(sentencesOf(problems)), true);
  return problems.empty();
}

bool LabPanel::putBack() {
  if (result_.standings.empty()) return false;
  beginGesture();
  const Problems problems = setScene(order_.scene);
  if (!problems.empty()) tell(tr("The scene stays. %1").arg(sentencesOf(problems)), true);
  const bool done = setRate(order_.rate_hz) && problems.empty();
  refresh();
  return done;
}

std::optional<std::size_t> LabPanel::pointInEffect() const {
  const trade::Settings settings = now();
  for (std::size_t index = 0; index < result_.points.size(); ++index) {
    if (result_.points[index].settings == settings) return index;
  }
  return std::nullopt;
}

void LabPanel::refresh() {
  stale_ = false;
  const bool is_open = parts_.document.isOpen(), is_busy = run_ != nullptr, is_measured = !result_.standings.empty();
  measure_->setEnabled(is_open && !is_busy);
  hands_->setEnabled(!is_busy);
  seconds_->setEnabled(!is_busy);
  progress_->setVisible(is_busy);
  cancel_->setVisible(is_busy);
  chart_->setVisible(is_measured && !result_.points.empty());
  refreshTick();
  refreshWalk();
  choices_->present(is_open ? choiceWords(parts_.document.scene(), now(), result_.standings)
                            : std::vector<ChoiceWords>{});
}

void LabPanel::refreshTick() {
  if (!parts_.document.isOpen()) {
    tick_->clear();
    return;
  }
  const double tick_us = 1e-3 * predictedTick_ns(parts_.document.scene());
  const double period_us = 1e6 / parts_.rate.hz();
  tick_->setText(tr("A tick of this scene: %1 predicted, %2 % of its period of %3 at %4 Hz.")
                     .arg(timeText(tick_us), numberText(100.0 * tick_us / period_us, 2), timeText(period_us))
                     .arg(parts_.rate.hz()));
}

void LabPanel::refreshWalk() {
  const bool has_front = !front_.empty();
  walk_->setEnabled(has_front);
  back_->setEnabled(has_front);
  const QSignalBlocker silent(walk_);
  walk_->setRange(0, std::max(0, static_cast<int>(front_.size()) - 1));
  differences_->setVisible(has_front);
  if (!has_front) {
    walk_->setMark(-1.0);
    chosen_->setText(tr("There is nothing to choose from yet."));
    chart_->present(frontSheet({}, {}));
    return;
  }
  const auto own =
      std::find_if(front_.begin(), front_.end(), [this](std::size_t point) { return result_.points[point].is_own; });
  walk_->setMark(own == front_.end() ? -1.0 : static_cast<double>(own - front_.begin()));
  std::optional<std::size_t> chosen = pointInEffect();
  if (walk_->isSliderDown())
    chosen = pointAt(walk_->value());
  else if (chosen)
    walk_->setValue(stopBefore(*chosen));
  chart_->present(frontSheet(result_.points, chosen));
  chosen_->setText(wordsOf(chosen));
  refreshDifferences();
}

int LabPanel::stopBefore(std::size_t point) const {
  const auto dearer = std::upper_bound(front_.begin(), front_.end(), point);  // points are in the order of their cost
  return std::max(0, static_cast<int>(dearer - front_.begin()) - 1);
}

QString LabPanel::wordsOf(const std::optional<std::size_t>& chosen) const {
  if (!chosen) return tr("What is set now is none of the ways that were measured.");
  const trade::Point& point = result_.points[*chosen];
  const QString words =
      tr("%1 of processor time a second, the tip %2 off its way, the force %3 N.")
          .arg(timeText(point.cost_us_per_s), lengthText(point.error_mm), numberText(point.error_N, 4));
  if (point.settings.rate_hz == parts_.rate.hz()) return words;
  return words + ' ' +
         tr("The rate of %1 Hz comes when you let go of the slider; the force lets go for a moment then.")
             .arg(point.settings.rate_hz);
}

void LabPanel::refreshDifferences() {
  QStringList lines;
  for (const trade::Difference& one : trade::differences(order_.scene, order_.own(), now())) {
    lines << tr("%1: %2 → %3")
                 .arg(QString::fromStdString(one.what), QString::fromStdString(one.before),
                      QString::fromStdString(one.after));
  }
  differences_->setText(lines.isEmpty() ? tr("Nothing differs from how it was measured.") : lines.join('\n'));
}

void LabPanel::tell(const QString& sentence, bool alarm) {
  told_->setText(sentence);
  told_->setProperty("role", alarm ? "amber" : "quiet");
  told_->style()->polish(told_);
}

QString LabPanel::whatWasMeasured() const {
  return tr("Measured: %1 ways to run this scene, %2 of them on the front.")
             .arg(result_.points.size())
             .arg(front_.size()) +
         whichArm();
}

QString LabPanel::whatMeasuringDoes() const {
  if (!parts_.document.isOpen()) return tr("Open a scene: then it can be measured.");
  const scene::Description& scene = parts_.document.scene();
  const auto hands = static_cast<std::size_t>(hands_->currentIndex() == 0 ? hands_->count() - 1 : 1);
  const double about_s =
      trade::secondsToMeasure(scene, hands, seconds_->value(), parts_.rate.hz(), predictedTick_ns(scene));
  return tr("Nothing is measured yet. Measure runs this scene on a simulated arm of its own, in every way that it can "
            "be run, and lays what each costs against how far it is off: about %1 here. Window and servo go on.")
             .arg(durationText(about_s)) +
         whichArm();
}

/// Empty where it is the one that everybody would think of.
QString LabPanel::whichArm() const {
  if (!parts_.arm_in_use.isMeasured()) return {};
  return tr(" The arm that is simulated here has the vendor's figures, not those of “%1”.")
      .arg(QString::fromStdString(parts_.arm_in_use.model().name));
}

void LabPanel::armChanged() {
  if (run_ != nullptr) return;
  if (!front_.empty())
    tell(whatWasMeasured(), false);
  else if (result_.standings.empty())
    tell(whatMeasuringDoes(), false);
}

void LabPanel::setTheme(const Theme& theme) {
  chart_->setTheme(theme);
}

}  // namespace underact::gui
