#include <gtest/gtest.h>

#include <cstring>

#include "core/mesh/proxy.h"
#include "core/mesh/surface_bytes.h"
#include "core/mesh_file/load.h"
#include "core/mesh_file/repair.h"
#include "core/mesh_file/report.h"
#include "tests/core/mesh_file/some_meshes.h"
#include "tests/support/crossed_bodies.h"
#include "tests/support/property.h"

namespace underact::mesh_file {
namespace {

using mesh::Triangles;

Triangles minCase() {  // one box stands on another, 10 deep in it
  return test::together({test::boxOf({-20, -20, -20}, {20, 20, 0}), test::boxOf({0, -20, -10}, {20, 20, 20})});
}

Loaded loaded(const Triangles& triangles) {
  const test::ScratchFolder folder;
  return loadMesh(folder.write("m.stl", test::stlBinary(test::soup(triangles))), {}, Cache("/dev/null")).value();
}

TEST(IntersectingMesh, HasNoFreePlaceWithinAndNoWayThroughItsWalls) {
  const Loaded body = loaded(minCase());
  EXPECT_EQ(body.facts.inside, Inside::United);
  EXPECT_GT(body.facts.crossings, 0);
  ASSERT_TRUE(body.surface->is_closed);
  mesh::ProxyState first, sliding;
  EXPECT_GE(mesh::followProxy(*body.surface, mesh::FreeSide::Outside, {10, 0, 8}, first).face, 0);
  for (double z = 3.0; z >= -1.5; z -= 0.05)
    mesh::followProxy(*body.surface, mesh::FreeSide::Outside, {-10, 0, z}, sliding);
  for (double x = -10.0; x <= 10.0; x += 0.05) {
    const mesh::Hit hit = mesh::followProxy(*body.surface, mesh::FreeSide::Outside, {x, 0, -1.5}, sliding);
    ASSERT_GE(hit.face, 0) << x;
    EXPECT_NEAR((hit.p_M - Vec3(std::min(x, 0.0), 0.0, 0.0)).norm(), 0.0, 5e-4) << x;  // some weld distances
  }
}

TEST(IntersectingMesh, ComesFromTheCacheAsItWasMade) {
  const test::ScratchFolder folder;
  const Cache cache(folder.path() + "/cache");
  const std::string path = folder.write("m.stl", test::stlBinary(test::soup(minCase())));
  const Loaded first = loadMesh(path, {}, cache).value(), second = loadMesh(path, {}, cache).value();
  EXPECT_TRUE(second.from_cache);
  EXPECT_EQ(mesh::surfaceBytes(*first.surface), mesh::surfaceBytes(*second.surface));
  EXPECT_EQ(std::memcmp(&first.facts, &second.facts, sizeof(Facts)), 0);
}

TEST(IntersectingMesh, ThatDoesNotIsLeftAsItIsToTheBit) {
  for (const Triangles& one :
       {test::ball(20.0F, 3), test::joined(test::ball(20.0F, 2), test::cube(3.0F, {30, 0, 0}))}) {
    const Loaded body = loaded(one);
    EXPECT_EQ(body.facts.inside, Inside::AsItIs);
    EXPECT_EQ(mesh::surfaceBytes(*body.surface),
              mesh::surfaceBytes(*mesh::makeSurface(repair(test::soup(one))->triangles).value()));
  }
}

TEST(IntersectingMesh, OfBodiesThatMeetInEdgesOrFacesIsAWall) {
  const Triangles box = test::boxOf({0, 0, 0}, {10, 10, 10});
  for (const Vec3& by : {Vec3(10, 0, 0), Vec3(10, 10, 0), Vec3(10, 10, 10), Vec3(10, 3, 4), Vec3(0, 0, 0)}) {
    const Loaded body = loaded(test::together({box, test::moved(box, Mat3::Identity(), by)}));
    EXPECT_TRUE(allowsWalls(body.facts)) << by.transpose() << noWallsReason(body.facts);
    EXPECT_TRUE(body.surface->is_closed) << by.transpose();
    mesh::ProxyState state;
    EXPECT_GE(mesh::followProxy(*body.surface, mesh::FreeSide::Outside, {5, 5, 5}, state).face, 0);
    if (by == Vec3(10, 0, 0)) {  // glued by their faces: no wall between them
      mesh::SearchState search;
      EXPECT_NEAR(nearestPoint(*body.surface, mesh::Search::Global, {10, 5, 5}, search).squared, 25.0, 1e-2);
    }
  }
}

/// As a convex decomposition rounds them: both parts end at one plane, apart from the last digits.
TEST(IntersectingMesh, AGapOfRoundingBetweenPartsIsNotFelt) {
  const Loaded body = loaded(
      test::together({test::boxOf({-20, -20, -20}, {0, 20, 20}), test::boxOf({2.2e-4, -15, -15}, {20, 15, 15})}));
  EXPECT_LT(3.0 * body.facts.weld_tolerance, 2.2e-4);  // merging vertices would not close it
  EXPECT_EQ(body.facts.inside, Inside::United);
  mesh::ProxyState state;
  const mesh::Hit hit = mesh::followProxy(*body.surface, mesh::FreeSide::Outside, {1.1e-4, 3, 10}, state);
  ASSERT_GE(hit.face, 0);
  EXPECT_NEAR((hit.p_M - Vec3(0, 3, 15)).norm(), 0.0, 1e-3);
}

TEST(IntersectingMesh, OpenOrTwistedIsHeldToAndIsNoWall) {
  Triangles open = minCase();
  open.faces.pop_back();
  EXPECT_FALSE(allowsWalls(loaded(open).facts));
  EXPECT_FALSE(loaded(open).surface->is_closed);
}

}  // namespace
}  // namespace underact::mesh_file
