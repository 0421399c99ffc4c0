#pragma once
#include "core/arm/preset.h"
#include "core/base/real_time.h"
#include "core/base/trig.h"
#include "core/base/types.h"

namespace underact::arm {

// Inside the room: the parts of pose and Jacobian, from one set of sines.

/// The arm in its own plane, and how joints 2 and 3 move the tip there. Source: Beckman 2007, eq. 3.5 (erratum 3.5).
struct Plane {
  SinCos turret, thigh, shin;          // of q1, q2, q2 + q3
  double out_m = 0.0, up_m = 0.0;      // the tip from axis 1, and above the shoulder
  double out_3_m = 0.0, up_3_m = 0.0;  // by joint 3, per rad; by joint 2: -up_m, out_m
};
/// From q1, q2 and q3, rad; q4 to q6 are not read. Not finite in, not finite out. Cost: two sinCosOfTwo().
Plane planeOf(const Geometry& geometry, const JointAngles& q_rad) noexcept UNDERACT_REAL_TIME;

/// The axes of the joints, and the orientation of the stylus, in W. Source: eq. 3.6 (erratum 3.6).
struct Axes {
  Vec3 side_W;   // axes 2 and 3
  Vec3 along_W;  // axis 4: the forearm
  Vec3 five_W;
  Mat3 R_WT;  // its third column is axis 6; axis 1 is the upright, y
};
/// plane: planeOf() of the same q_rad. Not finite in, not finite out. Cost: two sinCosOfTwo().
Axes axesOf(const Plane& plane, const JointAngles& q_rad) noexcept UNDERACT_REAL_TIME;

}  // namespace underact::arm
