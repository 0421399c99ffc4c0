#pragma once
#include <optional>
#include <string_view>
#include <vector>

#include "core/arm/preset.h"
#include "core/lesson/check.h"

namespace underact::lesson {

// What a step needs before the student begins: where the arm is, what is drawn, and what is not said yet.

/// How long the lesson takes, min: as its file says, else two for each step.
double minutesOf(const Lesson& lesson);

/// The joints with which the simulated arm begins the step, rad (m where a joint slides); none: where it rests. A pose
/// with fewer values than the arm has joints leaves the others at 0; values beyond the last joint do not count.
std::optional<arm::JointAngles> startOf(const Step& step, const arm::Preset& arm);

/// Whether a question that is not answered yet asks for this quantity, so that the window does not say it beside the
/// question. states: of the step's checks.
bool asksFor(const Step& step, const std::vector<CheckState>& states, std::string_view quantity_key);

/// A place in W where a check wants the tip.
struct TargetPlace {
  Vec3 p_WT = Vec3::Zero();  // m
  double within_m = 0.0;
  std::size_t check = 0, place = 0;  // from 0; place: of those to visit
};

/// The places where the step's checks want the tip: of tip_mm and of tip_in_base_mm, where all three parts are given,
/// and of q_deg where the first three joints of an arm that solvesInTick() are. Not of conditions meanwhile, and not of
/// questions.
std::vector<TargetPlace> targetsOf(const Step& step, const arm::Preset& arm);

/// Whether that place has been reached.
bool isReached(const TargetPlace& target, const std::vector<CheckState>& states);

}  // namespace underact::lesson
