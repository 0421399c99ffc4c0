#pragma once
#include <array>
#include <cstddef>

#include "core/base/real_time.h"
#include "core/base/types.h"
#include "core/safety/limits.h"

namespace underact::safety {

/// The driven joints of an arm that is not of the Omni's form, in this tick: all of them, where the Omni's gate knows
/// its three. Elements beyond count are not read.
struct Driven {
  std::size_t count = 0;
  std::array<Vec3, kMostDriven> J_v, J_w;  // the tip's motion for the rate of each: m/rad and rad/rad, or 1 and 0
  std::array<double, kMostDriven> room_below_rad, room_above_rad;  // to their stops; of a slide as far as it counts
  Mat3 renders;         // what the motors render of a force: arm::renderable()
  bool turns = false;   // they render a moment, too
  Mat6 renders_wrench;  // then: what they render of both, arm::renderableWrench()
};

/// A force on the tip and a moment about it, N and N m, in W.
struct Wrench {
  Vec3 f_T_W = Vec3::Zero();
  Vec3 m_T_W = Vec3::Zero();
};

/// The heat of the driven joints, in their order, as Thermal states it for three.
using Heat = std::array<double, kMostDriven>;

// The limits of stages.h for any number of driven joints. Each scales force and moment together, or leaves both.

/// The part of both that the motors render; both as they are where that is all but a rounding of them.
Wrench limitMotors(const Driven& driven, const Wrench& wrench) noexcept UNDERACT_REAL_TIME;
/// The share of both that remains where they would press a driven joint against its stop.
double edgeShare(const Limits& limits, const Driven& driven, const Wrench& wrench) noexcept UNDERACT_REAL_TIME;
/// The share of both with which no motor gets hotter than 1, and none exceeds the largest torque that it has.
double torqueShare(const Limits& limits, const Heat& heat, const Driven& driven,
                   const Wrench& wrench) noexcept UNDERACT_REAL_TIME;
/// The motors' heat a tick later.
Heat heated(const Limits& limits, const Heat& heat, const Driven& driven, const Wrench& wrench,
            double dt_s) noexcept UNDERACT_REAL_TIME;

}  // namespace underact::safety
