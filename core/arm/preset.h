#pragma once
#include <memory>
#include <span>
#include <string>
#include <string_view>

#include "core/arm/sample.h"
#include "core/base/real_time.h"
#include "core/base/types.h"

namespace underact::arm {

struct GeneralArm;
/// Whether both are the same arm, to the bit.
bool operator==(const GeneralArm& a, const GeneralArm& b) noexcept UNDERACT_REAL_TIME;

/// The lengths of the chain, and the position of frame 0 of the DH table in W. W's axes are fixed in B for every arm of
/// this form: x_W = y_B, y_W = z_B, z_W = x_B (thesis eq. 3.1).
struct Geometry {
  double upper_m = 0.0;  // L1, shoulder to elbow (a_2)
  double fore_m = 0.0;   // L2, elbow to wrist centre (d_4); the tip is the wrist centre
  Vec3 p_WB = Vec3::Zero();
  /// An arm of another form; then the lengths are 0. It outlives every copy, so that a tick may copy and drop one
  /// without freeing anything as long as somebody else has another: programs and presets do.
  std::shared_ptr<const GeneralArm> general = nullptr;
  /// Whether it has the same lengths, or is the same other arm, from the same file or another.
  bool operator==(const Geometry& other) const noexcept UNDERACT_REAL_TIME {
    const bool are_same =
        general == other.general || (general != nullptr && other.general != nullptr && *general == *other.general);
    return are_same && upper_m == other.upper_m && fore_m == other.fore_m && p_WB == other.p_WB;
  }
};

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

/// An arm that a scene can have: a haptic device of the thesis's kind, or (geometry.general) one that is simulated.
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

/// The models (model.h) that ship and that a scene can have: the haptic devices, then those that are simulated only.
std::span<const Preset> sceneArms();
/// Those that are haptic devices.
std::span<const Preset> presets();

/// Whether the arm has the form of the Omni's table, as every device that is driven here; others are simulated.
inline bool isOmniForm(const Preset& preset) {
  return preset.geometry.general == nullptr;
}

/// The one of sceneArms() of that name, or null.
const Preset* findPreset(std::string_view name);

inline constexpr std::string_view kDefaultArm = "omni-thesis";

}  // namespace underact::arm
