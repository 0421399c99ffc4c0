#include "app/gui/model/kinematics_now.h"

#include "core/arm/sample.h"

namespace underact::gui {

KinematicsNow kinematicsNow(const arm::Preset& preset, const SolutionFinder& finder, const arm::JointAngles& q) {
  KinematicsNow now;
  now.q_rad = q;
  now.device_rad = arm::deviceFromDh(q);
  const arm::Kinematics kinematics = arm::kinematics(preset.geometry, q);
  now.X_WT = kinematics.X_WT;
  now.J = kinematics.J;
  now.dexterity = arm::dexterityOf(preset.geometry, q);
  now.J_p = now.dexterity.J;
  now.distances = arm::singularityDistances(preset.geometry, q);
  now.solutions = finder.at(now.X_WT);
  return now;
}

}  // namespace underact::gui
