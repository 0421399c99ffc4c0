#include "app/gui/model/kinematics_now.h"

#include "core/arm/sample.h"

namespace underact::gui {

KinematicsNow kinematicsNow(const arm::Geometry& geometry, const arm::JointLimits& limits,
                            const arm::JointAngles& q_rad) {
  KinematicsNow now;
  now.q_rad = q_rad;
  now.device_rad = arm::deviceFromDh(q_rad);
  const arm::Kinematics kinematics = arm::kinematics(geometry, q_rad);
  now.X_WT = kinematics.X_WT;
  now.J = kinematics.J;
  now.J_p = arm::positionJacobian(geometry, q_rad);
  now.dexterity = arm::dexterity(geometry, q_rad);
  now.distances = arm::singularityDistances(geometry, q_rad);
  now.solutions = arm::solveAll(geometry, limits, now.X_WT);
  return now;
}

KinematicsNow kinematicsNow(const arm::Preset& preset, const arm::Model& model, const chain::Inverse& inverse,
                            const arm::JointAngles& q) {
  KinematicsNow now;
  now.q_rad = q;
  const chain::Kinematics kinematics = chain::kinematics(model.chain, q);
  now.X_WT = kinematics.X_WT;
  now.J = kinematics.J;
  now.J_p = arm::positionJacobian(preset.geometry, q);
  now.dexterity = arm::dexterityOf(preset.geometry, q);
  now.distances = arm::singularityDistances(preset.geometry, q);
  const chain::InverseSolutions found = chain::solveAll(inverse, now.X_WT);
  for (std::size_t index = 0; index < found.count; ++index) {
    const std::span<const double> values = std::span(found.all[index].q).first(model.rows.size());
    now.of_chain.push_back({{values.begin(), values.end()}, arm::isWithinLimits(model, values)});
  }
  return now;
}

int numberOf(const arm::Branch& branch) {
  return 1 + (branch.shoulder < 0 ? 4 : 0) + (branch.elbow < 0 ? 2 : 0) + (branch.wrist < 0 ? 1 : 0);
}

arm::Branch branchOf(int number) {
  const auto sign = [bits = number - 1](int bit) { return static_cast<std::int8_t>((bits & bit) != 0 ? -1 : 1); };
  return {sign(4), sign(2), sign(1)};
}

}  // namespace underact::gui
