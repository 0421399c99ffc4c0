#include "core/mesh/crossing.h"

#include "core/mesh/search.h"
#include "scenes/meshes/make/meshes.h"
#include "tests/support/mesh_oracle.h"
#include "tests/support/mesh_points.h"
#include "tests/support/property.h"

namespace underact::mesh {
namespace {

/// Ways from outside to inside of a closed mesh go through it, whatever they meet: faces, edges, corners.
TEST(Crossing, EveryWayFromOutsideToInsideGoesThrough) {
  for (const auto& make : {mesh_maker::bumpySphere, mesh_maker::torusKnot, mesh_maker::bracket, mesh_maker::cube}) {
    const Triangles triangles = make(2000);
    const std::shared_ptr<const Surface> surface = makeSurface(triangles).value();
    const test::MeshOracle oracle(triangles);
    std::vector<Vec3> inside, outside;
    for (const Vec3& q : test::pointsNear(triangles, 3.0, 300, test::Seed{5}))
      (oracle.isInside(q) ? inside : outside).push_back(q);
    ASSERT_GT(inside.size(), 50U);
    ASSERT_GT(outside.size(), 50U);
    for (std::size_t k = 0; k < std::min(inside.size(), outside.size()); ++k) {
      EXPECT_GE(firstCrossing(*surface, CrossingDirection::Inwards, outside[k], inside[k]).face, 0);
      EXPECT_GE(firstCrossing(*surface, CrossingDirection::Outwards, inside[k], outside[k]).face, 0);
    }
  }
}

TEST(Crossing, ThroughEdgesAndCornersNothingLeaks) {
  const Triangles triangles = mesh_maker::bumpySphere(2000);
  const std::shared_ptr<const Surface> surface = makeSurface(triangles).value();
  for (std::size_t face = 0; face < surface->triangles.faces.size(); ++face) {
    const Corners corners = cornersOf(*surface, static_cast<std::int32_t>(face));
    for (const Vec3& aim :
         {corners.a, corners.b, Vec3(0.5 * (corners.a + corners.b)), Vec3(0.25 * corners.b + 0.75 * corners.c)}) {
      // From far outside through the very corner to the ball's middle.
      EXPECT_GE(firstCrossing(*surface, CrossingDirection::Inwards, 1.5 * aim, Vec3::Zero()).face, 0);
      EXPECT_GE(firstCrossing(*surface, CrossingDirection::Inwards, 1.5 * aim, 0.5 * aim).face, 0);
    }
  }
}

TEST(Crossing, TheFirstFaceCounts) {
  const std::shared_ptr<const Surface> plate = makeSurface(mesh_maker::plate(1.0, 12)).value();
  const double front = static_cast<double>(plate->high_M.z());
  const Crossing through = firstCrossing(*plate, CrossingDirection::Inwards, {1, 2, 10}, {1, 2, -10});
  ASSERT_GE(through.face, 0);
  EXPECT_NEAR(cornersOf(*plate, through.face).a.z(), front, 0.0);
  const Crossing back = firstCrossing(*plate, CrossingDirection::Inwards, {1, 2, -10}, {1, 2, 10});
  ASSERT_GE(back.face, 0);
  EXPECT_NEAR(cornersOf(*plate, back.face).a.z(), static_cast<double>(plate->low_M.z()), 0.0);
}

TEST(Crossing, AWayThatEndsBeforeOrGoesBesideMeetsNothing) {
  const std::shared_ptr<const Surface> cube = makeSurface(mesh_maker::cube(300)).value();
  EXPECT_EQ(firstCrossing(*cube, CrossingDirection::Inwards, {0, 0, 50}, {0, 0, 30.001}).face, -1);
  EXPECT_EQ(firstCrossing(*cube, CrossingDirection::Inwards, {31, -50, 0}, {31, 50, 0}).face, -1);
  EXPECT_EQ(firstCrossing(*cube, CrossingDirection::Inwards, {0, 0, 10}, {0, 0, 50}).face,
            -1);  // out of it, not into it
  EXPECT_EQ(firstCrossing(*cube, CrossingDirection::Inwards, {1, 1, 1}, {1, 1, 1}).face, -1);
  EXPECT_EQ(firstCrossing(*cube, CrossingDirection::Inwards, Vec3::Constant(kNotANumber), {0, 0, 0}).face, -1);
}

TEST(Crossing, ATipThatRestsOnAFaceDoesNotComeThroughIt) {
  const Triangles triangles = mesh_maker::bumpySphere(5000);
  const std::shared_ptr<const Surface> surface = makeSurface(triangles).value();
  SearchState state;
  for (const Vec3& q : test::pointsNear(triangles, 1.0, 2000, test::Seed{9})) {
    const Hit hit = nearestPoint(*surface, Search::Global, q, state);
    const Vec3 out = outwardAt(*surface, hit);
    EXPECT_GE(firstCrossing(*surface, CrossingDirection::Inwards, hit.p_M, hit.p_M - 0.3 * out).face, 0);
  }
}

}  // namespace
}  // namespace underact::mesh
