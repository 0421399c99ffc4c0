#include "app/gui/model/kinematics_now.h"

#include <cmath>

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

double ellipsoidTorque_N_m(const arm::Preset& preset, const arm::Model& model) {
  if (arm::isDevice(preset)) return kOmniTorque_N_m;
  const arm::Preset& omni = *arm::findPreset(arm::kDefaultArm);
  const double size = chain::reachOf(model.chain) / chain::reachOf(arm::findModel(arm::kDefaultArm)->chain);
  const double wanted_N_m = kOmniTorque_N_m * preset.continuous_force_N / omni.continuous_force_N * size;
  if (!(wanted_N_m > 0.0)) return kOmniTorque_N_m;  // an arm that exerts no force
  const double power_N_m = std::pow(10.0, std::floor(std::log10(wanted_N_m)));
  for (const double digit : {5.0, 2.0}) {
    if (digit * power_N_m <= wanted_N_m) return digit * power_N_m;
  }
  return power_N_m;
}

}  // namespace underact::gui
