#include "core/mesh/cut.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "core/mesh/search.h"
#include "scenes/meshes/make/meshes.h"
#include "tests/support/mesh_oracle.h"
#include "tests/support/mesh_points.h"
#include "tests/support/odd_meshes.h"
#include "tests/support/property.h"

// Where a search may begin: that nothing nearer lies outside, against every face.
namespace underact::mesh {
namespace {

using test::Seed;

std::shared_ptr<const Surface> knotOf(int faces) {
  return makeSurface(mesh_maker::torusKnot(faces)).value();
}

/// The faces that are below none of the cut's nodes.
Triangles outside(const Surface& surface, const Cut& cut) {
  std::vector<bool> is_below(surface.triangles.faces.size(), false);
  std::vector<std::int32_t> nodes(cut.nodes.begin(), cut.nodes.begin() + cut.size);
  while (!nodes.empty()) {
    const Node& node = surface.nodes[static_cast<std::size_t>(nodes.back())];
    nodes.pop_back();
    for (const std::int32_t child : node.children) {
      if (child >= 0) nodes.push_back(child);
      if (child < 0 && child != kNoChild) is_below[static_cast<std::size_t>(-1 - child)] = true;
    }
  }
  Triangles others{surface.triangles.p_MV, {}};
  for (std::size_t face = 0; face < is_below.size(); ++face) {
    if (!is_below[face]) others.faces.push_back(surface.triangles.faces[face]);
  }
  return others;
}

TEST(Cut, LeavesOutNoFaceWithinItsReach) {
  std::vector<Triangles> meshes{mesh_maker::torusKnot(20000), mesh_maker::bracket(5000)};
  for (const test::OddMesh& odd : test::oddMeshes()) meshes.push_back(odd.triangles);
  int max_left_out = 0;
  for (const Triangles& triangles : meshes) {
    const auto surface = makeSurface(triangles).value();
    const double size = test::diagonalOf(triangles);
    int left_out = 0;
    for (const Vec3& q_M : test::pointsNear(triangles, 0.05 * size, 20, Seed{20070660})) {
      for (const double reach : {0.01 * size, 0.06 * size, 0.2 * size}) {
        int visits = 0;
        const Cut cut = makeCut(*surface, q_M, reach, visits);
        ASSERT_GE(cut.size, 1U);
        ASSERT_LE(cut.size, Cut::kMax);
        const Triangles others = outside(*surface, cut);
        if (others.faces.empty()) continue;
        ++left_out;
        const double rounding = 1e-12 * std::max(size, q_M.cwiseAbs().maxCoeff());
        ASSERT_GE(test::MeshOracle(others).distance(q_M), reach - rounding);
      }
    }
    max_left_out = std::max(max_left_out, left_out);
  }
  EXPECT_GT(max_left_out, 30);  // of 60: or nothing was put to the test
}

TEST(Cut, HoldsForAsFarAsTheTipMayGo) {
  const auto surface = knotOf(1000);
  int visits = 0;
  const Cut cut = makeCut(*surface, Vec3::Zero(), 3.0, visits);
  EXPECT_TRUE(holds(cut, *surface, Vec3::Zero(), 2.999));
  EXPECT_TRUE(holds(cut, *surface, {1, 0, 0}, 1.999));
  EXPECT_FALSE(holds(cut, *surface, {1, 0, 0}, 2.001));
  EXPECT_FALSE(holds(cut, *surface, {0, 3, 0}, 0.001));
}

TEST(Cut, HoldsForNoOtherSurfaceAndNotWhereItIsBroken) {
  const auto surface = knotOf(1000), other = knotOf(2000);
  int visits = 0;
  const Cut cut = makeCut(*surface, Vec3::Zero(), 3.0, visits);
  EXPECT_NE(surface->mark, other->mark);
  EXPECT_FALSE(holds(cut, *other, Vec3::Zero(), 1.0));
  EXPECT_FALSE(holds(Cut{}, *surface, Vec3::Zero(), 0.0));
  for (const std::int32_t node : {-1, static_cast<std::int32_t>(surface->nodes.size())}) {
    Cut broken = cut;
    broken.nodes.back() = node;
    EXPECT_FALSE(holds(broken, *surface, Vec3::Zero(), 1.0));
  }
  Cut broken = cut;
  broken.size = Cut::kMax + 1;
  EXPECT_FALSE(holds(broken, *surface, Vec3::Zero(), 1.0));
  broken.size = 0;
  EXPECT_FALSE(holds(broken, *surface, Vec3::Zero(), 1.0));
}

TEST(Cut, ServesSeveralSearchesAlongAHandsPath) {  // or it costs more than it spares
  const auto surface = knotOf(20000);
  SearchState state;
  int made = 0, count = 0;
  for (const Vec3& q_M : test::handPath(surface->triangles, 1.0, 2000, Seed{20070661})) {
    static_cast<void>(nearestPoint(*surface, Search::Hybrid, q_M, state));
    made += state.cut.served == 1 ? 1 : 0;
    ++count;
  }
  EXPECT_LT(made, count / 3);
}

TEST(Cut, OfAnotherSurfaceDoesNotMakeASearchWrong) {
  const Triangles small = mesh_maker::torusKnot(1000), large = mesh_maker::torusKnot(20000);
  const auto first = makeSurface(small).value(), second = makeSurface(large).value();
  const test::MeshOracle oracle_of_first(small), oracle_of_second(large);
  SearchState state;
  for (const Vec3& q_M : test::handPath(large, 1.0, 200, Seed{20070662})) {
    EXPECT_NEAR(std::sqrt(nearestPoint(*first, Search::Hybrid, q_M, state).squared), oracle_of_first.distance(q_M),
                1e-12 * oracle_of_first.largest());
    EXPECT_NEAR(std::sqrt(nearestPoint(*second, Search::Hybrid, q_M, state).squared), oracle_of_second.distance(q_M),
                1e-12 * oracle_of_second.largest());
  }
}

}  // namespace
}  // namespace underact::mesh
