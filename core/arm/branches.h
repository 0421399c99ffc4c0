#pragma once
#include <array>
#include <cstddef>
#include <cstdint>

#include "core/arm/preset.h"
#include "core/base/real_time.h"
#include "core/base/types.h"

namespace underact::arm {

/// Which of the eight solutions for a pose. shoulder +1: the turret faces the wrist centre; elbow +1: cos q3 >= 0, as
/// of a real Omni; wrist +1: sin q5 >= 0.
struct Branch {
  std::int8_t shoulder = 1;
  std::int8_t elbow = 1;
  std::int8_t wrist = 1;
  friend bool operator==(const Branch&, const Branch&) = default;
};

/// The self-motion at a singular pose: the solution is one of many.
enum class Family : std::uint8_t {
  None,      // the solution is isolated
  Q1Free,    // the wrist centre lies on axis 1
  Q4PlusQ6,  // q5 = 0: only the sum is defined
  Q6MinusQ4  // q5 = pi: only the difference is defined
};

/// null for None; else "q1 free", "q4+q6", "q6-q4".
const char* name(Family family);

/// One set of joint angles that reaches the pose, the branch it is on, and whether every joint keeps its limits.
struct Solution {
  JointAngles q_rad{};  // in (-pi, pi]
  Branch branch;
  Family family = Family::None;
  bool within_limits = false;
};

// A pose counts as singular below these; the answer then holds for all poses that a hand cannot distinguish from it.
inline constexpr double kSingularSine = 1e-6;        // |sin q5|, |cos q3|
inline constexpr double kSingularDistance_m = 1e-6;  // wrist centre from axis 1
// A wrist centre out of reach by no more than this share of the reach counts as on the boundary.
inline constexpr double kOnBoundary = 1e-9;

/// All solutions: 8 of a regular pose; 4 on the boundary of the reach, where elbow up and down coincide; one for each
/// self-motion. In the order shoulder, elbow, wrist, + before -.
struct Solutions {
  std::array<Solution, 8> all{};
  std::size_t count = 0;
  bool reachable = false;
  bool at_shoulder = false;  // singular there: the wrist centre on axis 1
  bool at_elbow = false;     // stretched or folded
  bool at_wrist = false;     // axes 4 and 6 in line, for one solution at least
  /// At any of the three singularities.
  bool singular() const noexcept UNDERACT_REAL_TIME { return at_shoulder || at_elbow || at_wrist; }
  /// The solutions that there are, for a loop over them.
  const Solution* begin() const noexcept UNDERACT_REAL_TIME { return all.data(); }
  /// Behind the last of them.
  const Solution* end() const noexcept UNDERACT_REAL_TIME { return all.data() + count; }
};

/// The forward kinematics of each is X_WT within 32 ulp of the reach and the coordinates (see solvePosition()) and of 1
/// rad, and near a singularity 2e-12 m and rad more; on the boundary as near as the arm gets. The thresholds are for
/// arms of 1 cm to 100 m. X_WT: finite, a rotation. Gives no NaN for any finite input. Cost: 16 arc tangents, no other
/// trigonometry. Source: Beckman 2007, eq. 3.11-3.20 and figure 3.4 as errata section 2 corrects them (twists,
/// 3.11-3.16, 3.18-3.20).
Solutions solveAll(const Geometry& geometry, const JointLimits& limits, const Pose& X_WT) noexcept UNDERACT_REAL_TIME;

/// Whether each joint lies inside its limits; of joint 5, its size.
bool isWithin(const JointLimits& limits, const JointAngles& q_rad) noexcept UNDERACT_REAL_TIME;

}  // namespace underact::arm
