#include "app/mesh_reader/polygons.h"

#include <algorithm>
#include <cmath>

#include "core/base/types.h"
#include "core/mesh_file/limits.h"

namespace underact::mesh_reader {
namespace {

// Ear clipping takes the square of this number, in the worst case its cube.
constexpr std::size_t kMaxEars = 256;

bool isFinite(const Eigen::Vector3f& p) {
  return std::abs(p.x()) < mesh_file::kBeyondAll && std::abs(p.y()) < mesh_file::kBeyondAll &&
         std::abs(p.z()) < mesh_file::kBeyondAll;
}

Vec3 at(const std::vector<Eigen::Vector3f>& p_MV, std::int32_t corner) {
  return p_MV[static_cast<std::size_t>(corner)].cast<double>();
}

/// Twice the area of the face as a vector, by Newell's method: for any shape.
Vec3 normalOf(const std::vector<Eigen::Vector3f>& p_MV, std::span<const std::int32_t> face) {
  Vec3 sum = Vec3::Zero();
  const Vec3 first = at(p_MV, face[0]);
  for (std::size_t k = 1; k + 1 < face.size(); ++k) {
    sum += (at(p_MV, face[k]) - first).cross(at(p_MV, face[k + 1]) - first);
  }
  return sum;
}

/// How far ABC turns about the normal: above 0 if it turns as the whole face does.
double turn(const Vec3& normal, const Vec3& a, const Vec3& b, const Vec3& c) {
  return normal.dot((b - a).cross(c - a));
}

void addFan(std::span<const std::int32_t> face, std::vector<mesh::Face>& triangles) {
  for (std::size_t k = 1; k + 1 < face.size(); ++k) triangles.push_back({face[0], face[k], face[k + 1]});
}

void addQuad(const std::vector<Eigen::Vector3f>& p_MV, std::span<const std::int32_t> face,
             std::vector<mesh::Face>& triangles) {
  const Vec3 normal = normalOf(p_MV, face);
  const Vec3 a = at(p_MV, face[0]), b = at(p_MV, face[1]), c = at(p_MV, face[2]), d = at(p_MV, face[3]);
  const double by_ac = std::min(turn(normal, a, b, c), turn(normal, a, c, d));
  const double by_bd = std::min(turn(normal, b, c, d), turn(normal, b, d, a));
  // Both lie inside: the shorter one.
  const bool both = by_ac > 0.0 && by_bd > 0.0;
  const bool is_ac = both ? (c - a).squaredNorm() <= (d - b).squaredNorm() : by_ac >= by_bd;
  if (is_ac) {
    addFan(face, triangles);
  } else {
    triangles.push_back({face[1], face[2], face[3]});
    triangles.push_back({face[1], face[3], face[0]});
  }
}

/// Whether the ear at vertex k can be clipped: it turns as the face does, and no other vertex is in its triangle.
bool isEar(const std::vector<Eigen::Vector3f>& p_MV, const std::vector<std::int32_t>& left, std::size_t k,
           const Vec3& normal) {
  const std::size_t n = left.size();
  const std::size_t before = (k + n - 1) % n, after = (k + 1) % n;
  const Vec3 a = at(p_MV, left[before]), b = at(p_MV, left[k]), c = at(p_MV, left[after]);
  if (!(turn(normal, a, b, c) > 0.0)) return false;
  for (std::size_t other = 0; other < n; ++other) {
    if (other == before || other == k || other == after) continue;
    const Vec3 p = at(p_MV, left[other]);
    if (turn(normal, a, b, p) >= 0.0 && turn(normal, b, c, p) >= 0.0 && turn(normal, c, a, p) >= 0.0) return false;
  }
  return true;
}

void addEars(const std::vector<Eigen::Vector3f>& p_MV, std::span<const std::int32_t> face,
             std::vector<mesh::Face>& triangles) {
  const Vec3 normal = normalOf(p_MV, face);
  std::vector<std::int32_t> left(face.begin(), face.end());
  while (left.size() > 3) {
    std::size_t ear = 0;
    while (ear < left.size() && !isEar(p_MV, left, ear, normal)) ++ear;
    if (ear == left.size()) break;  // it intersects itself, or is degenerate
    const std::size_t n = left.size();
    triangles.push_back({left[(ear + n - 1) % n], left[ear], left[(ear + 1) % n]});
    left.erase(left.begin() + static_cast<std::ptrdiff_t>(ear));
  }
  addFan(left, triangles);
}

}  // namespace

void cutIntoTriangles(const std::vector<Eigen::Vector3f>& p_MV, std::span<const std::int32_t> face,
                      std::vector<mesh::Face>& triangles) {
  if (face.size() == 3) {
    triangles.push_back({face[0], face[1], face[2]});
  } else if (face.size() == 4) {
    addQuad(p_MV, face, triangles);
  } else if (face.size() <= kMaxEars) {
    addEars(p_MV, face, triangles);
  } else {
    addFan(face, triangles);
  }
}

mesh_file::RawMesh trianglesOf(Polygons polygons) {
  mesh_file::RawMesh raw;
  raw.polygons = static_cast<std::int64_t>(polygons.ends.size());
  const auto count = static_cast<std::int32_t>(polygons.p_MV.size());
  raw.triangles.faces.reserve(polygons.ends.size());
  std::vector<std::int32_t> face;
  std::int32_t begin = 0;
  for (const std::int32_t end : polygons.ends) {
    const std::span<const std::int32_t> corners =
        std::span(polygons.corners).subspan(static_cast<std::size_t>(begin), static_cast<std::size_t>(end - begin));
    begin = end;
    const auto is_there = [count](std::int32_t corner) { return corner >= 0 && corner < count; };
    if (!std::all_of(corners.begin(), corners.end(), is_there)) {
      ++raw.dropped.out_of_range;
      continue;
    }
    const auto is_finite = [&](std::int32_t corner) {
      return isFinite(polygons.p_MV[static_cast<std::size_t>(corner)]);
    };
    if (!std::all_of(corners.begin(), corners.end(), is_finite)) {
      ++raw.dropped.not_finite;
      continue;
    }
    face.clear();
    for (const std::int32_t corner : corners) {
      if (face.empty() || face.back() != corner) face.push_back(corner);
    }
    while (face.size() > 1 && face.back() == face.front()) face.pop_back();
    if (face.size() < 3) {
      ++raw.dropped.without_extent;
      continue;
    }
    cutIntoTriangles(polygons.p_MV, face, raw.triangles.faces);
  }
  for (Eigen::Vector3f& p_MV : polygons.p_MV) {
    if (!isFinite(p_MV)) p_MV.setZero();
  }
  raw.triangles.p_MV = std::move(polygons.p_MV);
  return raw;
}

}  // namespace underact::mesh_reader
