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

/// One measurement in the window. For a person each trial's stiffness is tried out in the document's place; the
/// simulated hand presses an arm of its own, a trial between two events of the window, so that it stays alive.
class CalibrationSession : public QObject {
  Q_OBJECT
 public:
  enum class State { Idle, Running, Done };

  CalibrationSession(Document& document, ServoFacts servo, QObject* parent);

  /// In place of a run there is. Problems: the scene has not two beams.
  Problems begin(const CalibrationSetup& setup);
  /// Of a person. false: nobody is asked, or the beams have not both been pressed.
  bool answer(calibration::Beam beam);
  /// The scene's own stiffness is in effect again. why: a sentence, where it was not asked for. false: nothing ran.
  bool cancel(const QString& why = {});
  /// From a result back to the beginning.
  void leave();
  void present(const servo::Snapshot& snapshot);

  State state() const { return state_; }
  const CalibrationSetup& setup() const { return setup_; }
  const calibration::Measurement& run() const { return run_; }
  /// In this trial, anew: a beam that is still held down from the last one has to be let go first.
  bool isPressed(calibration::Beam beam) const { return pressed_[static_cast<std::size_t>(beam)]; }
  bool mayAnswer() const;
  bool isServoRunning() const { return servo_runs_; }
  /// Why the last run was cancelled, if it was not asked for.
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
  scene::Description scene_;                // its own, as it was at the beginning
  std::array<std::size_t, 2> beams_{0, 0};  // the constraints that they are
  std::array<bool, 2> let_go_{}, pressed_{};
  std::uint64_t revision_ = 0;  // of this trial
  bool servo_runs_ = false;
  device::SimulatedSubject subject_;
  QString why_;
};

}  // namespace underact::gui
