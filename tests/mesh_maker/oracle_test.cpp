#include <gtest/gtest.h>

#include <cmath>

#include "scenes/meshes/make/meshes.h"
#include "tests/support/mesh_oracle.h"
#include "tests/support/mesh_points.h"
#include "tests/support/odd_meshes.h"

// What tests of the search lean on: the oracle against shapes with a formula, and the hand's way.
namespace underact::test {
namespace {

TEST(MeshOracle, KnowsAFaceItsEdgesAndItsCorners) {  // worked by hand
  const MeshOracle oracle({{{0, 0, 0}, {4, 0, 0}, {0, 4, 0}}, {{0, 1, 2}}});
  EXPECT_EQ(oracle.distance({1, 1, 7}), 7.0);
  EXPECT_EQ(oracle.distance({2, -3, 4}), 5.0);
  EXPECT_EQ(oracle.distance({-2, -1, 2}), 3.0);
  EXPECT_EQ(oracle.distance({3, 3, 0}), std::sqrt(2.0));
  EXPECT_EQ(oracle.distance({0.5, 0.25, 0}), 0.0);
}

TEST(MeshOracle, KnowsTheCubeInsideAndOut) {
  const MeshOracle oracle(mesh_maker::cube(300));
  for (const Vec3& q_M : pointsAbout(mesh_maker::cube(12), 500, Seed{20070611})) {
    const Vec3 off = q_M.cwiseAbs() - Vec3::Constant(30.0);
    const double outside = off.cwiseMax(0.0).norm();
    EXPECT_NEAR(oracle.distance(q_M), outside > 0.0 ? outside : -off.maxCoeff(), 1e-13);
    EXPECT_EQ(oracle.isInside(q_M), outside == 0.0);
  }
}

void expectStroke(const mesh::Triangles& triangles, double mm) {
  const std::vector<Vec3> path = handPath(triangles, mm, 4000, Seed{20070612});
  const MeshOracle oracle(triangles);
  double nearest = kInfinity, direction = 0.0;
  for (std::size_t i = 0; i < path.size(); ++i) {
    const double distance = oracle.distance(path[i]) / mm;
    nearest = std::min(nearest, distance);
    ASSERT_LT(distance, 5.5);  // the bell's bend beside a curved surface, which is not bounded by the 5 mm
    if (i == 0) continue;
    const double step = (path[i] - path[i - 1]).norm() / mm;
    ASSERT_LT(step, 0.5 + 1e-9);
    direction += step;
    if (i > 1) {
      // Back on its heel at 0.5 mm/ms, smoothed over s = 4 ms: 2 x 0.5 / (s sqrt(2 pi)).
      ASSERT_LT((path[i] - 2.0 * path[i - 1] + path[i - 2]).norm() / mm, 0.1);
    }
  }
  EXPECT_LT(nearest, 0.05);
  EXPECT_GT(direction / static_cast<double>(path.size()), 0.25);  // mm/ms; 0.3 but for what turns cost
}

TEST(HandPath, StrokesTheSurfaceAtAHandsSpeed) {
  expectStroke(mesh_maker::torusKnot(20000), 1.0);
  expectStroke(mesh_maker::bumpySphere(20000), 1.0);
  expectStroke(mesh_maker::bracket(1000), 1.0);
}

TEST(HandPath, GoesOverAllThatIsOdd) {
  for (const OddMesh& odd : oddMeshes()) {
    const std::vector<Vec3> path = handPath(odd.triangles, diagonalOf(odd.triangles) / 100.0, 100, Seed{20070613});
    ASSERT_EQ(path.size(), 100U);
    for (const Vec3& p_M : path) ASSERT_TRUE(p_M.allFinite()) << odd.name;
  }
}

}  // namespace
}  // namespace underact::test
