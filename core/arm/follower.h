#pragma once
#include "core/arm/branches.h"

namespace underact::arm {

/// All memory of a follower: the joints it gave last, as turns go on (beyond pi where a joint has turned that far), and
/// the branch they are on.
struct FollowerState {
  JointAngles q_rad{};
  Branch branch;
  bool begun = false;
};

/// Of bytes from a file.
bool isSound(const FollowerState& state) noexcept;

/// What a step of follow() or followPosition() gives.
struct Followed {
  FollowerState next;
  bool reachable = false;  // false: next is the last state
  bool changed = false;    // it had to go over to another branch
};

/// Following a motion a switch is made only where another branch goes on by this much less, summed over the joints that
/// differ: where a motion passes straight through a singularity the own branch jumps by pi, and the other goes on.
inline constexpr double kSwitch_rad = 1.0;

/// The joints for X_WT on the branch of the state, in the turn that is nearest to the last joints. Begins on the branch
/// nearest to q_rad of the state. In a wrist singularity joint 4 stays where it was, joint 6 takes the rest, and on
/// axis 1 joint 1 stays. Not for the tick of a scene (that follows three joints: followPosition). Gives no NaN.
Followed follow(const Geometry& geometry, const JointLimits& limits, const FollowerState& state,
                const Pose& X_WT) noexcept UNDERACT_REAL_TIME;

/// The same for joints 1 to 3 and a place: the branch is that of shoulder and elbow. Joints 4 to 6 stay.
/// Out of reach: as near as the arm gets, reachable false.
Followed followPosition(const Geometry& geometry, const FollowerState& state,
                        const Vec3& p_WT) noexcept UNDERACT_REAL_TIME;

}  // namespace underact::arm
