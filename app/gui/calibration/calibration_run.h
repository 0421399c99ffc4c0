#pragma once
#include <QObject>
#include <QTimer>
#include <array>
#include <cstddef>

#include "app/gui/model/servo_facts.h"
#include "core/calibration/measurement.h"
#include "device/simulated_subject.h"

namespace underact::gui {

class Document;

enum class Answering { Person, SimulatedHand };

struct CalibrationSetup {
  double reference_N_per_mm = 0.03;
  Answering who = Answering::Person;
  double weber = 0.15;  // of the simulated hand
  std::uint64_t seed = 1;
};

/// One measurement in the window. For a person the stiffness of each trial is tried out in place of the document's. The
/// simulated hand presses an arm of its own, one trial between two events of the window, so that the window responds.
class CalibrationRun : public QObject {
  Q_OBJECT
 public:
  enum class State { Idle, Running, Done };

  CalibrationRun(Document& document, ServoFacts servo, QObject* parent);

  /// Replaces a run that is under way. Problems: the scene does not have two beams.
  Problems begin(const CalibrationSetup& setup);
  /// A person's answer. false: no answer is due, or not both beams have been pressed.
  bool answer(calibration::Beam beam);
  /// Restores the scene's own stiffness. why: a sentence, if the user did not ask for it. false: nothing was running.
  bool cancel(const QString& why = {});
  /// From the result back to the start.
  void leave();
  void present(const servo::Snapshot& snapshot);

  State state() const { return state_; }
  const CalibrationSetup& setup() const { return setup_; }
  const calibration::Measurement& run() const { return run_; }
  /// Whether it has been pressed in this trial: a beam still held down from the last one has to be released first.
  bool isPressed(calibration::Beam beam) const { return pressed_[static_cast<std::size_t>(beam)]; }
  bool mayAnswer() const;
  bool isServoRunning() const { return servo_runs_; }
  /// Why the last run was cancelled, if not by the user.
  const QString& why() const { return why_; }

 signals:
  void changed();

 private:
  Problems tryOut();
  void step();
  void take(calibration::Beam beam);
  void sceneEdited();

  Document& document_;
  ServoFacts servo_;
  QTimer steps_;
  State state_ = State::Idle;
  CalibrationSetup setup_;
  calibration::Measurement run_;
  scene::Description scene_;                // as it was at the beginning
  std::array<std::size_t, 2> beams_{0, 0};  // indices of their constraints
  std::array<bool, 2> let_go_{}, pressed_{};
  std::uint64_t revision_ = 0;  // of this trial
  bool servo_runs_ = false;
  device::SimulatedSubject subject_;
  QString why_;
};

}  // namespace underact::gui
