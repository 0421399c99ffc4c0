#include "core/mesh_union/grid.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>

#include "core/base/trig.h"

namespace underact::mesh_union {
namespace {

GridPoint minus(const GridPoint& a, const GridPoint& b) {
  return {a[0] - b[0], a[1] - b[1], a[2] - b[2]};
}

std::array<std::int64_t, 3> crossed(const GridPoint& u, const GridPoint& v) {
  return {u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0]};
}

Wide dotted(const std::array<std::int64_t, 3>& n, const GridPoint& p) {
  return static_cast<Wide>(n[0]) * p[0] + static_cast<Wide>(n[1]) * p[1] + static_cast<Wide>(n[2]) * p[2];
}

}  // namespace

Grid gridOf(const std::vector<Eigen::Vector3f>& p_MV) {
  Grid grid;
  if (p_MV.empty()) return grid;
  Vec3 low = Vec3::Constant(kInfinity), high = -low;
  for (const Eigen::Vector3f& p : p_MV) {
    low = low.cwiseMin(p.cast<double>());
    high = high.cwiseMax(p.cast<double>());
  }
  grid.centre_M = 0.5 * (low + high);
  const double half = 0.5 * (high - low).maxCoeff();
  if (half > 0.0) grid.steps = std::ldexp(1.0, 23 - std::ilogb(half));  // half becomes 2^23 to 2^24
  grid.points.reserve(p_MV.size());
  for (const Eigen::Vector3f& p : p_MV) {
    const Vec3 at = grid.steps * (p.cast<double>() - grid.centre_M);
    grid.points.push_back({std::llround(at.x()), std::llround(at.y()), std::llround(at.z())});
  }
  return grid;
}

void widen(Grid& grid, const std::vector<mesh::Face>& faces, double steps) {
  constexpr double kMinShare = 1.0 / 3.0;  // of a face in the way that its corner goes: else spikes would grow long
  const auto at = [&](const mesh::Face& face, std::size_t k) -> Vec3 {
    const GridPoint& p = grid.points[static_cast<std::size_t>(face[k % 3])];
    return {static_cast<double>(p[0]), static_cast<double>(p[1]), static_cast<double>(p[2])};
  };
  std::vector<Vec3> out(grid.points.size(), Vec3::Zero()), normals;
  normals.reserve(faces.size());
  for (const mesh::Face& face : faces) {
    normals.push_back((at(face, 1) - at(face, 0)).cross(at(face, 2) - at(face, 0)).stableNormalized());
    for (std::size_t k = 0; k < 3; ++k) {
      const Vec3 to_next = at(face, k + 1) - at(face, k), to_last = at(face, k + 2) - at(face, k);
      out[static_cast<std::size_t>(face[k])] +=
          atan2Of(to_next.cross(to_last).norm(), to_next.dot(to_last)) * normals.back();
    }
  }
  for (Vec3& of : out) of = of.stableNormalized();
  std::vector<double> min(out.size(), 1.0);  // share of the way, over the faces of a corner
  for (std::size_t face = 0; face < faces.size(); ++face) {
    if (normals[face] == Vec3::Zero()) continue;  // it has no area
    for (const std::int32_t corner : faces[face]) {
      double& share = min[static_cast<std::size_t>(corner)];
      share = std::min(share, out[static_cast<std::size_t>(corner)].dot(normals[face]));
    }
  }
  for (std::size_t corner = 0; corner < out.size(); ++corner) {
    const Vec3 by = steps / std::max(min[corner], kMinShare) * out[corner];
    for (std::size_t axis = 0; axis < 3; ++axis)
      grid.points[corner][axis] += std::llround(by[static_cast<Eigen::Index>(axis)]);
  }
}

Plane planeOf(const GridPoint& a, const GridPoint& b, const GridPoint& c) {
  Plane plane{crossed(minus(b, a), minus(c, a)), 0};
  plane.d = dotted(plane.n, a);
  return plane;
}

Plane planeAlong(const GridPoint& a, const GridPoint& b, std::size_t axis) {
  GridPoint unit{};
  unit[axis] = 1;
  Plane plane{crossed(minus(b, a), unit), 0};
  plane.d = dotted(plane.n, a);
  return plane;
}

Wide heightOf(const Plane& plane, const GridPoint& p) {
  return dotted(plane.n, p) - plane.d;
}

int orientation(const GridPoint& a, const GridPoint& b, const GridPoint& c, const GridPoint& d) {
  return signOf(dotted(crossed(minus(b, a), minus(c, a)), minus(d, a)));
}

std::size_t axisOf(const Plane& plane) {
  std::size_t axis = 0;
  for (std::size_t k = 1; k < 3; ++k) {
    if (std::abs(plane.n[k]) > std::abs(plane.n[axis])) axis = k;
  }
  return axis;
}

int turnOf(std::size_t axis, const GridPoint& a, const GridPoint& b, const GridPoint& c) {
  const std::size_t u = (axis + 1) % 3, v = (axis + 2) % 3;
  return signOf(static_cast<Wide>(b[u] - a[u]) * (c[v] - a[v]) - static_cast<Wide>(b[v] - a[v]) * (c[u] - a[u]));
}

}  // namespace underact::mesh_union
