#include "core/mesh_union/union.h"

#include <gtest/gtest.h>

#include "core/mesh/proxy.h"
#include "core/mesh/topology.h"
#include "tests/support/crossed_bodies.h"
#include "tests/support/mesh_oracle.h"
#include "tests/support/property.h"

namespace underact::mesh_union {
namespace {

using mesh::Triangles;

constexpr double kMin = 1e-5, kWide = 0.0;

Triangles united(Triangles triangles, Outcome outcome = Outcome::Made) {
  EXPECT_EQ(unite(triangles, kMin, kWide, {}).outcome, outcome);
  return triangles;
}

/// The least case: one box stands on another, 10 deep in it.
Triangles minCase() {
  return test::together({test::boxOf({-20, -20, -20}, {20, 20, 0}), test::boxOf({0, -20, -10}, {20, 20, 20})});
}

double volumeOf(const Triangles& triangles) {
  double volume = 0.0;
  for (const auto& [a, b, c] : triangles.faces)
    volume += cornerAt(triangles, a).dot(cornerAt(triangles, b).cross(cornerAt(triangles, c))) / 6.0;
  return volume;
}

/// Every point of the box that is off the faces is inside both or neither; and the surface is closed.
void expectSameInside(const Triangles& given, const Triangles& made, double half, int draws, test::Seed seed) {
  ASSERT_TRUE(mesh::topologyOf(made.faces).is_closed);
  const test::MeshOracle faces(given);
  for (const Vec3& q : test::pointsInBox(half, draws, seed)) {
    if (faces.distance(q) < 1e-3) continue;
    const long double before = test::windingOf(given, q), now = test::windingOf(made, q);
    ASSERT_NEAR(static_cast<double>(now), before > 0.5L ? 1.0 : 0.0, 1e-6) << q.transpose();
  }
}

TEST(Union, OfTwoBoxesIsWhatBothFill) {
  const Triangles made = united(minCase());
  EXPECT_NEAR(volumeOf(made), 40 * 40 * 20 + 20 * 40 * 20, 1e-6);
  expectSameInside(minCase(), made, 30.0, 2000, test::Seed{1});
}

TEST(Union, HasAProxyThatNoInnerWallStopsAndNoWallLetsThrough) {
  const std::shared_ptr<const mesh::Surface> surface = mesh::makeSurface(united(minCase())).value();
  mesh::ProxyState first;
  EXPECT_GE(mesh::followProxy(*surface, mesh::FreeSide::Outside, {10, 0, 8}, first).face,
            0);  // 8 deep in the second box
  mesh::ProxyState state;
  for (double z = 3.0; z >= -1.5; z -= 0.05) mesh::followProxy(*surface, mesh::FreeSide::Outside, {-10, 0, z}, state);
  for (double x = -10.0; x <= 10.0; x += 0.05) {
    const mesh::Hit hit = mesh::followProxy(*surface, mesh::FreeSide::Outside, {x, 0, -1.5}, state);
    ASSERT_GE(hit.face, 0) << x;
    EXPECT_NEAR((hit.p_M - Vec3(std::min(x, 0.0), 0.0, 0.0)).norm(), 0.0, 1e-5) << x;  // in the corner of both
  }
}

TEST(Union, LeavesWhatDoesNotCrossItselfAsItIs) {
  const Triangles ball = test::roundOf(10.0, 3);
  for (const Triangles& one : {ball, test::together({ball, test::moved(ball, Mat3::Identity(), {25, 0, 0})})}) {
    const Triangles made = united(one, Outcome::AsItWas);
    EXPECT_EQ(made.faces, one.faces);
    EXPECT_EQ(made.p_MV, one.p_MV);
  }
}

TEST(Union, KeepsTheCornersOfTheMeshToTheBit) {
  const Triangles made = united(minCase());
  for (const Vec3& corner : {Vec3(-20, -20, -20), Vec3(20, 20, 20), Vec3(0, -20, 20), Vec3(-20, 20, 0)}) {
    EXPECT_TRUE(std::find(made.p_MV.begin(), made.p_MV.end(), corner.cast<float>()) != made.p_MV.end());
  }
}

TEST(Union, AShellWithinIsAHollowWhereItIsTurnedInwardsAndElseSwallowed) {
  Triangles inner = test::roundOf(5.0, 2);
  const Triangles outer = test::roundOf(10.0, 2);
  EXPECT_EQ(united(test::together({outer, inner})).faces.size(), outer.faces.size());
  for (mesh::Face& face : inner.faces) std::swap(face[1], face[2]);
  united(test::together({outer, inner}), Outcome::AsItWas);
  // Something in the hollow stays, and something through its wall takes part of it.
  const Triangles hollow = test::together({outer, inner, test::boxOf({-1, -1, -1}, {1, 1, 20})});
  expectSameInside(hollow, united(hollow), 12.0, 1000, test::Seed{2});
}

TEST(Union, OfTouchingAndDoubledBodiesIsOneBody) {
  const Triangles box = test::boxOf({0, 0, 0}, {10, 10, 10});
  const auto at = [&](const Vec3& by) { return test::together({box, test::moved(box, Mat3::Identity(), by)}); };
  EXPECT_NEAR(volumeOf(united(at({10, 0, 0}))), 2000.0, 1e-6);  // face on face
  EXPECT_NEAR(volumeOf(united(at({10, 5, 3}))), 2000.0, 1e-6);  // and shifted
  EXPECT_NEAR(volumeOf(united(at({0, 0, 0}))), 1000.0, 1e-6);   // the same twice
  EXPECT_NEAR(volumeOf(united(at({5, 0, 0}))), 1500.0, 1e-6);   // faces in one plane
  EXPECT_NEAR(volumeOf(united(at({0, 0, 5}))), 1500.0, 1e-6);
  expectSameInside(at({10, 5, 3}), united(at({10, 5, 3})), 25.0, 1000, test::Seed{3});
  for (const Vec3& by : {Vec3(10, 10, 0), Vec3(10, 10, 10), Vec3(10, 10, 4)}) {  // edge on edge, corner on corner
    Triangles made = at(by);
    const Outcome outcome = unite(made, kMin, kWide, {}).outcome;
    EXPECT_TRUE(outcome == Outcome::Made || outcome == Outcome::AsItWas);
    EXPECT_NEAR(volumeOf(made), 2000.0, 1e-6);
    EXPECT_TRUE(mesh::topologyOf(made.faces).is_closed);
  }
}

TEST(Union, OfPartsThatShareCornersIsClosed) {  // as a reader leaves them that joins corners at one place
  Triangles two = test::together({test::boxOf({0, 0, 0}, {10, 10, 10}), test::boxOf({10, 10, 0}, {20, 20, 10})});
  for (mesh::Face& face : two.faces) {
    for (std::int32_t& corner : face) {
      for (std::int32_t other = 0; other < corner; ++other) {
        if (cornerAt(two, other) == cornerAt(two, corner)) corner = other;
      }
    }
  }
  ASSERT_FALSE(mesh::topologyOf(two.faces).is_closed);
  const Triangles made = united(two);
  EXPECT_TRUE(mesh::topologyOf(made.faces).is_closed);
  EXPECT_NEAR(volumeOf(made), 2000.0, 1e-6);
}

TEST(Union, RefusesAnOpenMesh) {
  Triangles open = minCase();
  open.faces.pop_back();
  united(open, Outcome::Open);
}

TEST(Union, OfDrawnBodiesIsInsideWhereTheWindingNumberSaysSo) {
  test::Random random(test::Seed{20070601});
  for (int draw = 0; draw < test::dearSweep(200, 10'000); ++draw) {
    const Triangles given = test::drawnBody(random, draw % 3 == 0 ? 30 : 6);
    Triangles made = given;
    const Outcome outcome = unite(made, kMin, kWide, {}).outcome;
    ASSERT_TRUE(outcome == Outcome::Made || outcome == Outcome::AsItWas) << draw << ": " << static_cast<int>(outcome);
    expectSameInside(given, made, 35.0, 100, test::Seed{static_cast<std::uint64_t>(draw)});
    ASSERT_FALSE(testing::Test::HasFatalFailure()) << draw;
    // No target on an inner wall: before each face that is wide enough to say so is outside, behind it inside.
    for (std::size_t face = 0; face < made.faces.size(); face += 1 + made.faces.size() / 60) {
      const auto [a, b, c] = made.faces[face];
      const Vec3 p = cornerAt(made, a), q = cornerAt(made, b), r = cornerAt(made, c);
      const Vec3 area = (q - p).cross(r - p);
      const double longest = std::max({(q - p).norm(), (r - q).norm(), (p - r).norm()});
      if (area.norm() < 0.02 * longest) continue;
      const Vec3 middle = (p + q + r) / 3.0, off = 2e-3 * area.normalized();
      if (test::MeshOracle(given).distance(middle + off) < 1.9e-3 ||
          test::MeshOracle(given).distance(middle - off) < 1.9e-3)
        continue;
      ASSERT_LT(test::windingOf(given, middle + off), 0.5L) << draw << " face " << face;
      ASSERT_GT(test::windingOf(given, middle - off), 0.5L) << draw << " face " << face;
    }
  }
}

}  // namespace
}  // namespace underact::mesh_union
