#include "app/gui/identify/identify_run.h"

#include <algorithm>
#include <utility>

#include "app/gui/kit/words.h"
#include "app/gui/model/arm_choice.h"
#include "app/gui/model/arm_in_use.h"
#include "app/gui/model/document.h"
#include "app/gui/model/player.h"
#include "app/gui/view/scene_view.h"
#include "core/base/units.h"
#include "core/scene/scene_arm.h"

namespace underact::gui {

using identify::Measurement;
using identify::StageKind;

IdentifyRun::IdentifyRun(const IdentifyParts& parts, QObject* parent) : QObject(parent), parts_(parts) {
  connect(&parts_.document, &Document::opened, this,
          [this] { end(tr("Another scene was opened, so the measurement was ended.")); });
  // Before the file is read: the player restores at its close the scene that it finds now, which must not be ours.
  connect(&parts_.player, &Player::loading, this,
          [this] { end(tr("A recording was opened, so the measurement was ended.")); });
  connect(&parts_.in_use, &ArmInUse::changed, this,
          [this] { end(tr("Another arm is simulated now, so the measurement was ended.")); });
}

IdentifyRun::~IdentifyRun() = default;

Problems IdentifyRun::begin(identify::Wanted wanted) {
  cancel();
  Problems problems = refusalNow();
  if (!problems.empty()) return problems;
  wanted.arm_of = scene::withArmOf(parts_.document.scene(), {});
  Result<identify::Plan> plan = identify::makePlan(wanted);
  if (!plan) return plan.problems();
  was_running_ = parts_.servo.running();
  is_own_start_ = is_begun_ = has_pushed_ = false;
  found_.reset();
  given_.reset();
  fit_ = {};
  fitted_stages_ = 0;
  measurement_.emplace(std::move(plan).value(), [this](const scene::Description& scene) { return put(scene); });
  if (device::SimulatedArm* const arm = parts_.arms.simulated()) {
    const arm::Preset& preset = scene::armOf(wanted.arm_of);
    person_ = std::make_unique<device::SimulatedPerson>(*arm, preset);
    given_ = identify::Given{sim::modelFor(preset, parts_.in_use.model()), preset.counts_per_turn};
    if (given_->model.counts_per_turn)
      given_->counts_per_turn = sim::countsOf(*given_->model.counts_per_turn, preset.counts_per_turn);
  }
  revision_ = parts_.servo.revision();
  setState(State::Asks);
  return {};
}

/// Empty if the measurement can begin or continue.
Problems IdentifyRun::refusalNow() const {
  if (!parts_.document.isOpen())
    return Problems{
        {phrase(QT_TRANSLATE_NOOP("problem", "Open a scene first. It is restored after the measurement."))}};
  if (!arm::isDevice(scene::armOf(parts_.document.scene())))
    return Problems{{phrase(QT_TRANSLATE_NOOP("problem",
                                              "Only arms with the geometry of table 3.1 of the thesis can be measured. "
                                              "Open a scene for one of them."))}};
  if (parts_.player.isOpen() || parts_.player.isLoading())
    return Problems{{phrase(QT_TRANSLATE_NOOP("problem", "A recording is being replayed. Close it first."))}};
  if (parts_.document.isTryingOut() && !hasOwnScene())
    return Problems{{phrase(QT_TRANSLATE_NOOP("problem", "Another measurement is running. End it first."))}};
  if (parts_.servo.holdToRun())
    return Problems{{phrase(QT_TRANSLATE_NOOP(
        "problem", "Hold to run is on, but this measurement needs your hand off the stylus. Switch it off first."))}};
  return {};
}

bool IdentifyRun::hasSimulatedPerson() const {
  return parts_.arms.simulated() != nullptr;
}

/// Whether the scene that is being tried out belongs to this measurement.
bool IdentifyRun::hasOwnScene() const {
  return measurement_ && parts_.document.isTryingOut() && parts_.servo.revision() == revision_;
}

Result<std::uint64_t> IdentifyRun::put(const scene::Description& scene) {
  const Problems problems = parts_.document.tryOut(scene);
  if (!problems.empty()) return problems;
  revision_ = parts_.servo.revision();
  parts_.view.followEdit(scene);
  return revision_;
}

/// Uses only the snapshot of the last frame: another look at the host would take the current one from its viewers.
void IdentifyRun::startServo() {
  started_ticks_ = ticks_;
  has_pushed_ = mode_ == servo::Mode::Running;
  if (has_pushed_) return;
  parts_.control.start();
  is_own_start_ = true;
}

/// Empty while the servo runs, or was started less than a second ago.
QString IdentifyRun::stopReason(const servo::Snapshot& snapshot) const {
  const bool waits = !has_pushed_ && snapshot.ticks - started_ticks_ < parts_.servo.rateHz();
  if (snapshot.mode == servo::Mode::Running || waits) return {};
  if (snapshot.mode == servo::Mode::Faulted)
    return tr("%1 Force is off. Fix the cause, then press “Repeat this part”.")
        .arg(sentenceText(whatHappened(snapshot.report.fault)));
  return tr("The servo was stopped.");
}

void IdentifyRun::resume() {
  if (state_ != State::Asks) return;
  if (!is_begun_) rate_hz_ = parts_.servo.rateHz();
  if (!mayGoOn()) return;
  is_begun_ = true;
  startServo();
  const Problems problems = measurement_->go();
  problems.empty() ? setState(State::Runs) : stopped(sentencesOf(problems));
}

/// All samples of a measurement must have the same rate.
QString IdentifyRun::rateRefusal() const {
  if (parts_.servo.rateHz() == rate_hz_) return {};
  return tr("The servo rate was changed during the measurement. Set it back to %1 Hz, or go back and begin again.")
      .arg(rate_hz_);
}

/// Repeats the checks of begin(). false: the measurement is stopped or has ended.
bool IdentifyRun::mayGoOn() {
  if (!scene::haveSameArm(parts_.document.scene(), measurement_->plan().stages.front().scene)) {
    end(tr("The scene is for another arm now, so the measurement was ended."));
    return false;
  }
  const Problems problems = refusalNow();
  const QString why = problems.empty() ? rateRefusal() : sentencesOf(problems);
  if (!why.isEmpty()) stopped(why);
  return why.isEmpty();
}

void IdentifyRun::repeat() {
  if (state_ != State::Stopped || !mayGoOn()) return;
  is_begun_ = true;
  startServo();
  revision_ = parts_.servo.revision();
  fit_ = {};
  fitted_stages_ = 0;
  const Problems problems = measurement_->repeat();
  problems.empty() ? setState(State::Runs) : stopped(sentencesOf(problems));
}

void IdentifyRun::stopped(const QString& why) {
  measurement_->interrupt(why.toStdString());
  setState(State::Stopped, why);
}

/// Ends the measurement: it cannot continue, only begin again.
void IdentifyRun::end(const QString& why) {
  if (!measurement_) return;
  release();
  setState(State::Failed, why);
}

/// Restores what the measurement changed: the scene, the servo, the hand.
void IdentifyRun::release() {
  // The force first: a fit in the background may take a while to end.
  if (hasOwnScene()) {
    parts_.document.putBack();
    parts_.view.followEdit(parts_.document.scene());
  }
  if (is_own_start_ && !was_running_) parts_.control.stop();
  person_.reset();
  measurement_.reset();
  live_.reset();
}

void IdentifyRun::cancel() {
  evaluation_.reset();
  if (measurement_) release();
  if (state_ != State::Idle) setState(State::Idle);
}

void IdentifyRun::add(const servo::TickRecord& record) {
  if (!measurement_) return;
  q_rad_ = record.q_rad;
  measurement_->add(record);
}

void IdentifyRun::poll(const servo::Snapshot& snapshot) {
  ticks_ = snapshot.ticks;
  mode_ = snapshot.mode;
  has_pushed_ = has_pushed_ || mode_ == servo::Mode::Running;
  if (has_pushed_ && mode_ != servo::Mode::Running) is_own_start_ = false;  // a later start is the user's
  if (evaluation_) return takeEvaluation();
  if (!measurement_) return;
  if (person_) person_->act(*measurement_, q_rad_);
  if (state_ != State::Runs && state_ != State::Asks) return;
  if (state_ == State::Runs && parts_.servo.revision() != revision_)
    return stopped(tr("The scene was changed during the measurement."));
  if (is_begun_) {
    if (const QString why = rateRefusal(); !why.isEmpty()) return stopped(why);
    if (const QString why = stopReason(snapshot); !why.isEmpty()) return stopped(why);
  }
  if (state_ == State::Asks && person_) return resume();
  if (state_ == State::Asks) return;
  const Problems problems = measurement_->advance();
  if (!problems.empty()) return stopped(sentencesOf(problems));
  if (measurement_->state() == Measurement::State::Done) return evaluate();
  fitLive();
  if (measurement_->state() == Measurement::State::Asks) return setState(State::Asks);
  emit progressed();
}

void IdentifyRun::takeEvaluation() {
  std::optional<Result<identify::Identified>> done = evaluation_->take();
  if (!done) return;
  evaluation_.reset();
  if (*done) found_ = std::move(*done).value();
  *done ? setState(State::Done) : setState(State::Failed, sentencesOf(done->problems()));
}

void IdentifyRun::evaluate() {
  const int rate_hz = rate_hz_;
  evaluation_ = std::make_unique<Background<Result<identify::Identified>>>(
      [plan = measurement_->plan(), recorded = measurement_->recorded(), rate_hz](WorkState& work) {
        return identify::evaluate(plan, recorded, rate_hz, [&work] { return work.cancelled.load(); });
      });
  release();
  setState(State::Evaluates);
}

void IdentifyRun::setState(State state, const QString& why) {
  state_ = state;
  why_ = why;
  emit changed();
}

QString IdentifyRun::stage() const {
  if (state_ == State::Evaluates) return tr("Evaluating");
  return measurement_ ? sentenceText(titleOf(measurement_->stage())) : QString();
}

QString IdentifyRun::prompt() const {
  if (!measurement_) return {};
  if (person_)
    return tr("A simulated hand does this for you: %1").arg(sentenceText(promptOf(measurement_->stage().hand)));
  return sentenceText(promptOf(measurement_->stage().hand));
}

/// The first recorded stage of the swings along the axis that was recorded last.
std::size_t IdentifyRun::firstOfAxis() const {
  const std::vector<identify::Recorded>& recorded = measurement_->recorded();
  std::size_t first = recorded.size();
  const auto isAlike = [&](std::size_t index) {
    const identify::Stage& stage = measurement_->plan().stages[recorded[index].stage];
    const identify::Stage& last = measurement_->plan().stages[recorded.back().stage];
    return stage.kind == StageKind::Swing && stage.axis == last.axis && stage.place == last.place;
  };
  while (first > 0 && isAlike(first - 1)) --first;
  return first;
}

/// Fits the swings of the axis so far, in the background, each time another one has been recorded.
void IdentifyRun::fitLive() {
  if (live_) {
    std::optional<LiveFit> fit = live_->take();
    if (!fit) return;
    fit_ = std::move(*fit);
    live_.reset();
  }
  const std::vector<identify::Recorded>& recorded = measurement_->recorded();
  const std::size_t first = firstOfAxis();
  if (recorded.size() < first + 3 || recorded.size() == fitted_stages_) return;
  fitted_stages_ = recorded.size();
  std::vector<identify::MotionRow> rows;
  for (std::size_t index = first; index + 1 < recorded.size(); ++index)
    rows.insert(rows.end(), recorded[index].rows.begin(), recorded[index].rows.end());
  const int axis = measurement_->plan().stages[recorded.back().stage].axis;
  live_ = std::make_unique<Background<LiveFit>>(
      [rows = std::move(rows), axis, first, period_s = 1.0 / parts_.servo.rateHz()](WorkState& work) {
        const std::vector<identify::Window> windows = windowsOf(rows, Vec3::Unit(axis), period_s);
        const Result<identify::BodyFit> fit = identify::fitBody(windows, [&work] { return work.cancelled.load(); });
        return fit ? LiveFit{first, pointsOf(windows, fit.value().travel_m)} : LiveFit{first, {}};
      });
}

SwingPicture IdentifyRun::picture() const {
  SwingPicture picture;
  if (!measurement_ || measurement_->recorded().empty()) return picture;
  const std::vector<identify::Recorded>& recorded = measurement_->recorded();
  const std::size_t first = firstOfAxis();
  if (first == recorded.size()) return picture;
  const int axis = measurement_->plan().stages[recorded.back().stage].axis;
  picture.axis = "xyz"[axis];
  const double period_s = 1.0 / parts_.servo.rateHz();
  double t_s = 0.0;
  for (std::size_t index = first; index < recorded.size(); ++index) {
    for (const identify::MotionRow& row : recorded[index].rows) {
      picture.target.push_back({t_s, kMillimetrePerMetre * row.p_WP[axis]});
      picture.measured.push_back({t_s, kMillimetrePerMetre * row.p_WT[axis]});
      t_s += period_s;
    }
  }
  if (fit_.first == first) picture.fit = fit_.points;
  return picture;
}

}  // namespace underact::gui
