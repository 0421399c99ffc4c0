#include "core/mesh_union/winding.h"

#include <cmath>

#include "core/base/trig.h"

namespace underact::mesh_union {
namespace {

constexpr int kRays = 8;
/// Of the product of two lengths: nearer to an edge a ray may be on either side of it, in doubles.
constexpr double kNearEdge = 1e-12;
/// Steps of the grid; points are known within 1e-7 of one.
constexpr double kNearFace = 1e-5;

/// -1 to 1, the same in every run. Source of the constants: Steele, Lea and Flood 2014, SplitMix64.
double drawn(std::uint64_t& state) {
  state += 0x9E37'79B9'7F4A'7C15U;
  std::uint64_t z = state;
  z = (z ^ (z >> 30U)) * 0xBF58'476D'1CE4'E5B9U;
  z = (z ^ (z >> 27U)) * 0x94D0'49BB'1331'11EBU;
  return 0x1p-62 * static_cast<double>((z ^ (z >> 31U)) >> 1U) - 1.0;
}

}  // namespace

std::array<Vec3, 3> Winding::from(const Vec3& point, std::int32_t face) const {
  std::array<Vec3, 3> corners;
  for (std::size_t k = 0; k < 3; ++k) {
    const GridPoint& p = grid_.points[static_cast<std::size_t>(faces_[static_cast<std::size_t>(face)][k])];
    corners[k] = Vec3(static_cast<double>(p[0]), static_cast<double>(p[1]), static_cast<double>(p[2])) - point;
  }
  return corners;
}

int Winding::before(const Vec3& point, const Vec3& out, std::int32_t plane, int times) const {
  std::uint64_t state = 20130721;
  for (int ray = 0; ray < kRays; ++ray) {
    Vec3 along = out;
    for (Eigen::Index axis = 0; axis < 3; ++axis) along[axis] += 0.4 * drawn(state);
    int sum = 0;
    if (byRay(point, along, plane, sum)) return sum;
  }
  return byAngles(point, plane, times);
}

/// false: the ray comes too near to an edge, or begins too near to a face.
bool Winding::byRay(const Vec3& point, const Vec3& along, std::int32_t plane, int& sum) const {
  bool is_clear = true;
  boxes_.alongRay(point, along, [&](std::int32_t face) {
    const std::int32_t of_face = plane_of_[static_cast<std::size_t>(face)];
    if (!is_clear || of_face < 0 || of_face == plane) return;
    const auto [a, b, c] = from(point, face);
    const double u = along.dot(b.cross(c)), v = along.dot(c.cross(a)), w = along.dot(a.cross(b));
    const double near_u = kNearEdge * b.norm() * c.norm(), near_v = kNearEdge * c.norm() * a.norm(),
                 near_w = kNearEdge * a.norm() * b.norm();
    const bool may_be_right = u < near_u && v < near_v && (w < near_w);
    const bool may_be_left = u > -near_u && v > -near_v && (w > -near_w);
    if (!may_be_right && !may_be_left) return;
    const Vec3 normal = (b - a).cross(c - a);
    const double height = normal.dot(a), slope = normal.dot(along);
    const bool is_near = std::abs(height) <= kNearFace * normal.norm();
    if (!is_near && height * slope < 0.0) return;  // behind
    const bool is_in = (u < -near_u && v < -near_v && w < -near_w) || (u > near_u && v > near_v && w > near_w);
    is_clear = is_in && !is_near;
    sum += slope > 0.0 ? 1 : -1;
  });
  return is_clear;
}

/// The solid angle of a face is that of Van Oosterom and Strackee 1983. On the piece the sum is the mean of both sides.
int Winding::byAngles(const Vec3& point, std::int32_t plane, int times) const {
  double sum = 0.0;
  for (std::int32_t face = 0; face < static_cast<std::int32_t>(faces_.size()); ++face) {
    const std::int32_t of_face = plane_of_[static_cast<std::size_t>(face)];
    if (of_face < 0 || of_face == plane) continue;
    const auto [a, b, c] = from(point, face);
    const double x = a.norm(), y = b.norm(), z = c.norm();
    sum += 2.0 * atan2Of(a.dot(b.cross(c)), x * y * z + a.dot(b) * z + b.dot(c) * x + c.dot(a) * y);
  }
  constexpr double kWhole = 4.0 * 3.14159265358979323846;
  return static_cast<int>(std::lround(sum / kWhole - 0.5 * times));
}

}  // namespace underact::mesh_union
