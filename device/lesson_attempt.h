#pragma once
#include <memory>
#include <string>
#include <vector>

#include "core/lesson/check.h"
#include "core/servo/host.h"
#include "core/sim/arm_model.h"
#include "core/sim/hand_script.h"

namespace underact::device {

/// A setting of the scene that a student would change: "kp_N_per_mm" to "0.8".
struct LessonSetting {
  std::string key;
  std::string value;
};

/// One attempt at a step of a lesson by a scripted hand, instead of a student at the window.
struct LessonAttempt {
  sim::HandScript hand;
  double seconds = 0.0;  // 0: the duration of the hand's path plus one second
  bool starts = true;    // the servo is started; false: the arm is only moved
  std::vector<LessonSetting> settings;
  std::vector<double> answers;  // to the questions of the step in order, at the end; for a choice its number
  sim::ArmModel model = *sim::findArmModel(sim::kDefaultArmModel);
};

struct LessonOutcome {
  std::vector<lesson::CheckState> states;  // one for each check
  Fault fault = {};                        // the one that stopped the servo
  bool isSolved() const { return fault.kind == FaultKind::None && lesson::isSolved(states); }
};

/// The scene with a student's setting: its path, or its key for each constraint that has it. Problems: no such setting,
/// or a value it cannot have.
Result<scene::Description> withSetting(const scene::Description& scene, const LessonSetting& setting);

class SimulatedArm;

/// A simulated arm at which steps are tried one after another, as a student goes from lesson to lesson: each begins
/// with the arm and the servo as the last one left them, but for what the step itself sets.
class LessonDesk {
 public:
  explicit LessonDesk(const sim::ArmModel& model = *sim::findArmModel(sim::kDefaultArmModel));
  ~LessonDesk();
  /// As tryLessonStep(); the step begins at rest or in its pose. hand without a path: nobody touches the arm, for
  /// attempt.seconds.
  Result<LessonOutcome> tryStep(const lesson::Step& step, scene::Description scene, const LessonAttempt& attempt);

 private:
  sim::ArmModel model_;
  SimulatedArm* arm_ = nullptr;  // of the host
  std::unique_ptr<servo::Host> host_;
};

/// Runs it on a simulated arm of its own, as fast as the machine allows, with the same numbers every time. scene: the
/// step's, with its meshes loaded. The hand begins where it is, not where the step would place it. Problems: those of
/// the settings and the scene; more answers than questions.
Result<LessonOutcome> tryLessonStep(const lesson::Step& step, scene::Description scene, const LessonAttempt& attempt);

}  // namespace underact::device
