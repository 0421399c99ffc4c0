#pragma once
#include <vector>

#include "core/base/real_time.h"
#include "core/mesh/surface.h"

namespace underact::mesh {

/// The normal of the triangle ABC, as long as twice its area. Zero where it has none.
inline Vec3 areaNormal(const Vec3& a, const Vec3& b, const Vec3& c) {
  return (b - a).cross(c - a);
}

/// The normal of a face; unit, or zero where it has no area.
inline Vec3 normalOf(const Surface& surface, std::int32_t face) noexcept UNDERACT_REAL_TIME {
  const auto [a, b, c] = cornersOf(surface, face);
  const Vec3 normal = areaNormal(a, b, c);
  const double length = normal.norm();
  return length > 0.0 ? Vec3(normal / length) : Vec3(Vec3::Zero());
}

/// Of each corner the sum of its faces' unit normals, each weighted by the face's angle there; unit, or zero where they
/// cancel. Source: Thuermer and Wuethrich 1998, Computing vertex normals from polygonal facets.
std::vector<Eigen::Vector3f> cornerNormals(const Triangles& triangles);

}  // namespace underact::mesh
