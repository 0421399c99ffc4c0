#pragma once
#include <array>
#include <cstdint>

namespace underact::arm {

/// The six joint angles, rad, in the DH convention (thesis table 3.1), whatever the device's own convention is.
using JointAngles = std::array<double, 6>;

/// What an arm says of itself at one moment.
struct Sample {
  std::int64_t time_ns = 0;  // since the device was opened, on the device's clock
  JointAngles q_rad{};
  std::uint32_t buttons = 0;  // bit 0: the stylus button nearer to the tip
  std::uint32_t epoch = 0;    // counts up where the arm begins anew (a replay jumps): what was before says nothing
};

}  // namespace underact::arm
