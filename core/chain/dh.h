#pragma once
#include <cstdint>
#include <span>

#include "core/base/real_time.h"
#include "core/base/types.h"

namespace underact::chain {

/// Revolute: the joint rotates about its axis (rad). Prismatic: it slides along it (m).
enum class JointType : std::uint8_t { Revolute, Prismatic };

/// One row of a modified Denavit-Hartenberg table (Craig): from frame i-1 to frame i by Rx(alpha) Dx(a) Rz(theta)
/// Dz(d). The joint's value q adds to theta (revolute, rad) or to d (prismatic, m); min and max, in q's unit, are its
/// limits, infinite where there is none.
struct DhRow {
  JointType type = JointType::Revolute;
  double alpha_rad = 0.0;
  double a_m = 0.0;
  double theta_rad = 0.0;
  double d_m = 0.0;
  double min = -kInfinity;
  double max = kInfinity;
};

/// Frame i in frame i-1 with the joint at q (rad or m). Not finite in, not finite out.
/// Source: Craig, Introduction to Robotics, 3rd ed., eq. 3.6.
Pose rowPose(const DhRow& row, double q) noexcept UNDERACT_REAL_TIME;

/// The link frames 1..n in W. X_WB: frame 0 in W. As many frames as the shortest of the three spans has; frames beyond
/// them are not changed.
void framesOf(std::span<const DhRow> rows, const Pose& X_WB, std::span<const double> q,
              std::span<Pose> X_WFrames) noexcept UNDERACT_REAL_TIME;

}  // namespace underact::chain
