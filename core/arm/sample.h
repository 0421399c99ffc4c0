#pragma once
#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

#include "core/base/real_time.h"

namespace underact::arm {

/// The most joints that an arm has.
inline constexpr std::size_t kMaxJoints = 8;

/// The joint values of an arm, 0 beyond its joints: of the Omni and its like six angles, rad, in the DH convention
/// (thesis table 3.1), whatever the device's own convention is; of others rad, or m where a joint slides.
using JointAngles = std::array<double, kMaxJoints>;

/// The state of an arm at one moment.
struct Sample {
  std::int64_t time_ns = 0;  // since the device was opened, on the device's clock
  JointAngles q_rad{};
  std::uint32_t buttons = 0;  // bit 0: the stylus button nearer to the tip
  std::uint32_t epoch = 0;    // goes up where the arm begins anew (a replay jumps): the past is void
};

/// DH angles from the device's own angles (turret, thigh, shin; gimbal 1 to 3), rad. The shin is measured from the
/// base. Source: Beckman 2007, figure 3.5: q1 = -q1p, q2 = q2p, q3 = q3p - q2p; the gimbal: q4 = -g1, q5 = g2 + pi/2,
/// q6 = -g3 - pi/2, which reproduces a public recording. The signs on hardware are not verified.
JointAngles dhFromDevice(const JointAngles& device_rad) noexcept UNDERACT_REAL_TIME;
/// The inverse of dhFromDevice(). Joints beyond the sixth are 0 in both.
JointAngles deviceFromDh(const JointAngles& q_rad) noexcept UNDERACT_REAL_TIME;

/// The joint angles between two configurations, share 0 to 1 (clamped). Each joint moves linearly through the angles in
/// between, never the other way round past half a turn, which joint limits would not allow. Not finite in, not finite
/// out. Cost: constant.
JointAngles interpolated(const JointAngles& from_rad, const JointAngles& to_rad,
                         double share) noexcept UNDERACT_REAL_TIME;

}  // namespace underact::arm
