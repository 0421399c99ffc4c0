// Meshes that are tangled or thin on purpose, from file to proxy.
#include <gtest/gtest.h>

#include <cmath>

#include "core/mesh/proxy.h"
#include "core/mesh_file/load.h"
#include "core/mesh_file/report.h"
#include "core/mesh_file/union_report.h"
#include "tests/core/mesh_file/some_meshes.h"
#include "tests/support/crossed_bodies.h"
#include "tests/support/mesh_oracle.h"
#include "tests/support/property.h"

namespace underact::mesh_file {
namespace {

using mesh::FreeSide;
using mesh::Triangles;

Loaded fromFile(const Triangles& triangles) {
  const test::ScratchFolder folder;
  return loadMesh(folder.write("m.stl", test::stlBinary(test::soup(triangles))), {}, Cache("/dev/null")).value();
}

bool isFelt(const Loaded& body, const Vec3& q, FreeSide free = FreeSide::Outside) {
  mesh::ProxyState state;
  return mesh::followProxy(*body.surface, free, q, state).face >= 0;
}

/// Its surface can be held to: the nearest point is that of the file's own faces.
void expectHeld(const Loaded& body, const Triangles& given) {
  EXPECT_FALSE(body.surface->is_closed);
  const test::MeshOracle oracle(given);
  test::Random random(test::Seed{20070604});
  for (int k = 0; k < 50; ++k) {
    const Vec3 q = random.inBox(30.0);
    mesh::SearchState state;
    const mesh::Hit hit = nearestPoint(*body.surface, mesh::Search::Global, q, state);
    EXPECT_NEAR(std::sqrt(hit.squared), oracle.distance(q), 1e-4);
  }
}

/// A grid of along x across corners on p(u, v), u and v from 0 to 1; u = 1 is u = 0 with v turned over.
template <class Place>
Triangles twistedGrid(int along, int across, bool closes, const Place& p) {
  Triangles made;
  const int rows = closes ? across : across + 1;
  for (int i = 0; i < along; ++i) {
    for (int j = 0; j < rows; ++j) made.p_MV.push_back(p(double(i) / along, double(j) / across).template cast<float>());
  }
  const auto corner = [&](int i, int j) {
    if (i == along) return closes ? (across - j % across) % across : across - j;
    return i * rows + (closes ? j % across : j);
  };
  for (int i = 0; i < along; ++i) {
    for (int j = 0; j < across; ++j) {
      const int a = corner(i, j), b = corner(i + 1, j), c = corner(i + 1, j + 1), d = corner(i, j + 1);
      made.faces.insert(made.faces.end(), {{a, b, c}, {a, c, d}});
    }
  }
  return made;
}

TEST(TangledMesh, AMoebiusStripHasNoOutsideAndIsHeldTo) {
  const Triangles strip = twistedGrid(48, 6, false, [](double u, double v) {
    const double angle = 2.0 * 3.14159265358979 * u, w = 8.0 * (v - 0.5);
    const double r = 20.0 + w * std::cos(0.5 * angle);
    return Vec3(r * std::cos(angle), r * std::sin(angle), w * std::sin(0.5 * angle));
  });
  const Loaded body = fromFile(strip);
  EXPECT_FALSE(allowsWalls(body.facts));
  EXPECT_NE(noWallsReason(body.facts), "");
  EXPECT_EQ(body.facts.inside, Inside::AsItIs);
  expectHeld(body, strip);
}

TEST(TangledMesh, AKleinBottleHasNoOutsideAndIsHeldTo) {
  const Triangles bottle = twistedGrid(60, 31, true, [](double u, double v) {
    const double a = 2.0 * 3.14159265358979 * u, b = 2.0 * 3.14159265358979 * v;
    const double s = std::sin(b), t = std::sin(2.0 * b), c = std::cos(0.5 * a), d = std::sin(0.5 * a);
    const double r = 20.0 + 6.0 * (c * s - d * t);
    return Vec3(r * std::cos(a), r * std::sin(a), 6.0 * (d * s + c * t));
  });
  const Loaded body = fromFile(bottle);
  EXPECT_EQ(body.facts.border_edges, 0);
  EXPECT_GT(body.facts.clashing_edges, 0);
  EXPECT_GT(body.facts.crossings, 0);
  EXPECT_FALSE(allowsWalls(body.facts));
  EXPECT_EQ(noWallsReason(body.facts), "its faces cannot agree on an outside");
  EXPECT_TRUE(crossingReport(body.facts).starts_with("The surface intersects itself, at "));
  expectHeld(body, bottle);
}

TEST(TangledMesh, AHollowBallIsFeltFromWithinItsHollowAndFromWithout) {
  const Triangles ball =
      test::together({test::roundOf(20.0, 3), test::turnedOver(test::roundOf(12.0, 3)), test::roundOf(4.0, 2)});
  const Loaded body = fromFile(ball);  // and a ball in the hollow
  EXPECT_EQ(body.facts.inside, Inside::AsItIs);
  EXPECT_EQ(body.facts.nested_parts, 2);
  EXPECT_EQ(body.facts.hollows, 1);
  EXPECT_FALSE(isFelt(body, {0, 0, 25}));
  EXPECT_TRUE(isFelt(body, {0, 0, 16}));
  EXPECT_FALSE(isFelt(body, {0, 0, 8}));
  EXPECT_TRUE(isFelt(body, {0, 0, 1}));
  EXPECT_TRUE(isFelt(body, {0, 0, 8}, FreeSide::Inside));
}

TEST(TangledMesh, AShellInAShellThatPointsOutwardsIsSwallowedAndThisIsSaid) {
  const Loaded body = fromFile(test::together({test::roundOf(20.0, 3), test::roundOf(12.0, 3)}));
  EXPECT_EQ(body.facts.inside, Inside::United);
  EXPECT_EQ(body.facts.felt_faces, 512);
  EXPECT_TRUE(isFelt(body, {0, 0, 8}));
  EXPECT_TRUE(crossingReport(body.facts).starts_with("Parts touch or contain each other."));
}

TEST(TangledMesh, ABodyWhoseFacesAreAllThereTwiceIsTheBody) {
  Triangles twice = test::boxOf({-10, -10, -10}, {10, 10, 10});
  twice.faces.insert(twice.faces.end(), twice.faces.begin(), twice.faces.end());
  const Loaded body = fromFile(twice);
  EXPECT_EQ(body.facts.duplicates, 12);
  EXPECT_TRUE(allowsWalls(body.facts));
  EXPECT_EQ(body.facts.felt_faces, 12);
  EXPECT_TRUE(isFelt(body, {0, 0, 0}));
  EXPECT_FALSE(isFelt(body, {0, 0, 11}));
}

TEST(TangledMesh, NeedlesThroughEachOtherAreOneStar) {
  std::vector<Triangles> needles;
  test::Random random(test::Seed{20070605});
  for (int k = 0; k < 24; ++k) {
    const Mat3 R = Eigen::AngleAxisd(random.between(0.0, 6.28), random.direction()).toRotationMatrix();
    needles.push_back(test::moved(test::boxOf({-25, -0.02, -0.02}, {25, 0.02, 0.02}), R, 0.1 * random.inBox(1.0)));
  }
  const Triangles given = test::together(needles);
  const Loaded body = fromFile(given);
  ASSERT_EQ(body.facts.inside, Inside::United) << noWallsReason(body.facts);
  const test::MeshOracle oracle(given);
  int inside = 0;
  for (int k = 0; k < 400; ++k) {
    const mesh::Face& face = given.faces[random.below(given.faces.size())];
    const Vec3 q = (cornerAt(given, face[0]) + cornerAt(given, face[1]) + cornerAt(given, face[2])) / 3.0 +
                   0.02 * random.direction();
    if (oracle.distance(q) < 1e-3) continue;
    const bool is_in = test::windingOf(given, q) > 0.5L;
    inside += is_in ? 1 : 0;
    EXPECT_EQ(isFelt(body, q), is_in) << q.transpose();
  }
  EXPECT_GT(inside, 50);
}

TEST(TangledMesh, ThatIsUnsureIsRefusedAsAWallInWords) {
  Facts facts;
  facts.faces = 12;
  EXPECT_TRUE(allowsWalls(facts));
  facts.inside = Inside::Unsure;
  EXPECT_FALSE(allowsWalls(facts));
  EXPECT_EQ(noWallsReason(facts), "it intersects itself too often to tell inside from outside");
}

/// Takes ten seconds; UnionOfManyParts tests the limits themselves.
TEST(TangledMesh, MoreIntersectionsThanTheLimitAreRefusedInWords) {
  if (!test::isSoak()) GTEST_SKIP() << "two million intersections take ten seconds: in the soak";
  std::vector<Triangles> boxes;
  test::Random random(test::Seed{20070606});
  for (int k = 0; k < 1500; ++k) {
    const Mat3 R = Eigen::AngleAxisd(random.between(0.0, 6.28), random.direction()).toRotationMatrix();
    boxes.push_back(test::moved(test::boxOf(Vec3::Constant(-10), Vec3::Constant(10)), R, random.inBox(1.0)));
  }
  const Loaded body = fromFile(test::together(boxes));
  EXPECT_EQ(body.facts.inside, Inside::Unsure);
  EXPECT_FALSE(body.surface->is_closed);
  EXPECT_EQ(noWallsReason(body.facts), "it intersects itself too often to tell inside from outside");
}

}  // namespace
}  // namespace underact::mesh_file
