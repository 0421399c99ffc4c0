#include "tests/support/mesh_walker.h"

#include <algorithm>
#include <tuple>

namespace underact::test {
namespace {

std::vector<std::array<std::int32_t, 3>> acrossEdges(const mesh::Triangles& triangles) {
  std::vector<std::tuple<std::int32_t, std::int32_t, std::size_t, std::size_t>> edges;  // corners, face, which
  for (std::size_t face = 0; face < triangles.faces.size(); ++face) {
    for (std::size_t i = 0; i < 3; ++i) {
      const auto [low, high] = std::minmax(triangles.faces[face][i], triangles.faces[face][(i + 1) % 3]);
      edges.emplace_back(low, high, face, i);
    }
  }
  std::sort(edges.begin(), edges.end());
  std::vector<std::array<std::int32_t, 3>> across(triangles.faces.size(), {-1, -1, -1});
  for (std::size_t k = 0; k + 1 < edges.size(); ++k) {
    const auto& [a, b, face, edge] = edges[k];
    const auto& [c, d, other, its_edge] = edges[k + 1];
    if (a != c || b != d) continue;
    across[face][edge] = static_cast<std::int32_t>(other);
    across[other][its_edge] = static_cast<std::int32_t>(face);
    ++k;  // a third face at the edge has a border there
  }
  return across;
}

}  // namespace

MeshWalker::MeshWalker(const mesh::Triangles& triangles, Seed seed)
    : triangles_(triangles), across_(acrossEdges(triangles)), random_(seed) {
  start(random_.below(triangles.faces.size()));
}

Vec3 MeshWalker::corner(std::size_t i) const {
  return triangles_.p_MV[static_cast<std::size_t>(triangles_.faces[static_cast<std::size_t>(face_)][i % 3])]
      .cast<double>();
}

Vec3 MeshWalker::inward(std::size_t edge) const {
  return normal_M_.cross(corner(edge + 1) - corner(edge)).normalized();
}

bool MeshWalker::isOn(std::int32_t face) {
  const std::int32_t before = face_;
  face_ = face;
  const Vec3 normal_M = (corner(1) - corner(0)).cross(corner(2) - corner(0));
  if (normal_M.squaredNorm() > 0.0) {
    normal_M_ = normal_M.normalized();
    return true;
  }
  face_ = before;
  return false;
}

/// The first face from this one on that has an area; somewhere inside, in any direction.
void MeshWalker::start(std::size_t face) {
  for (std::size_t tried = 0; tried < triangles_.faces.size(); ++tried) {
    if (isOn(static_cast<std::int32_t>((face + tried) % triangles_.faces.size()))) break;
  }
  p_M_ = (corner(0) + corner(1) + corner(2)) / 3.0;
  ahead_M_ = normal_M_.cross(random_.direction()).normalized();
}

void MeshWalker::turn(double angle_rad) {
  ahead_M_ = Eigen::AngleAxisd(angle_rad, normal_M_) * ahead_M_;
  ahead_M_ = (ahead_M_ - ahead_M_.dot(normal_M_) * normal_M_).normalized();
}

void MeshWalker::cross(std::size_t edge) {
  const Vec3 along_M = (corner(edge + 1) - corner(edge)).normalized();
  const Vec3 inward_M = inward(edge);
  const double along = ahead_M_.dot(along_M), out = std::abs(ahead_M_.dot(inward_M));
  const std::int32_t from = face_, to = across_[static_cast<std::size_t>(face_)][edge];
  if (to < 0 || !isOn(to)) {
    ahead_M_ = along * along_M + out * inward_M;
    return;
  }
  const auto& back = across_[static_cast<std::size_t>(to)];
  for (std::size_t i = 0; i < 3; ++i) {
    const Vec3 its_M = (corner(i + 1) - corner(i)).normalized();
    if (back[i] == from && std::abs(its_M.dot(along_M)) > 1.0 - 1e-9) ahead_M_ = along * along_M + out * inward(i);
  }
}

void MeshWalker::go(double length) {
  for (int crossed = 0; crossed < 200; ++crossed) {
    double nearest = kInfinity;
    std::size_t edge = 3;
    for (std::size_t i = 0; i < 3; ++i) {
      const Vec3 inward_M = inward(i);
      const double closing = -ahead_M_.dot(inward_M);
      if (!(closing > 0.0)) continue;
      const double travel = std::max(0.0, (p_M_ - corner(i)).dot(inward_M)) / closing;
      if (travel < nearest) nearest = travel, edge = i;
    }
    if (edge == 3) break;
    p_M_ += std::min(nearest, length) * ahead_M_;
    if (nearest >= length) return;
    length -= nearest;
    cross(edge);
  }
  start(random_.below(triangles_.faces.size()));  // caught at a corner or in a sliver
}

}  // namespace underact::test
