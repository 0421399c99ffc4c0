#pragma once
#include <span>
#include <string>
#include <string_view>

#include "core/arm/sample.h"
#include "core/base/types.h"

namespace underact::arm {

/// The lengths of the chain, and the position of frame 0 of the DH table in W. W's axes are fixed in B for every
/// preset: x_W = y_B, y_W = z_B, z_W = x_B (thesis eq. 3.1).
struct Geometry {
  double upper_m = 0.0;  // L1, shoulder to elbow (a_2)
  double fore_m = 0.0;   // L2, elbow to wrist centre (d_4); the tip is the wrist centre
  Vec3 p_WB = Vec3::Zero();
  bool operator==(const Geometry&) const = default;
};

/// rad, DH angles. Those of joint 5 are of its absolute value: its sign is the sense in which the wrist is bent.
struct JointLimits {
  JointAngles min_rad{};
  JointAngles max_rad{};
  bool operator==(const JointLimits&) const = default;
};

inline constexpr JointLimits kNoJointLimits{{-kInfinity, -kInfinity, -kInfinity, -kInfinity, 0.0, -kInfinity},
                                            {kInfinity, kInfinity, kInfinity, kInfinity, kInfinity, kInfinity}};

/// Steps per turn of the encoders: turret, thigh and shin (the shin's angle is measured from the base, not from the
/// thigh), then the three of the gimbal.
using EncoderCounts = std::array<double, 6>;

/// An arm that a scene can name: a haptic device of the thesis's kind.
struct Preset {
  std::string name;
  std::string title;
  std::string provenance;
  Geometry geometry;
  JointLimits limits;
  EncoderCounts counts_per_turn{};
  double continuous_force_N = 0.0;
  double apparent_mass_kg = 0.0;  // at the tip, of the masses in its file (apparentMass_kg()); 0: it has none
};

/// The models (model.h) that are devices.
std::span<const Preset> presets();

/// The preset of that name, or null.
const Preset* findPreset(std::string_view name);

inline constexpr std::string_view kDefaultArm = "omni-thesis";

}  // namespace underact::arm
