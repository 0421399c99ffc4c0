#include <gtest/gtest.h>

#include "core/mesh/normals.h"
#include "core/mesh/proxy.h"
#include "core/mesh_union/union.h"
#include "tests/support/crossed_bodies.h"
#include "tests/support/mesh_oracle.h"
#include "tests/support/property.h"

namespace underact::mesh_union {
namespace {

using mesh::Surface;
using mesh::Triangles;

constexpr double kWeld = 1e-3;  // nearer to a face than some welds nothing is asked
constexpr double kStep = 0.05;  // mm in a tick: 0.05 m/s
constexpr double kDepth = 0.3;  // mm, behind both faces of a seam

std::shared_ptr<const Surface> surfaceOf(Triangles triangles) {
  const Outcome outcome = unite(triangles, 1e-5, 0.0, {}).outcome;
  EXPECT_TRUE(outcome == Outcome::Made || outcome == Outcome::AsItWas) << static_cast<int>(outcome);
  return mesh::asUnited(*mesh::makeSurface(std::move(triangles)).value());
}

/// An edge at which a hand can rest: its faces turn towards each other.
struct Seam {
  Vec3 middle, along, out;
  double length = 0.0;
};

std::vector<Seam> seamsOf(const Surface& surface) {
  std::vector<Seam> seams;
  for (std::int32_t face = 0; face < static_cast<std::int32_t>(surface.triangles.faces.size()); ++face) {
    const mesh::Corners corners = cornersOf(surface, face);
    const std::array<Vec3, 3> p{corners.a, corners.b, corners.c};
    for (std::size_t k = 0; k < 3; ++k) {
      const std::int32_t other = surface.neighbours[static_cast<std::size_t>(face)][k];
      if (other <= face) continue;
      const Vec3 n = normalOf(surface, face), m = normalOf(surface, other);
      const Vec3 a = p[k], b = p[(k + 1) % 3];
      const bool turns_in = n.cross(m).dot(b - a) < -0.2;  // of b - a as face goes around
      if (turns_in && (b - a).norm() > 3.0 && (n + m).norm() > 0.5)
        seams.push_back({0.5 * (a + b), (b - a).normalized(), (n + m).normalized(), (b - a).norm()});
    }
  }
  return seams;
}

/// Whether a point of that face has the outside before it, or, in a seam or a corner, between it and its neighbours.
bool isAtOutside(const Triangles& given, const Surface& surface, const Vec3& p, std::int32_t face) {
  const Vec3 n = normalOf(surface, face);
  for (int which = 0; which < 8; ++which) {
    Vec3 out = n;
    for (std::size_t k = 0; k < 3; ++k) {
      const std::int32_t other = surface.neighbours[static_cast<std::size_t>(face)][k];
      if ((which >> k) % 2 == 1 && other >= 0) out += normalOf(surface, other);
    }
    if (test::windingOf(given, p + 5.0 * kWeld * out.normalized()) < 0.5L) return true;
  }
  return false;
}

TEST(UnionSeams, ArePressedAndSlidAlongWithoutAStepOrAWayIn) {
  test::Random random(test::Seed{20070602});
  int seams = 0, ticks = 0;
  const int draws = test::dearSweep(40, 10'000);
  for (int draw = 0; draw < draws; ++draw) {
    const Triangles given = test::drawnBody(random, draw % 3 == 0 ? 30 : 6);
    const std::shared_ptr<const Surface> surface = surfaceOf(given);
    const test::MeshOracle oracle(given);
    for (const Seam& seam : seamsOf(*surface)) {
      mesh::ProxyState state;
      Vec3 last = Vec3::Zero();
      Vec3 held = Vec3::Zero();
      bool was_touched = false;
      const auto tick = [&](const Vec3& q) {
        const mesh::Hit hit = mesh::followProxy(*surface, mesh::FreeSide::Outside, q, state);
        const Vec3 offset = hit.face >= 0 ? Vec3(hit.p_M - q) : Vec3(Vec3::Zero());
        if (++ticks % 7 == 0 && oracle.distance(q) > kWeld) {
          EXPECT_EQ(hit.face >= 0, test::windingOf(given, q) > 0.5L)
              << draw << " seam " << seam.middle.transpose() << " at " << q.transpose();
        }
        if (was_touched) {
          EXPECT_LT((offset - last).norm(), 1.5 * kStep + 1e-3)
              << draw << " seam " << seam.middle.transpose() << " at " << q.transpose();
        }
        last = offset;
        held = hit.p_M;
        was_touched = true;
      };
      // What else is there within reach of the way makes it another; so does a narrow gap, where it begins inside.
      const Vec3 start = seam.middle + 2.0 * kDepth * seam.out;
      if (oracle.distance(start) < 1.2 * kDepth || test::windingOf(given, start) > 0.5L) continue;
      // Bodies that meet in an edge alone have the outside behind it as well.
      if (test::windingOf(given, seam.middle - kDepth * seam.out) < 0.5L) continue;
      for (double height = 2.0 * kDepth; height > -kDepth; height -= kStep) tick(seam.middle + height * seam.out);
      // A seam beside this one caught the tip: it would slide along that one, and off its end. A wall all the same.
      if (last.norm() > kDepth + 2.0 * kWeld) {
        EXPECT_TRUE(isAtOutside(given, *surface, held, state.face)) << draw << " at " << held.transpose();
        continue;
      }
      ++seams;
      for (int step = 0; step * kStep < 0.35 * seam.length; ++step) {
        const auto at = [&](int k) -> Vec3 { return seam.middle - kDepth * seam.out + k * kStep * seam.along; };
        // Where another wall comes near from behind, the tip leaves through that one, and the proxy holds on.
        if (oracle.distance(at(step)) < kStep) break;
        if (step % 5 == 0 && test::windingOf(given, at(step + 5)) < 0.5L) break;
        tick(at(step));
      }
      if (testing::Test::HasFailure()) return;
    }
  }
  EXPECT_GT(seams, 2 * draws);
}

/// A tip of which nobody knows where it came from.
TEST(UnionSeams, AFirstTipIsPushedOutWhereItIsInside) {
  test::Random random(test::Seed{20070603});
  for (int draw = 0; draw < test::dearSweep(200, 10'000); ++draw) {
    const Triangles given = test::drawnBody(random, draw % 3 == 0 ? 30 : 6);
    const std::shared_ptr<const Surface> surface = surfaceOf(given);
    const test::MeshOracle oracle(given);
    for (int k = 0; k < 60; ++k) {
      Vec3 q = random.inBox(30.0);
      if (k % 2 == 0) {  // near the faces
        const mesh::Face& face = given.faces[random.below(given.faces.size())];
        q = (cornerAt(given, face[0]) + cornerAt(given, face[1]) + cornerAt(given, face[2])) / 3.0 +
            random.between(0.0, 0.5) * random.direction();
      }
      if (oracle.distance(q) < kWeld) continue;
      const bool is_in = test::windingOf(given, q) > 0.5L;
      mesh::ProxyState outside, inside;
      ASSERT_EQ(mesh::followProxy(*surface, mesh::FreeSide::Outside, q, outside).face >= 0, is_in)
          << draw << " " << q.transpose();
      ASSERT_EQ(mesh::followProxy(*surface, mesh::FreeSide::Inside, q, inside).face >= 0, !is_in)
          << draw << " " << q.transpose();
    }
  }
}

}  // namespace
}  // namespace underact::mesh_union
