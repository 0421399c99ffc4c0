#include "core/shape/box.h"

#include <algorithm>
#include <cmath>

#include "core/base/nearest_rotation.h"
#include "core/base/norms.h"
#include "core/base/translate.h"

namespace underact::shape {
namespace {

/// The nearest of the six faces from inside, unless two of them are equally near. d_B: the tip in the box's own axes.
Nearest fromInside(const Box& box, const Vec3& d_B, const Vec3& p_WT) noexcept {
  const Vec3 to_face_m = box.half_m - d_B.cwiseAbs();
  Eigen::Index nearest = to_face_m[1] < to_face_m[0] ? 1 : 0;
  if (to_face_m[2] < to_face_m[nearest]) nearest = 2;
  const double depth_m = to_face_m[nearest];
  const double lost_m = kDirectionLost * (largestOf(box.half_m) + largestOf(box.p_WC));
  bool tie = std::abs(d_B[nearest]) <= lost_m;  // halfway between opposite faces
  for (Eigen::Index axis = 0; axis < 3; ++axis) {
    if (axis != nearest && to_face_m[axis] - depth_m <= lost_m) tie = true;
  }
  if (tie && depth_m > lost_m) return {p_WT, Status::NotUnique, -depth_m};
  Vec3 q_B = d_B;
  q_B[nearest] = std::copysign(box.half_m[nearest], d_B[nearest]);
  return {box.p_WC + box.R_WB * q_B, Status::Unique, -depth_m};
}

}  // namespace

Result<Box> makeBox(const Vec3& p_WC, const Vec3& size_m, const Mat3& R_WB, const SourceLocation& place) {
  Problems problems;
  if (!p_WC.allFinite())
    problems.push_back({phrase(TRANSLATE_NOOP("problem", "The centre is not a finite point.")), place});
  const Vec3 half_m = size_m / 2.0;
  if (!(half_m.allFinite() && minOf(half_m) > 0.0))
    problems.push_back({phrase(TRANSLATE_NOOP("problem", "Every size must be above 0.")), place});
  if (Sentence sentence = rotationProblem(R_WB); !sentence.empty()) problems.push_back({std::move(sentence), place});
  if (!problems.empty()) return problems;
  if (R_WB == Mat3::Identity()) return Box{p_WC, half_m, R_WB};
  return Box{p_WC, half_m, nearestRotation(R_WB)};
}

Nearest closestPoint(const Box& box, const Vec3& p_WT) noexcept {
  const Vec3 d_B = box.R_WB.transpose() * (p_WT - box.p_WC);
  const Vec3 q_B(std::clamp(d_B.x(), -box.half_m.x(), box.half_m.x()),
                 std::clamp(d_B.y(), -box.half_m.y(), box.half_m.y()),
                 std::clamp(d_B.z(), -box.half_m.z(), box.half_m.z()));
  const double outside_m = (d_B - q_B).norm();
  if (outside_m > 0.0) return {box.p_WC + box.R_WB * q_B, Status::Unique, outside_m};
  return fromInside(box, d_B, p_WT);
}

}  // namespace underact::shape
