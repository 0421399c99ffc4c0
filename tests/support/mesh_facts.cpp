#include "tests/support/mesh_facts.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <set>
#include <utility>
#include <vector>

namespace underact::test {
namespace {

using Edge = std::pair<std::int32_t, std::int32_t>;

std::array<Vec3, 3> cornersOf(const mesh::Triangles& triangles, const mesh::Face& face) {
  std::array<Vec3, 3> at;
  for (std::size_t i = 0; i < 3; ++i) at[i] = triangles.p_MV[static_cast<std::size_t>(face[i])].cast<double>();
  return at;
}

std::vector<Edge> edgesOf(const mesh::Triangles& triangles) {
  std::vector<Edge> edges;
  edges.reserve(3 * triangles.faces.size());
  for (const mesh::Face& face : triangles.faces) {
    for (std::size_t i = 0; i < 3; ++i) edges.emplace_back(face[i], face[(i + 1) % 3]);
  }
  std::sort(edges.begin(), edges.end());
  return edges;
}

double flatnessOf(const std::array<Vec3, 3>& at) {
  double longest = 0.0;
  for (std::size_t i = 0; i < 3; ++i) longest = std::max(longest, (at[(i + 1) % 3] - at[i]).norm());
  return (at[1] - at[0]).cross(at[2] - at[0]).norm() / (longest * longest);
}

double volumeOf(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d) {
  return (b - a).cross(c - a).dot(d - a);
}

/// Whether the segment pq goes through the triangle: its ends on both sides, the corners in one sense around it.
bool meets(const Vec3& p, const Vec3& q, const std::array<Vec3, 3>& at) {
  const double low = volumeOf(at[0], at[1], at[2], p), high = volumeOf(at[0], at[1], at[2], q);
  if ((low > 0.0) == (high > 0.0)) return false;
  const bool ab = volumeOf(p, q, at[0], at[1]) > 0.0, bc = volumeOf(p, q, at[1], at[2]) > 0.0;
  return ab == bc && bc == (volumeOf(p, q, at[2], at[0]) > 0.0);
}

}  // namespace

MeshFacts factsOf(const mesh::Triangles& triangles) {
  MeshFacts facts;
  const std::vector<Edge> edges = edgesOf(triangles);
  facts.is_closed = std::adjacent_find(edges.begin(), edges.end()) == edges.end();
  int undirected = 0;
  for (const auto& [from, to] : edges) {
    const bool has_other = std::binary_search(edges.begin(), edges.end(), Edge(to, from));
    facts.is_closed = facts.is_closed && has_other;
    if (from < to || !has_other) ++undirected;
  }
  std::vector<bool> used(triangles.p_MV.size());
  for (const mesh::Face& face : triangles.faces) {
    for (const std::int32_t corner : face) used[static_cast<std::size_t>(corner)] = true;
    const std::array<Vec3, 3> at = cornersOf(triangles, face);
    facts.volume += at[0].cross(at[1]).dot(at[2]) / 6.0;
    facts.flattest = std::min(facts.flattest, flatnessOf(at));
  }
  facts.euler = static_cast<int>(std::count(used.begin(), used.end(), true)) - undirected +
                static_cast<int>(triangles.faces.size());
  return facts;
}

int crossings(const mesh::Triangles& triangles) {
  int found = 0;
  for (const mesh::Face& face : triangles.faces) {
    const std::array<Vec3, 3> at = cornersOf(triangles, face);
    const Vec3 middle = (at[0] + at[1] + at[2]) / 3.0;
    double reach = 0.0;
    for (const Vec3& corner : at) reach = std::max(reach, (corner - middle).norm());
    for (const mesh::Face& other : triangles.faces) {
      const std::array<Vec3, 3> there = cornersOf(triangles, other);
      for (std::size_t i = 0; i < 3; ++i) {
        const std::int32_t from = other[i], to = other[(i + 1) % 3];
        if (from > to ||
            std::find_if(face.begin(), face.end(), [&](int k) { return k == from || k == to; }) != face.end())
          continue;
        const Vec3 &p = there[i], &q = there[(i + 1) % 3];
        if ((0.5 * (p + q) - middle).norm() > reach + 0.5 * (q - p).norm()) continue;
        if (meets(p, q, at)) ++found;
      }
    }
  }
  return found;
}

}  // namespace underact::test
