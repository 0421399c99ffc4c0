#pragma once
#include "core/arm/preset.h"
#include "core/base/real_time.h"
#include "core/base/trig.h"
#include "core/base/types.h"

namespace underact::arm {

/// The first part of every inverse kinematics: the wrist centre in B, and the angle of the elbow.
struct PlanarReach {
  double x_m = 0.0, y_m = 0.0, z_m = 0.0;  // of the wrist centre in B
  double off_axis_m = 0.0;                 // from axis 1
  double elbow_sin = 0.0;                  // from the lengths; beyond 1 in size: out of reach
  SinCos elbow;                            // of q3 with cos >= 0, clamped to the boundary
  bool reachable = false;                  // boundary included, see kOnBoundary
};
/// p_WT: m, finite. Source: Beckman 2007, eq. 3.1 and 3.13 (erratum 3.13). Any thread; no side effects.
PlanarReach planarReach(const Geometry& geometry, const Vec3& p_WT) noexcept UNDERACT_REAL_TIME;

/// For a turret that faces the wrist centre: sine and cosine of q2, times the distance from the shoulder.
/// elbow: the sign of cos q3.
SinCos scaledThigh(const Geometry& geometry, const PlanarReach& reach, double elbow) noexcept UNDERACT_REAL_TIME;

/// The directions with length 1, and those of q2 + q3. Where the wrist centre is the shoulder itself, q2 = 0.
struct Thigh {
  SinCos thigh, shin;
};
/// Arguments as of scaledThigh(). Source: eq. 3.14 and 3.16 (erratum 3.14).
Thigh thighOf(const Geometry& geometry, const PlanarReach& reach, double elbow) noexcept UNDERACT_REAL_TIME;

}  // namespace underact::arm
