#pragma once
#include <memory>
#include <span>
#include <string>
#include <string_view>

#include "core/arm/sample.h"
#include "core/base/real_time.h"
#include "core/base/types.h"

namespace underact::arm {

struct Mechanism;

/// How the joints of an arm move its tip: what its kinematics are computed from.
struct Geometry {
  // Of table 3.1 of the thesis, where it has that form; else 0. W's axes are fixed in B then: x_W = y_B, y_W = z_B,
  // z_W = x_B (thesis eq. 3.1).
  double upper_m = 0.0;  // L1, shoulder to elbow (a_2)
  double fore_m = 0.0;   // L2, elbow to wrist centre (d_4); the tip is the wrist centre
  Vec3 p_WB = Vec3::Zero();
  /// Chain and motors, which every preset has; lengths alone have none. It outlives every copy, so that a tick may copy
  /// and drop one without freeing anything as long as somebody else has another: programs and presets do.
  std::shared_ptr<const Mechanism> mechanism = nullptr;
  bool by_chain = false;  // it is solved by its chain, not by its lengths
  /// Whether it has the same lengths, or by its chain the same mechanism, from the same file or another.
  bool operator==(const Geometry& other) const noexcept UNDERACT_REAL_TIME;
};

/// Whether the joints for a pose of the tip are found within a tick, in closed form by the lengths. Then laws act on
/// joints, the tip of a simulated arm is moved itself, and solutions and singularities have names.
inline bool solvesInTick(const Geometry& geometry) noexcept UNDERACT_REAL_TIME {
  return !geometry.by_chain;
}

/// How many joints the arm has.
std::size_t jointsOf(const Geometry& geometry) noexcept UNDERACT_REAL_TIME;

/// rad, DH angles; m where a joint slides.
struct JointLimits {
  JointAngles min_rad{};
  JointAngles max_rad{};
  /// Those of joint 5 are of its absolute value: its sign is the sense in which the wrist is bent.
  bool of_wrist_size = true;
  bool operator==(const JointLimits&) const = default;
};

inline constexpr JointLimits kNoJointLimits{
    {-kInfinity, -kInfinity, -kInfinity, -kInfinity, 0.0, -kInfinity, -kInfinity, -kInfinity},
    {kInfinity, kInfinity, kInfinity, kInfinity, kInfinity, kInfinity, kInfinity, kInfinity}};

/// Steps per turn of the encoders: turret, thigh and shin (the shin's angle is measured from the base, not from the
/// thigh), then the three of the gimbal. Of other arms: of each joint; 0 beyond their joints.
using EncoderCounts = std::array<double, kMaxJoints>;

/// An arm that a scene can have.
struct Preset {
  std::string name;
  std::string title;
  std::string provenance;
  Geometry geometry;  // with its mechanism
  JointLimits limits;
  EncoderCounts counts_per_turn{};
  double continuous_force_N = 0.0;
  double apparent_mass_kg = 0.0;  // at the tip, of the masses in its file (apparentMass_kg()); 0: it has none
};

/// The models (model.h) that ship and that a scene can have: the haptic devices, then those that are simulated only.
std::span<const Preset> sceneArms();
/// Those that are haptic devices.
std::span<const Preset> presets();

/// Whether there are devices of its kind that this program drives: every driver finds the joints within a tick. Others
/// are simulated.
inline bool isDevice(const Preset& preset) {
  return solvesInTick(preset.geometry);
}

/// The one of sceneArms() of that name, or null.
const Preset* findPreset(std::string_view name);

inline constexpr std::string_view kDefaultArm = "omni-thesis";

}  // namespace underact::arm
