#include "core/tick/program.h"

#include <utility>

namespace underact::tick {

TickProgram makeProgram(const arm::Geometry& geometry, std::vector<Entry> entries, Combine combine,
                        const safety::Limits& limits, const arm::JointLimits& joint_limits) {
  TickProgram program{Needs{}, geometry, joint_limits, std::move(entries), combine, limits};
  for (const Entry& entry : program.entries) {
    program.needs.rate |= control::needsRate(entry.law);
    program.needs.integral |= control::needsIntegral(entry.law);
    const target::Constraint& constraint = entry.constraint;
    const auto* nearest = std::get_if<target::NearestOnShape>(&constraint.goal);
    program.needs.metric |= nearest != nullptr && nearest->weighted;
    program.needs.orientation |= target::needsOrientation(constraint.goal);
    program.needs.robots |= std::holds_alternative<manipulator::Manipulator>(constraint.goal);
    program.needs.meshes |= std::holds_alternative<target::MeshPlace>(constraint.goal);
    program.needs.curves |= std::holds_alternative<target::CurvePath>(constraint.goal);
    program.needs.friction |= constraint.friction.isThere();
    program.needs.energy |= entry.passivity != control::Passivity::Off;
    program.needs.joints |= entry.space == Space::Joint;
  }
  program.watched = arm::watchedJoints(geometry);
  program.needs.motors = limits.edge_rad > 0.0 || limits.thermal.continuous_N_m != safety::PerDriven{} ||
                         limits.max_torque_N_m != safety::kNoTorqueLimits;
  program.needs.moment = program.needs.robots && program.watched.turn;
  program.needs.more_joints = arm::jointsOf(geometry) > 6;
  program.needs.more_motors = program.watched.count > 3;
  program.needs.choice = combine == Combine::Nearest && program.entries.size() > 1;
  return program;
}

}  // namespace underact::tick
