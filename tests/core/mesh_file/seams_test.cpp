#include "core/mesh_file/seams.h"

#include <gtest/gtest.h>

#include "core/mesh_file/repair.h"
#include "tests/core/mesh_file/some_meshes.h"

namespace underact::mesh_file {
namespace {

using mesh::Triangles;

/// A cube whose six faces are divided into squares, a different number each: corners and edges have no faces in common.
TEST(Seams, WithDifferentCornersAreNoHoles) {
  Triangles cube;
  for (int side = 0; side < 6; ++side) {
    const int squares = 1 + side;
    const auto first = static_cast<std::int32_t>(cube.p_MV.size());
    const Eigen::Index u = side % 3, v = (side + 1) % 3, w = (side + 2) % 3;
    for (int i = 0; i <= squares; ++i) {
      for (int j = 0; j <= squares; ++j) {
        Eigen::Vector3f p_MV;
        p_MV[u] = 10.0F * static_cast<float>(i) / static_cast<float>(squares);
        p_MV[v] = 10.0F * static_cast<float>(j) / static_cast<float>(squares);
        p_MV[w] = side < 3 ? 0.0F : 10.0F;
        cube.p_MV.push_back(p_MV);
      }
    }
    for (int i = 0; i < squares; ++i) {
      for (int j = 0; j < squares; ++j) {
        const std::int32_t a = first + i * (squares + 1) + j, b = a + squares + 1;
        cube.faces.push_back({a, b, b + 1});
        cube.faces.push_back({a, b + 1, a + 1});
      }
    }
  }
  const Repaired done = repair(cube).value();
  EXPECT_TRUE(isClosed(done.facts));
  EXPECT_GT(done.facts.added_at_seams, 12);
  EXPECT_EQ(done.facts.flat_faces, 0);
  EXPECT_NEAR(done.facts.volume, 1000.0, 1e-3);
  EXPECT_EQ(2 * done.facts.corners, done.facts.faces + 4);  // Euler
  const Repaired open = repair(test::sheet(4)).value();     // no seam: unchanged
  EXPECT_EQ(open.facts.added_at_seams, 0);
  EXPECT_EQ(open.facts.borders, 1);
}

}  // namespace
}  // namespace underact::mesh_file
