#include "core/mesh_file/crossings.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "core/mesh_file/steps.h"

namespace underact::mesh_file {
namespace {

constexpr std::int64_t kMaxBoxes = 400'000'000;  // compared; about 1 s
constexpr std::int64_t kMaxTests = 3'000'000;    // of triangles; about 1 s

struct Box {
  Eigen::Vector3f low, high;
  std::int32_t face;
};

bool shareACorner(const mesh::Face& a, const mesh::Face& b) {
  return std::any_of(a.begin(), a.end(), [&b](std::int32_t corner) { return std::ranges::count(b, corner) > 0; });
}

using Corners = std::array<Vec3, 3>;

/// Whether the segment PQ passes through the triangle, not along its plane; also through an edge: where a mesh meets
/// its mirror image, only edges meet edges.
bool pierces(const Vec3& p, const Vec3& q, const Corners& t) {
  const Vec3 normal = (t[1] - t[0]).cross(t[2] - t[0]);
  const double from = normal.dot(p - t[0]), to = normal.dot(q - t[0]);
  if (!((from > 0.0 && to < 0.0) || (from < 0.0 && to > 0.0))) return false;
  const Vec3 along = q - p;
  const Vec3 a = t[0] - p, b = t[1] - p, c = t[2] - p;
  const double u = along.dot(a.cross(b)), v = along.dot(b.cross(c)), w = along.dot(c.cross(a));
  return (u >= 0.0 && v >= 0.0 && w >= 0.0) || (u <= 0.0 && v <= 0.0 && w <= 0.0);
}

/// Twice the signed area of ABC as seen along an axis.
double turn(const Vec3& a, const Vec3& b, const Vec3& c, Eigen::Index axis) {
  const Eigen::Index u = (axis + 1) % 3, v = (axis + 2) % 3;
  return (b[u] - a[u]) * (c[v] - a[v]) - (b[v] - a[v]) * (c[u] - a[u]);
}

bool overlapInPlane(const Corners& s, const Corners& t) {
  const Vec3 normal = (t[1] - t[0]).cross(t[2] - t[0]);
  const double length = normal.norm();
  // Coplanar within the precision of floats: 2^-22 of their size.
  const double size = std::max({(s[1] - s[0]).norm(), (t[1] - t[0]).norm(), (t[2] - t[0]).norm()});
  for (const Vec3& p : s) {
    if (!(std::abs(normal.dot(p - t[0])) <= 0x1p-22 * size * length)) return false;
  }
  Eigen::Index axis = 0;
  if (!(normal.cwiseAbs().maxCoeff(&axis) > 0.0)) return false;
  const auto crosses = [axis](const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d) {
    return turn(a, b, c, axis) * turn(a, b, d, axis) < 0.0 && turn(c, d, a, axis) * turn(c, d, b, axis) < 0.0;
  };
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t j = 0; j < 3; ++j) {
      if (crosses(s[i], s[(i + 1) % 3], t[j], t[(j + 1) % 3])) return true;
    }
  }
  return false;
}

bool cross(const Corners& s, const Corners& t) {
  for (std::size_t k = 0; k < 3; ++k) {
    if (pierces(s[k], s[(k + 1) % 3], t) || pierces(t[k], t[(k + 1) % 3], s)) return true;
  }
  return overlapInPlane(s, t);
}

Corners cornersOf(const mesh::Triangles& triangles, std::int32_t face) {
  Corners corners;
  for (std::size_t k = 0; k < 3; ++k) {
    const std::int32_t corner = triangles.faces[static_cast<std::size_t>(face)][k];
    corners[k] = triangles.p_MV[static_cast<std::size_t>(corner)].cast<double>();
  }
  return corners;
}

/// The boxes of the triangles, sorted along the mesh's longest axis, so that those that may meet are near each other.
std::vector<Box> boxesOf(const mesh::Triangles& triangles, Eigen::Index& axis) {
  std::vector<Box> boxes(triangles.faces.size());
  Eigen::Vector3f low = Eigen::Vector3f::Constant(INFINITY), high = -low;
  for (std::size_t face = 0; face < boxes.size(); ++face) {
    const auto at = [&](std::size_t k) -> const Eigen::Vector3f& {
      return triangles.p_MV[static_cast<std::size_t>(triangles.faces[face][k])];
    };
    boxes[face] = {at(0).cwiseMin(at(1)).cwiseMin(at(2)), at(0).cwiseMax(at(1)).cwiseMax(at(2)),
                   static_cast<std::int32_t>(face)};
    low = low.cwiseMin(boxes[face].low);
    high = high.cwiseMax(boxes[face].high);
  }
  (high - low).maxCoeff(&axis);
  std::sort(boxes.begin(), boxes.end(), [axis](const Box& a, const Box& b) {
    return a.low[axis] != b.low[axis] ? a.low[axis] < b.low[axis] : a.face < b.face;
  });
  return boxes;
}

bool overlap(const Box& a, const Box& b) {
  return (a.low.array() <= b.high.array()).all() && (b.low.array() <= a.high.array()).all();
}

}  // namespace

Crossings crossingsOf(const mesh::Triangles& triangles, const TaskMonitor& monitor) {
  Crossings found;
  if (triangles.faces.size() > kMaxFacesForCrossings) return found;
  Eigen::Index axis = 0;
  const std::vector<Box> boxes = boxesOf(triangles, axis);
  std::int64_t compared = 0, tested = 0;
  Steps steps(monitor);
  for (std::size_t i = 0; i < boxes.size(); ++i) {
    const Corners corners = cornersOf(triangles, boxes[i].face);
    for (std::size_t j = i + 1; j < boxes.size() && boxes[j].low[axis] <= boxes[i].high[axis]; ++j) {
      if (++compared > kMaxBoxes || tested > kMaxTests || steps.isCancelled()) return found;
      if (!overlap(boxes[i], boxes[j])) continue;
      const mesh::Face& a = triangles.faces[static_cast<std::size_t>(boxes[i].face)];
      const mesh::Face& b = triangles.faces[static_cast<std::size_t>(boxes[j].face)];
      if (shareACorner(a, b)) continue;
      ++tested;
      if (cross(corners, cornersOf(triangles, boxes[j].face))) ++found.pairs;
    }
  }
  found.is_whole = true;
  return found;
}

}  // namespace underact::mesh_file
