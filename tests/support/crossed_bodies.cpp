#include "tests/support/crossed_bodies.h"

#include <cmath>

#include "tests/support/mesh_oracle.h"

namespace underact::test {

using mesh::Triangles;

Triangles boxOf(const Vec3& low, const Vec3& high) {
  Triangles box;
  for (int k = 0; k < 8; ++k) {
    const Vec3 corner((k & 1) != 0 ? high.x() : low.x(), (k & 2) != 0 ? high.y() : low.y(),
                      (k & 4) != 0 ? high.z() : low.z());
    box.p_MV.emplace_back(corner.cast<float>());
  }
  box.faces = {{0, 2, 1}, {1, 2, 3}, {4, 5, 6}, {5, 7, 6}, {0, 1, 4}, {1, 5, 4},
               {2, 6, 3}, {3, 6, 7}, {0, 4, 2}, {2, 4, 6}, {1, 3, 5}, {3, 7, 5}};
  return box;
}

Triangles wedgeOf(const Vec3& size) {
  Triangles wedge;
  for (const double y : {-0.5, 0.5}) {
    for (const auto& [x, z] : {std::pair{-0.5, -0.5}, std::pair{0.5, -0.5}, std::pair{-0.5, 0.5}})
      wedge.p_MV.emplace_back(size.cwiseProduct(Vec3(x, y, z)).cast<float>());
  }
  wedge.faces = {{0, 1, 2}, {3, 5, 4}, {0, 4, 1}, {0, 3, 4}, {1, 4, 5}, {1, 5, 2}, {0, 2, 5}, {0, 5, 3}};
  return wedge;
}

Triangles roundOf(double radius, int levels) {
  std::vector<Vec3> corners{{1, 0, 0}, {-1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 1}, {0, 0, -1}};
  std::vector<mesh::Face> faces{{0, 2, 4}, {2, 1, 4}, {1, 3, 4}, {3, 0, 4}, {2, 0, 5}, {1, 2, 5}, {3, 1, 5}, {0, 3, 5}};
  for (int level = 0; level < levels; ++level) {
    std::vector<mesh::Face> finer;
    const auto middle = [&](std::int32_t a, std::int32_t b) {
      const Vec3 p = (corners[static_cast<std::size_t>(a)] + corners[static_cast<std::size_t>(b)]).normalized();
      for (std::size_t k = 0; k < corners.size(); ++k) {
        if ((corners[k] - p).norm() < 1e-9) return static_cast<std::int32_t>(k);
      }
      corners.push_back(p);
      return static_cast<std::int32_t>(corners.size() - 1);
    };
    for (const auto& [a, b, c] : faces) {
      const std::int32_t ab = middle(a, b), bc = middle(b, c), ca = middle(c, a);
      finer.insert(finer.end(), {{a, ab, ca}, {ab, b, bc}, {ca, bc, c}, {ab, bc, ca}});
    }
    faces = finer;
  }
  Triangles ball{{}, faces};
  for (const Vec3& corner : corners) ball.p_MV.emplace_back((radius * corner).cast<float>());
  return ball;
}

Triangles moved(Triangles triangles, const Mat3& R, const Vec3& by) {
  for (Eigen::Vector3f& p : triangles.p_MV) p = (R * p.cast<double>() + by).cast<float>();
  return triangles;
}

Triangles together(const std::vector<Triangles>& parts) {
  Triangles all;
  for (const Triangles& part : parts) {
    const auto first = static_cast<std::int32_t>(all.p_MV.size());
    all.p_MV.insert(all.p_MV.end(), part.p_MV.begin(), part.p_MV.end());
    for (const auto& [a, b, c] : part.faces) all.faces.push_back({first + a, first + b, first + c});
  }
  return all;
}

Triangles drawnBody(Random& random, int max_parts) {
  const std::size_t count = 2 + random.below(static_cast<std::size_t>(max_parts - 1));
  const bool along_axes = random.below(4) == 0;
  std::vector<Triangles> parts;
  for (std::size_t k = 0; k < count; ++k) {
    const auto length = [&] {
      return along_axes ? 2.0 * static_cast<double>(2 + random.below(9)) : random.between(4.0, 30.0);
    };
    const Vec3 size(length(), length(), length());
    Vec3 by = random.inBox(20.0);
    if (along_axes) by = by.array().round();
    const std::size_t kind = random.below(3);
    Triangles part = kind == 0   ? boxOf(-0.5 * size, 0.5 * size)
                     : kind == 1 ? wedgeOf(size)
                                 : roundOf(0.5 * size.x(), static_cast<int>(random.below(3)));
    const Vec3 axis = random.direction();
    const double angle_rad = along_axes ? 0.0 : random.between(0.0, 6.28);
    parts.push_back(moved(std::move(part), Eigen::AngleAxisd(angle_rad, axis).toRotationMatrix(), by));
  }
  return together(parts);
}

long double windingOf(const Triangles& triangles, const Vec3& q) {
  using Long = Eigen::Matrix<long double, 3, 1>;
  long double sum = 0.0L;
  for (const mesh::Face& face : triangles.faces) {
    const auto at = [&](std::size_t k) -> Long {
      return triangles.p_MV[static_cast<std::size_t>(face[k])].cast<long double>() - q.cast<long double>();
    };
    const Long a = at(0), b = at(1), c = at(2);
    const long double x = a.norm(), y = b.norm(), z = c.norm();
    sum += std::atan2(a.dot(b.cross(c)), x * y * z + a.dot(b) * z + b.dot(c) * x + c.dot(a) * y);
  }
  return sum / 6.283185307179586476925286766559L;
}

double distanceOf(const Triangles& triangles, const Vec3& q) {
  return MeshOracle(triangles).distance(q);
}

}  // namespace underact::test
