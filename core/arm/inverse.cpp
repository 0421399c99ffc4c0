#include "core/arm/inverse.h"

#include <algorithm>
#include <cmath>

#include "core/arm/forward.h"
#include "core/base/trig.h"

namespace underact::arm {
namespace {

/// sqrt(x^2 + y^2) without overflow; not std::hypot, whose last bit is each library's own, and replays want the same.
double lengthOf(double x, double y) noexcept UNDERACT_REAL_TIME {
  const double larger = std::max(std::abs(x), std::abs(y));
  if (!(larger > 0.0)) return 0.0;
  const double u = x / larger, v = y / larger;
  return larger * std::sqrt(u * u + v * v);
}

}  // namespace

Reach reach(const Geometry& geometry, const Vec3& p_WT) noexcept {
  const Vec3 p_BT_W = p_WT - geometry.p_WB;
  const double x = p_BT_W.z(), y = p_BT_W.x(), z = p_BT_W.y();  // in B, eq. 3.1
  const double upper = geometry.upper_m, fore = geometry.fore_m;
  const double elbow_sin =
      (x * x + y * y + z * z - upper * upper - fore * fore) / (2.0 * upper * fore);  // erratum 3.13
  const double s3 = std::clamp(elbow_sin, -1.0, 1.0);
  const double c3 = std::sqrt((1.0 - s3) * (1.0 + s3));
  const double reach_m = lengthOf(x, y);
  const double b = upper + fore * s3, c = fore * c3;  // erratum 3.14
  Reach result;
  result.q_rad[0] = reach_m > 0.0 ? atan2Of(y, x) : 0.0;                // erratum 3.11
  result.q_rad[1] = atan2Of(c * reach_m + b * z, b * reach_m - c * z);  // eq. 3.16
  result.q_rad[2] = atan2Of(s3, c3);                                    // erratum 3.12
  result.reachable = std::abs(elbow_sin) <= 1.0 && reach_m > 0.0;
  return result;
}

JointAngles withWrist(JointAngles q_rad, const Mat3& R_WT) noexcept {
  const Mat3 R_BT = workspaceFromBase().transpose() * R_WT;
  const Mat3 b = baseFromForearm(q_rad).transpose() * R_BT;
  const double bend_sin = std::sqrt(b(0, 2) * b(0, 2) + b(1, 2) * b(1, 2));
  q_rad[4] = atan2Of(bend_sin, b(2, 2));  // erratum 3.18
  if (bend_sin > 1e-9) {
    q_rad[3] = atan2Of(b(1, 2), b(0, 2));   // erratum 3.19
    q_rad[5] = atan2Of(b(2, 1), -b(2, 0));  // erratum 3.20
  } else {                                  // only q4 + q6 (or q6 - q4) is defined: all of it goes to joint 6
    q_rad[3] = 0.0;
    q_rad[5] = atan2Of(b(1, 0), b(1, 1));
  }
  return q_rad;
}

JointAngles withinLimits(const JointLimits& limits, JointAngles q_rad) noexcept {
  for (std::size_t joint = 0; joint < q_rad.size(); ++joint) {
    const double size_rad = joint == 4 ? std::abs(q_rad[joint]) : q_rad[joint];
    const double held_rad = std::clamp(size_rad, limits.min_rad[joint], limits.max_rad[joint]);
    q_rad[joint] = joint == 4 ? std::copysign(held_rad, q_rad[joint]) : held_rad;
  }
  return q_rad;
}

}  // namespace underact::arm
