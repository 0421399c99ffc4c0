#include "core/shape/parallelepiped.h"

#include <algorithm>
#include <cmath>

#include "core/base/norms.h"

namespace underact::shape {
namespace {

/// The point a u + b v, a and b in [-1, 1], nearest to d: the foot where it lies inside, else the best of the four
/// edges.
Vec3 onParallelogram(const Vec3& u, const Vec3& v, const Vec3& d) noexcept {
  const double uu = u.dot(u), uv = u.dot(v), vv = v.dot(v), ud = u.dot(d), vd = v.dot(d);
  Vec3 across = v - (uv / uu) * u;  // by Gram-Schmidt, twice: a determinant of squares cancels for a thin face
  across -= (across.dot(u) / uu) * u;
  const double b = across.dot(d) / across.dot(across), a = u.dot(d - b * v) / uu;
  if (std::abs(a) <= 1.0 && std::abs(b) <= 1.0) return a * u + b * v;
  Vec3 best = u + v;
  double best_square = kInfinity;
  for (const double end : {-1.0, 1.0}) {
    const Vec3 on_v = end * u + std::clamp((vd - end * uv) / vv, -1.0, 1.0) * v;
    const Vec3 on_u = end * v + std::clamp((ud - end * uv) / uu, -1.0, 1.0) * u;
    for (const Vec3& candidate : {on_v, on_u}) {
      const double square = (candidate - d).squaredNorm();
      if (square < best_square) {
        best_square = square;
        best = candidate;
      }
    }
  }
  return best;
}

double sizeOf(const Mat3& edges_W) noexcept UNDERACT_REAL_TIME {
  return std::max({largestOf(edges_W.col(0)), largestOf(edges_W.col(1)), largestOf(edges_W.col(2))});
}

}  // namespace

Parallelepiped scaled(const Box& box, const Vec3& scale) {
  const Mat3 edges_W = scale.asDiagonal() * box.R_WB * box.half_m.asDiagonal();
  return {scale.cwiseProduct(box.p_WC), edges_W, edges_W.inverse()};
}

Nearest closestPoint(const Parallelepiped& solid, const Vec3& p_WT) noexcept {
  const Vec3 p_CT_W = p_WT - solid.p_WC;
  const Vec3 share = solid.inverse * p_CT_W;  // in half edges
  const bool inside = largestOf(share) < 1.0;
  Vec3 best = p_CT_W;
  double nearest_m = kInfinity, second_m = kInfinity;
  for (Eigen::Index axis = 0; axis < 3; ++axis) {
    for (const double end : {-1.0, 1.0}) {
      const Vec3 middle = end * solid.edges_W.col(axis);
      const Vec3 on_face = middle + onParallelogram(solid.edges_W.col((axis + 1) % 3),
                                                    solid.edges_W.col((axis + 2) % 3), p_CT_W - middle);
      const double distance_m = (on_face - p_CT_W).norm();
      if (distance_m < nearest_m) {
        second_m = nearest_m;
        nearest_m = distance_m;
        best = on_face;
      } else {
        second_m = std::min(second_m, distance_m);
      }
    }
  }
  const double lost_m = kDirectionLost * (sizeOf(solid.edges_W) + largestOf(solid.p_WC));
  if (inside && nearest_m > lost_m && second_m - nearest_m <= lost_m) return {p_WT, Status::NotUnique, -nearest_m};
  return {solid.p_WC + best, Status::Unique, inside ? -nearest_m : nearest_m};
}

}  // namespace underact::shape
