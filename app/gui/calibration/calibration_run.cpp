#include "app/gui/calibration/calibration_run.h"

#include <utility>

#include "app/gui/kit/words.h"
#include "app/gui/model/document.h"
#include "core/base/units.h"
#include "core/scene/edit.h"

namespace underact::gui {

using calibration::Beam;

constexpr double kPressed_N = 0.05;  // five times the last digit of the force shown: the hand has felt something

CalibrationRun::CalibrationRun(Document& document, ServoFacts servo, QObject* parent)
    : QObject(parent), document_(document), servo_(servo) {
  connect(&steps_, &QTimer::timeout, this, &CalibrationRun::step);
  connect(&document_, &Document::opened, this, [this] {
    leave();
    if (!cancel(tr("Another scene was opened, so the measurement was cancelled."))) why_.clear();
  });
  connect(&document_, &Document::edited, this, &CalibrationRun::sceneEdited);
}

Problems CalibrationRun::begin(const CalibrationSetup& setup) {
  cancel();
  if (document_.isTryingOut())
    return Problems{{phrase(QT_TRANSLATE_NOOP("problem", "Another measurement is running. End it first."))}};
  auto beams = calibration::beamsOf(document_.scene());
  if (!beams) return beams.problems();
  beams_ = beams.value();
  scene_ = document_.scene();
  setup_ = setup;
  run_ = calibration::beginMeasurement(setup.reference_N_per_mm, setup.seed);
  subject_ = {setup.weber, setup.seed + 1};
  why_.clear();
  if (setup.who == Answering::Person) {
    Problems problems = tryOut();
    if (!problems.empty()) return problems;
  } else {
    steps_.start(0);
  }
  state_ = State::Running;
  emit changed();
  return {};
}

Problems CalibrationRun::tryOut() {
  const auto tried = withStiffness(scene_, run_.trial);
  if (!tried) return tried.problems();
  Problems problems = document_.tryOut(tried.value());
  revision_ = servo_.revision();
  let_go_ = pressed_ = {};
  return problems;
}

bool CalibrationRun::mayAnswer() const {
  return state_ == State::Running && setup_.who == Answering::Person && pressed_[0] && pressed_[1];
}

bool CalibrationRun::answer(Beam beam) {
  if (!mayAnswer()) return false;
  take(beam);
  return true;
}

void CalibrationRun::take(Beam beam) {
  run_ = answered(std::move(run_), beam);
  if (isDone(run_)) {
    steps_.stop();
    document_.putBack();
    state_ = State::Done;
  } else if (setup_.who == Answering::Person) {
    const Problems problems = tryOut();
    if (!problems.empty()) cancel(sentencesOf(problems));
  }
  emit changed();
}

void CalibrationRun::step() {
  const auto pressed = withStiffness(scene_, run_.trial);
  const auto answer = pressed ? device::answerOf(subject_, pressed.value()) : Result<Beam>(pressed.problems());
  if (answer)
    take(answer.value());
  else
    cancel(sentencesOf(answer.problems()));
}

bool CalibrationRun::cancel(const QString& why) {
  if (state_ != State::Running) return false;
  steps_.stop();
  document_.putBack();
  state_ = State::Idle;
  why_ = why;
  emit changed();
  return true;
}

void CalibrationRun::leave() {
  if (state_ != State::Done) return;
  state_ = State::Idle;
  why_.clear();
  emit changed();
}

void CalibrationRun::sceneEdited() {
  if (state_ != State::Running) return;
  // Saving a scene emits edited() as well; the scene is then unchanged and still being tried out.
  const bool taken_away = setup_.who == Answering::Person && !document_.isTryingOut();
  if (taken_away || !scene::isSame(scene_, document_.scene()))
    cancel(tr("The scene was changed, so the measurement was cancelled."));
}

void CalibrationRun::present(const servo::Snapshot& snapshot) {
  if (state_ != State::Running || setup_.who != Answering::Person) return;
  const auto before = std::pair{pressed_, servo_runs_};
  servo_runs_ = snapshot.mode == servo::Mode::Running;
  const bool feels = servo_runs_ && snapshot.report.force.f_T_W().norm() > kPressed_N;
  for (const Beam beam : {Beam::Left, Beam::Right}) {
    if (snapshot.revision != revision_) break;  // still the previous trial
    const auto side = static_cast<std::size_t>(beam);
    const tick::ConstraintReport& held = snapshot.report.held[beams_[side]];
    // Far from a beam the stylus is pulled towards it; only bending the beam shows how stiff it is.
    const double stiffness_N_per_mm = beam == Beam::Left ? run_.trial.left_N_per_mm : run_.trial.right_N_per_mm;
    const double bent_m = held.acts ? (held.p_WP - calibration::tipOf(scene_, beam)).norm() : 0.0;
    const bool is_bent = stiffness_N_per_mm * kNewtonPerMetre * bent_m > kPressed_N;
    let_go_[side] = let_go_[side] || !is_bent;
    pressed_[side] = pressed_[side] || (let_go_[side] && feels && is_bent);
  }
  if (before != std::pair{pressed_, servo_runs_}) emit changed();
}

}  // namespace underact::gui
