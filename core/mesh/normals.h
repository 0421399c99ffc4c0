#pragma once
#include <vector>

#include "core/mesh/triangles.h"

namespace underact::mesh {

/// The normal of the triangle ABC, as long as twice its area. Zero where it has none.
inline Vec3 areaNormal(const Vec3& a, const Vec3& b, const Vec3& c) {
  return (b - a).cross(c - a);
}

/// Of each corner the sum of its faces' unit normals, each weighted by the face's angle there; unit, or zero where they
/// cancel. Source: Thuermer and Wuethrich 1998, Computing vertex normals from polygonal facets.
std::vector<Eigen::Vector3f> cornerNormals(const Triangles& triangles);

}  // namespace underact::mesh
