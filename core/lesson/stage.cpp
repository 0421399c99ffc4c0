#include "core/lesson/stage.h"

#include <algorithm>
#include <cmath>

#include "core/arm/forward.h"
#include "core/arm/mechanism.h"
#include "core/base/units.h"

namespace underact::lesson {
namespace {

constexpr double kMinutesOfStep = 2.0;
constexpr double kReachOfJoints_m = 0.006;  // of the ball that is drawn where joints lead the tip

/// The place in W of one value of a measure; none: it is no place, or is not wholly given.
std::optional<TargetPlace> placeOf(const Measure& measure, const std::vector<double>& near, double within,
                                   const arm::Preset& arm) {
  const bool all = near.size() >= 3 && std::isfinite(near[0]) && std::isfinite(near[1]) && std::isfinite(near[2]);
  if (!all || measure.quantity == nullptr || measure.part > 0) return {};
  const std::string_view key = measure.quantity->key;
  const Vec3 place = Vec3(near[0], near[1], near[2]);
  if (key == "tip_mm") return TargetPlace{kMetrePerMillimetre * place, kMetrePerMillimetre * within, 0, 0};
  if (!arm::solvesInTick(arm.geometry)) return {};
  if (key == "tip_in_base_mm")
    return TargetPlace{arm.geometry.p_WB + arm::workspaceFromBase() * (kMetrePerMillimetre * place),
                       kMetrePerMillimetre * within, 0, 0};
  if (key != "q_deg") return {};
  const Vec3 q_rad = kRadPerDegree * place;
  const arm::JointAngles joints{q_rad.x(), q_rad.y(), q_rad.z()};
  return TargetPlace{arm::tipPosition(arm.geometry, joints), kReachOfJoints_m, 0, 0};
}

}  // namespace

double minutesOf(const Lesson& lesson) {
  return lesson.minutes > 0.0 ? lesson.minutes : kMinutesOfStep * static_cast<double>(lesson.steps.size());
}

std::optional<arm::JointAngles> startOf(const Step& step, const arm::Preset& arm) {
  if (step.pose_deg.empty()) return {};
  arm::JointAngles q{};
  for (std::size_t joint = 0; joint < std::min(arm::jointsOf(arm.geometry), step.pose_deg.size()); ++joint) {
    q[joint] = step.pose_deg[joint] * (arm::slides(arm.geometry, joint) ? kMetrePerMillimetre : kRadPerDegree);
  }
  return q;
}

bool asksFor(const Step& step, const std::vector<CheckState>& states, std::string_view quantity_key) {
  for (std::size_t index = 0; index < step.checks.size(); ++index) {
    const auto* const ask = std::get_if<AskNumber>(&step.checks[index].task);
    const bool is_open = index >= states.size() || !states[index].solved;
    if (is_open && ask != nullptr && ask->measure.quantity != nullptr && ask->measure.quantity->key == quantity_key)
      return true;
  }
  return false;
}

std::vector<TargetPlace> targetsOf(const Step& step, const arm::Preset& arm) {
  std::vector<TargetPlace> all;
  for (std::size_t index = 0; index < step.checks.size(); ++index) {
    const Task& task = step.checks[index].task;
    const auto add = [&](const Measure& measure, const std::vector<double>& near, double within, std::size_t number) {
      std::optional<TargetPlace> target = placeOf(measure, near, within, arm);
      if (!target) return;
      target->check = index;
      target->place = number;
      all.push_back(*target);
    };
    if (const auto* const hold = std::get_if<Hold>(&task))
      add(hold->wanted.measure, hold->wanted.near, hold->wanted.within, 0);
    if (const auto* const visit = std::get_if<Visit>(&task)) {
      for (std::size_t place = 0; place < visit->places.size(); ++place)
        add(visit->measure, visit->places[place], visit->within, place);
    }
  }
  return all;
}

bool isReached(const TargetPlace& target, const std::vector<CheckState>& states) {
  if (target.check >= states.size()) return false;
  const CheckState& state = states[target.check];
  return state.solved || (target.place < state.visited.size() && state.visited[target.place]);
}

}  // namespace underact::lesson
