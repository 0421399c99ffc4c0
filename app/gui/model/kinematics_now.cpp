#include "app/gui/model/kinematics_now.h"

#include "core/arm/sample.h"
#include "core/chain/kinematics.h"

namespace underact::gui {

KinematicsNow kinematicsNow(const arm::Preset& preset, const arm::Model& model, const SolutionFinder& finder,
                            const arm::JointAngles& q) {
  KinematicsNow now;
  now.q_rad = q;
  if (arm::isOmniForm(preset)) {
    now.device_rad = arm::deviceFromDh(q);
    const arm::Kinematics kinematics = arm::kinematics(preset.geometry, q);
    now.X_WT = kinematics.X_WT;
    now.J = kinematics.J;
    now.dexterity = arm::dexterity(preset.geometry, q);
  } else {
    const chain::Kinematics kinematics = chain::kinematics(model.chain, q);
    now.X_WT = kinematics.X_WT;
    now.J = kinematics.J;
    now.dexterity = arm::dexterityOf(preset.geometry, q);
  }
  now.J_p = arm::positionJacobian(preset.geometry, q);
  now.distances = arm::singularityDistances(preset.geometry, q);
  now.solutions = finder.at(now.X_WT);
  return now;
}

}  // namespace underact::gui
