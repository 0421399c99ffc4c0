#pragma once
#include "core/base/real_time.h"
#include "core/base/result.h"
#include "core/shape/nearest.h"

namespace underact::shape {

/// The surface of a box. Made by makeBox(), which leaves half_m > 0 and R_WB a rotation.
struct Box {
  Vec3 p_WC;
  Vec3 half_m;  // half of the edge along each of its own axes
  Mat3 R_WB;    // its own axes, as columns
};
/// Problems: a size not above 0, R_WB no rotation (R R^T off identity by more than 1e-6, or left-handed), a number that
/// is not finite. R_WB is made orthonormal to the last bit.
Result<Box> makeBox(const Vec3& p_WC, const Vec3& size_m, const Mat3& R_WB, const SourceLocation& place);
/// p_WT: m, finite. NotUnique inside where two faces are equally near. Within 64 ulp of the largest coordinate. Cost:
/// constant.
Nearest closestPoint(const Box& box, const Vec3& p_WT) noexcept UNDERACT_REAL_TIME;

}  // namespace underact::shape
