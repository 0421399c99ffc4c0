#include "core/mesh/normals.h"

#include "core/base/trig.h"

namespace underact::mesh {

std::vector<Eigen::Vector3f> cornerNormals(const Triangles& triangles) {
  std::vector<Vec3> sums(triangles.p_MV.size(), Vec3::Zero());
  for (const Face& face : triangles.faces) {
    std::array<Vec3, 3> p;
    for (std::size_t k = 0; k < 3; ++k) p[k] = triangles.p_MV[static_cast<std::size_t>(face[k])].cast<double>();
    const Vec3 normal = areaNormal(p[0], p[1], p[2]).stableNormalized();
    if (!(normal.squaredNorm() > 0.5)) continue;  // no area
    for (std::size_t k = 0; k < 3; ++k) {
      const Vec3 to_next = p[(k + 1) % 3] - p[k], to_last = p[(k + 2) % 3] - p[k];
      const double angle_rad = atan2Of(to_next.cross(to_last).norm(), to_next.dot(to_last));
      sums[static_cast<std::size_t>(face[k])] += angle_rad * normal;
    }
  }
  std::vector<Eigen::Vector3f> normals;
  normals.reserve(sums.size());
  for (const Vec3& sum : sums) normals.push_back(sum.stableNormalized().cast<float>());
  return normals;
}

}  // namespace underact::mesh
