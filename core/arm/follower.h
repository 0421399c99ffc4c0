#pragma once
#include "core/arm/branches.h"

namespace underact::arm {

/// The state of a follower: its last joint angles, which continue over full turns (beyond pi where a joint has rotated
/// that far), and their branch.
struct FollowerState {
  JointAngles q_rad{};
  Branch branch;
  bool begun = false;
};

/// For bytes from a file: whether the state can be used.
bool isValid(const FollowerState& state) noexcept;

/// What a step of follow() or followPosition() gives.
struct Followed {
  FollowerState next;
  bool reachable = false;  // false: next is the last state
  bool changed = false;    // it had to change to another branch
};

/// The branch changes only where another one continues the motion by this much less, summed over the joints that
/// differ: where a motion passes straight through a singularity, the present branch jumps by pi and the other one
/// continues.
inline constexpr double kSwitch_rad = 1.0;

/// The joint angles for X_WT on the branch of the state, with the turns nearest to the last angles. Begins on the
/// branch nearest to q_rad of the state. At a wrist singularity joint 4 stays and joint 6 takes the rest, and on axis 1
/// joint 1 stays. Not for the tick of a scene (which follows three joints: followPosition()). Gives no NaN.
Followed follow(const Geometry& geometry, const JointLimits& limits, const FollowerState& state,
                const Pose& X_WT) noexcept UNDERACT_REAL_TIME;

/// Follows by joints 1 to 3 to a position, with the branches of shoulder and elbow. Joints 4 to 6 stay. Out of
/// reach: as near as the arm gets, reachable false.
Followed followPosition(const Geometry& geometry, const FollowerState& state,
                        const Vec3& p_WT) noexcept UNDERACT_REAL_TIME;

}  // namespace underact::arm
