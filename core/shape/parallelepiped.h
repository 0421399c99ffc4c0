#pragma once
#include "core/base/real_time.h"
#include "core/shape/box.h"
#include "core/shape/nearest.h"

namespace underact::shape {

/// A box in the metric of unequal gains. edges_W: half edges as columns, independent; inverse: of edges_W.
struct Parallelepiped {
  Vec3 p_WC;
  Mat3 edges_W;
  Mat3 inverse;
};
/// The box with each coordinate of W multiplied by scale (each > 0).
Parallelepiped scaled(const Box& box, const Vec3& scale);
/// NotUnique inside where two faces are equally near. Off the surface by at most 64 ulp of the largest coordinate, and
/// farther from the tip than the nearest point by at most as much. Cost: constant, 6 faces of 4 edges.
Nearest closestPoint(const Parallelepiped& solid, const Vec3& p_WT) noexcept UNDERACT_REAL_TIME;

}  // namespace underact::shape
