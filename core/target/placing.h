#pragma once
#include <cstdint>

#include "core/base/real_time.h"
#include "core/target/constraint.h"

namespace underact::target {

/// Where a goal is in the workspace, and how large: the numbers that change when it is moved, the same for all kinds
/// that can be carried along while the servo runs.
struct Placing {
  std::int64_t kind = 0;  // of the goal; 0: it cannot be carried
  Vec3 p_W = Vec3::Zero();
  Vec3 axis_W = Vec3::UnitZ();  // unit; of a line, a plane, a circle, a cylinder
  Mat3 R_W = Mat3::Identity();  // of a box or a mesh
  Vec3 size_m = Vec3::Zero();   // radius, half edges of a box, metres per unit of a mesh
};

/// Where the goal is. Kind 0: a curve, a virtual robot, or a shape in the metric of unequal gains.
Placing placingOf(const Goal& goal) noexcept UNDERACT_REAL_TIME;

/// Puts the goal there. placing: of a goal of the same kind; otherwise nothing happens.
void put(Goal& goal, const Placing& placing) noexcept UNDERACT_REAL_TIME;

/// The placing on the way from one to another of the same kind; share: 0 to 1, where it is exactly `to`. Positions and
/// sizes change at a constant rate, directions along the shorter arc.
Placing between(const Placing& from, const Placing& to, double share) noexcept UNDERACT_REAL_TIME;

/// Whether all numbers are equal, bit by bit except for the sign of zero.
bool isSame(const Placing& a, const Placing& b) noexcept UNDERACT_REAL_TIME;

/// For bytes from a file: whether a goal of the kind of `end` can be put there.
bool isValid(const Placing& placing, const Placing& end);

}  // namespace underact::target
