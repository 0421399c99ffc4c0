#include "core/arm/wrist.h"

#include <cmath>

namespace underact::arm {

// Below this the sine of q5 has no direction left, and joint 4 is 0 with an error of as many rad.
constexpr double kNoBend = 1e-12;

Mat3 forearmRotation(const SinCos& turret, const SinCos& shin) noexcept {
  Mat3 R_B3;
  R_B3 << turret.cos * shin.cos, turret.sin, turret.cos * shin.sin,  //
      turret.sin * shin.cos, -turret.cos, turret.sin * shin.sin,     //
      shin.sin, 0.0, -shin.cos;
  return R_B3;
}

Wrist wristOf(const Mat3& R_36) noexcept {
  const Mat3& b = R_36;
  const double bend_sin = std::sqrt(b(0, 2) * b(0, 2) + b(1, 2) * b(1, 2));
  // Joint 6 follows from joint 4, not from the last row as in eq. 3.20: near a singularity both would have errors of
  // their own, whereas only their sum (or difference) is well determined.
  const bool says = bend_sin > kNoBend;
  const SinCos four = says ? SinCos{b(1, 2) / bend_sin, b(0, 2) / bend_sin} : SinCos{};
  const auto [q5_rad, q6_rad] = atan2OfTwo(bend_sin, b(2, 2), four.cos * b(1, 0) - four.sin * b(0, 0),
                                           four.cos * b(1, 1) - four.sin * b(0, 1));  // erratum 3.18
  const double q4_rad = says ? atan2Of(four.sin, four.cos) : 0.0;                     // erratum 3.19
  return {q4_rad, q5_rad, q6_rad, bend_sin, b(2, 2) > 0.0};
}

}  // namespace underact::arm
