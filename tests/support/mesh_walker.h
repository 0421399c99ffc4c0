#pragma once
#include <array>
#include <vector>

#include "core/mesh/triangles.h"
#include "tests/support/random.h"

namespace underact::test {

/// A point that goes over a mesh's surface, straight ahead across its edges; at a border it is thrown back.
class MeshWalker {
 public:
  MeshWalker(const mesh::Triangles& triangles, Seed seed);
  void go(double length);
  void turn(double angle_rad);  // about the normal
  const Vec3& p_M() const { return p_M_; }
  const Vec3& normal_M() const { return normal_M_; }

 private:
  bool isOn(std::int32_t face);  // false: it has no area
  void start(std::size_t face);
  void cross(std::size_t edge);
  Vec3 corner(std::size_t i) const;
  Vec3 inward(std::size_t edge) const;  // in the face, across its edge; unit

  const mesh::Triangles& triangles_;
  std::vector<std::array<std::int32_t, 3>> across_;  // of each face's edges: the face there, or -1
  Random random_;
  std::int32_t face_ = 0;
  Vec3 p_M_ = Vec3::Zero(), ahead_M_ = Vec3::Zero(), normal_M_ = Vec3::Zero();
};

}  // namespace underact::test
