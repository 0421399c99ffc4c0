// Bodies of very many parts.
#include <gtest/gtest.h>

#include <atomic>

#include "core/mesh/topology.h"
#include "core/mesh_union/union.h"
#include "tests/support/crossed_bodies.h"
#include "tests/support/property.h"

namespace underact::mesh_union {
namespace {

using mesh::Triangles;

/// n x n x n tetrahedra, 1 apart; those of size 1.5 reach into their neighbours.
Triangles tetrahedra(int n, float size) {
  Triangles all;
  for (int k = 0; k < n * n * n; ++k) {
    const auto first = static_cast<std::int32_t>(all.p_MV.size());
    const Eigen::Vector3f at(static_cast<float>(k % n), static_cast<float>(k / n % n), static_cast<float>(k / n / n));
    for (int corner = 0; corner < 4; ++corner) {
      Eigen::Vector3f p = at;
      if (corner > 0) p[corner - 1] += size;
      all.p_MV.push_back(p);
    }
    for (const mesh::Face& face : {mesh::Face{0, 2, 1}, {0, 1, 3}, {0, 3, 2}, {1, 2, 3}})
      all.faces.push_back({face[0] + first, face[1] + first, face[2] + first});
  }
  return all;
}

/// 8000 parts, and a million in a soak.
TEST(UnionOfManyParts, ThatAreApartIsWhatTheyWere) {
  Triangles made = tetrahedra(test::sweep(20, 100), 0.75F);
  const Triangles given = made;
  EXPECT_EQ(unite(made, 1e-6, 1e-6, {}).outcome, Outcome::AsItWas);
  EXPECT_EQ(made.faces, given.faces);
}

TEST(UnionOfManyParts, ThatIntersectIsClosedOrRefused) {
  const int n = test::sweep(8, 100);
  Triangles made = tetrahedra(n, 1.5F);
  const Union done = unite(made, 1e-6, 0.0, {});
  if (done.outcome == Outcome::TooMuch) {
    EXPECT_GT(n, 30);
    return;
  }
  ASSERT_EQ(done.outcome, Outcome::Made) << static_cast<int>(done.outcome);
  EXPECT_TRUE(mesh::topologyOf(made.faces).is_closed);
  test::Random random(test::Seed{1});
  const Triangles given = tetrahedra(n, 1.5F);
  for (int k = 0; k < 50; ++k) {
    const Vec3 q = Vec3::Constant(0.5 * n) + random.inBox(0.45 * n);
    const double now = static_cast<double>(test::windingOf(made, q));
    EXPECT_NEAR(now, test::windingOf(given, q) > 0.5L ? 1.0 : 0.0, 1e-6) << q.transpose();
  }
}

TEST(UnionOfManyParts, BeyondTheLimitsAreRefusedAndLeftAsTheyWere) {
  Triangles made = tetrahedra(8, 1.5F);
  const Triangles given = made;
  const Union refused = unite(made, 1e-6, 0.0, {}, {10'000'000, 1000});
  EXPECT_EQ(refused.outcome, Outcome::TooMuch);
  EXPECT_GE(refused.crossings, 1000);  // so that a wall is refused where the reader has not looked for them
  EXPECT_EQ(unite(made, 1e-6, 0.0, {}, {1000, 10'000'000}).outcome, Outcome::TooMuch);
  EXPECT_EQ(made.p_MV, given.p_MV);
  EXPECT_EQ(made.faces, given.faces);
}

TEST(UnionOfManyParts, EndsSoonWhenItIsCancelled) {
  Triangles made = tetrahedra(10, 1.5F);
  const Triangles given = made;
  const std::atomic<bool> cancelled{true};
  TaskMonitor monitor;
  monitor.cancelled = &cancelled;
  EXPECT_EQ(unite(made, 1e-6, 0.0, monitor).outcome, Outcome::Cancelled);
  EXPECT_EQ(made.p_MV, given.p_MV);
}

}  // namespace
}  // namespace underact::mesh_union
