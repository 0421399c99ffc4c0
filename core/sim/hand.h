#pragma once
#include <optional>

#include "core/arm/sample.h"
#include "core/base/types.h"

namespace underact::sim {

/// A hand at the stylus: mass, damper, and spring to where the hand wants the tip. The demo's values are assumed.
struct HandModel {
  double mass_kg = 0.1;
  double damping_N_s_per_m = 4.0;
  double stiffness_N_per_m = 300.0;
};

/// Where the hand wants the stylus at one moment.
struct HandSetpoint {
  Vec3 p_WT = Vec3::Zero();  // m
  Vec3 v_WT = Vec3::Zero();  // m/s
  Mat3 R_WT = Mat3::Identity();
  bool turns = false;  // R_WT counts; false: the wrist stays as it is
  bool holds = true;   // false: loose fingers, which move with the stylus; the spring is slack and p_WT does not count
  /// Of an arm that moves in its joints: they are led to these values, and the position does not count.
  std::optional<arm::JointAngles> posture = {};
};

}  // namespace underact::sim
