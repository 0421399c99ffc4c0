#pragma once
#include <string>
#include <vector>

#include "core/lesson/check.h"
#include "core/sim/arm_model.h"
#include "core/sim/hand_script.h"

namespace underact::device {

/// What a student would change of the scene: "kp_N_per_mm" to "0.8".
struct LessonSetting {
  std::string key;
  std::string value;
};

/// One go at a step of a lesson by a scripted hand, in place of a student at the window.
struct LessonAttempt {
  sim::HandScript hand;
  double seconds = 0.0;  // 0: as long as the hand's path, and a second
  bool starts = true;    // the servo is started; false: the arm is only moved
  std::vector<LessonSetting> settings;
  std::vector<double> answers;  // to the questions of the step in their order, at the end; of a choice its number
  sim::ArmModel model = *sim::findArmModel(sim::kDefaultArmModel);
};

struct LessonOutcome {
  std::vector<lesson::CheckState> states;  // one for each check
  Fault fault = {};                        // that stopped the servo
  bool isSolved() const { return fault.kind == FaultKind::None && lesson::isSolved(states); }
};

/// The scene with a setting of the student's: its path, or its key, of each constraint that has it. Problems: none
/// such, or what it may not be.
Result<scene::Description> withSetting(const scene::Description& scene, const LessonSetting& setting);

/// Runs it on a simulated arm of its own, as fast as the machine allows; the same numbers every time. scene: the
/// step's, with its meshes loaded. Problems: those of the settings and the scene; more answers than questions.
Result<LessonOutcome> tryLessonStep(const lesson::Step& step, scene::Description scene, const LessonAttempt& attempt);

}  // namespace underact::device
