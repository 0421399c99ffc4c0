#include "core/manipulator/manipulator.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

#include "core/base/axis_geometry.h"
#include "core/base/translate.h"

namespace underact::manipulator {
namespace {

using chain::JointType;

constexpr double kAlongAxis = 1e-6;  // the least angle of z of V to the axis, where the angle about it counts

bool isStiffness(double k) {
  return std::isfinite(k) && k >= 0.0;
}

std::size_t turningJoints(const chain::Chain& chain) {
  return static_cast<std::size_t>(
      std::count_if(chain.joints.begin(), chain.joints.end(),
                    [](const chain::Joint& joint) { return joint.type == JointType::Revolute; }));
}

void judgeNumbers(const Wanted& wanted, const SourceLocation& place, Problems& problems) {
  if (wanted.chain.joints.size() > kMaxJoints) {
    problems.push_back({phrase(TRANSLATE_NOOP("problem", "A virtual robot has at most %1 joints, not %2."),
                               {std::to_string(kMaxJoints), std::to_string(wanted.chain.joints.size())}),
                        place});
  }
  bool stiff = isStiffness(wanted.ko_N_m_per_rad);
  for (const double k : wanted.kp_N_per_m) stiff = stiff && isStiffness(k);
  for (const double k : wanted.spring) stiff = stiff && isStiffness(k);
  if (!stiff) problems.push_back({phrase(TRANSLATE_NOOP("problem", "A stiffness must be 0 or above.")), place});
  for (const double rest : wanted.rest) {
    if (!std::isfinite(rest))
      problems.push_back(
          {phrase(TRANSLATE_NOOP("problem", "The rest position of a joint's spring is not a finite number.")), place});
  }
  if (wanted.max_steps < 1 || wanted.max_steps > 100) {
    problems.push_back({phrase(TRANSLATE_NOOP("problem", "The solver takes 1 to 100 steps.")), place});
  }
  if (!(wanted.tolerance > 0.0 && wanted.tolerance <= 1e-2)) {
    problems.push_back(
        {phrase(TRANSLATE_NOOP("problem", "The solver's tolerance must be above 0 and at most 0.01.")), place});
  }
}

/// Checks what Orientation::Angle requires of the chain.
void judgeAngle(const Wanted& wanted, const SourceLocation& place, Problems& problems) {
  const bool by_thesis = wanted.law == ForceLaw::Thesis52;
  if (wanted.orientation != Orientation::Angle && !by_thesis) return;
  const std::vector<chain::Joint>& joints = wanted.chain.joints;
  if (turningJoints(wanted.chain) != 1 || (by_thesis && joints.size() != 1)) {
    problems.push_back(
        {phrase(by_thesis ? TRANSLATE_NOOP("problem",
                                           "The thesis's force law needs a chain with just one joint, a revolute one.")
                          : TRANSLATE_NOOP("problem",
                                           "The orientation \"angle\" needs a chain with just one revolute joint.")),
         place});
    return;
  }
  const auto turning = std::find_if(joints.begin(), joints.end(),
                                    [](const chain::Joint& joint) { return joint.type == JointType::Revolute; });
  if (turning->axis_W.cross(wanted.chain.X_WT_home.linear().col(2)).norm() < kAlongAxis) {
    problems.push_back(
        {phrase(TRANSLATE_NOOP(
             "problem",
             "In the home pose the tip's z axis lies along the joint's axis, so it has no angle about that axis.")),
         place});
  }
}

}  // namespace

Result<Manipulator> makeManipulator(Wanted wanted, const SourceLocation& place) {
  Problems problems;
  judgeNumbers(wanted, place, problems);
  judgeAngle(wanted, place, problems);
  if (!problems.empty()) return problems;
  Manipulator made;
  made.chain = std::move(wanted.chain);
  made.orientation = wanted.orientation;
  made.kp_N_per_m = wanted.kp_N_per_m;
  made.ko_N_m_per_rad = wanted.ko_N_m_per_rad;
  // Without any gain the tip still needs a target: the nearest position, as with other constraints.
  if (made.kp_N_per_m.isZero() && (made.orientation == Orientation::None || made.ko_N_m_per_rad == 0.0)) {
    made.kp_N_per_m.setOnes();
  }
  made.spring = wanted.spring;
  made.rest = wanted.rest;
  made.law = wanted.law;
  made.options = {Method::Iterative, wanted.max_steps, wanted.tolerance, true};
  const double reach_m = chain::reachOf(made.chain);
  made.reach_m = reach_m > 0.0 ? reach_m : 1.0;
  made.bends = std::any_of(made.spring.begin(), made.spring.end(), [](double k) { return k > 0.0; });
  if (made.orientation == Orientation::Angle || made.law == ForceLaw::Thesis52) {
    while (made.chain.joints[made.turning].type != JointType::Revolute) ++made.turning;
    made.home_rad = angleAround(made.chain.joints[made.turning].axis_W, made.chain.X_WT_home.linear().col(2));
  }
  const std::optional<ClosedForm> closed = closedFormOf(made);
  if (wanted.method == Method::ClosedForm && !closed) {
    return Problems{{phrase(TRANSLATE_NOOP("problem",
                                           "There is no closed form for this chain with these gains and this "
                                           "orientation; use the method \"auto\" or \"iterative\".")),
                     place}};
  }
  if (closed && wanted.method != Method::Iterative && made.law == ForceLaw::Energy) {
    made.closed = closed;
    made.options.method = Method::ClosedForm;
  }
  return made;
}

}  // namespace underact::manipulator
