#include <gtest/gtest.h>

#include "core/shape/shape.h"
#include "tests/support/shape_oracle.h"

// What every alternative of Shape promises, over shapes and tips at random.
namespace underact::shape {
namespace {

using test::everyShape;
using test::Random;
using test::ShapeOracle;

// Promised: 64 ulp of the largest coordinate (0.5 m: 7e-15) and near an axis R / off_axis times more. Within 1e-3 of
// the middle the sweep says nothing (the degenerate tests do), so 1e3 times; a scale down to 0.2 divides once or twice
// by it.
constexpr double kRound_m = 1e-12;

/// The distance to the middle region where the nearest point turns over fast, told by two near tips: oracle only.
bool isSmooth(const ShapeOracle& one, const Vec3& p_WT, const Nearest& nearest) {
  for (const Vec3& step : {Vec3(1e-6, 0, 0), Vec3(0, 1e-6, 0), Vec3(0, 0, 1e-6)}) {
    const Nearest beside = closestPoint(one.shape, p_WT + step);
    if (beside.status != Status::Unique || (beside.p_WP - nearest.p_WP).norm() > 1e-3) return false;
  }
  return nearest.status == Status::Unique;
}

void sweepAll(int draws, std::uint64_t seed,
              const std::function<void(const ShapeOracle&, const Vec3&, const Nearest&)>& check) {
  Random random(test::Seed{seed});
  int used = 0, seen = 0;
  for (int draw = 0; draw < draws; ++draw) {
    for (const ShapeOracle& one : everyShape(random)) {
      const Vec3 p_WT = random.inBox(0.2);
      const Nearest nearest = closestPoint(one.shape, p_WT);
      ++seen;
      if (!isSmooth(one, p_WT, nearest)) continue;
      ++used;
      check(one, p_WT, nearest);
      if (::testing::Test::HasFatalFailure()) {
        ADD_FAILURE() << one.name << ", draw " << draw << ", tip " << p_WT.transpose();
        return;
      }
    }
  }
  EXPECT_GT(used, seen * 98 / 100);  // all but the tips beside a middle
}

TEST(ShapeNearest, LiesOnTheShape) {
  sweepAll(test::sweep(2000, 100000), 20070601, [](const ShapeOracle& one, const Vec3&, const Nearest& nearest) {
    ASSERT_NEAR(one.off(nearest.p_WP.cwiseQuotient(one.scale)), 0.0, kRound_m);
  });
}

TEST(ShapeNearest, NoPointOfTheShapeIsNearer) {
  sweepAll(
      test::sweep(2000, 100000) / 4, 20070602, [](const ShapeOracle& one, const Vec3& p_WT, const Nearest& nearest) {
        const double distance_m = (nearest.p_WP - p_WT).norm();
        const double found_m = searchDistance(one, p_WT);
        ASSERT_LE(distance_m, found_m + kRound_m);
        // The search stops at 1e-9 of its range: with the point on the shape this says the search found the same basin.
        ASSERT_GE(distance_m, found_m - 1e-6) << "the oracle's own search has failed, or the point is not of the shape";
      });
}

TEST(ShapeNearest, ErrorIsAcrossTheShape) {  // a step along the shape changes the distance in second order only
  sweepAll(test::sweep(2000, 100000), 20070603, [](const ShapeOracle& one, const Vec3& p_WT, const Nearest& nearest) {
    if (std::string(one.name) == "box" || std::string(one.name) == "parallelepiped")
      return;  // edges: by the search above
    const Vec3 e_W = nearest.p_WP - p_WT;
    if (one.patches.front().b_half > 0.0) {
      // Two parameters: the error is along the gradient of off(), by differences of 1e-7 m, good to 1e-7 / 0.01 m.
      const Vec3 q = nearest.p_WP.cwiseQuotient(one.scale);
      Vec3 normal;
      for (Eigen::Index i = 0; i < 3; ++i) {
        const Vec3 h = 1e-6 * Vec3::Unit(i);
        normal[i] = (one.off(q + h) - one.off(q - h)) / 2e-6 / one.scale[i];
      }
      ASSERT_LE(e_W.cross(normal.normalized()).norm(), 1e-7 * (e_W.norm() + 1e-3));
    } else if (one.patches.front().a_half > 0.0) {
      // One parameter: find it, and take the chord about it as the tangent.
      double best = kInfinity, at = 0.0;
      const auto& patch = one.patches.front();
      for (double width = patch.a_half, centre = 0.0; width > 1e-9; width /= 8.0, centre = at) {
        for (int k = -16; k <= 16; ++k) {
          const double a = centre + width * k / 16.0, square = (patch.at(a, 0.0) - nearest.p_WP).squaredNorm();
          if (square < best) best = square, at = a;
        }
      }
      const Vec3 tangent = (patch.at(at + 1e-4, 0.0) - patch.at(at - 1e-4, 0.0)).normalized();
      ASSERT_LE(std::abs(e_W.dot(tangent)), 1e-6 * (e_W.norm() + 1e-3));
    }
  });
}

TEST(ShapeNearest, HeightIsTheDistanceWithTheSignOfTheSide) {
  sweepAll(test::sweep(2000, 100000), 20070604, [](const ShapeOracle& one, const Vec3& p_WT, const Nearest& nearest) {
    ASSERT_NEAR(std::abs(nearest.height_m), (nearest.p_WP - p_WT).norm(), kRound_m);
    const double off_m = one.off(p_WT.cwiseQuotient(one.scale));
    ASSERT_EQ(hasSides(one.shape), one.has_sides);
    if (!one.has_sides) {
      ASSERT_GE(nearest.height_m, 0.0);
    } else if (std::abs(off_m) > kRound_m) {
      ASSERT_EQ(nearest.height_m < 0.0, off_m < 0.0);
    }
  });
}

TEST(ShapeNearest, ATipOnTheShapeStaysThere) {
  Random random(test::Seed{20070605});
  for (int draw = 0; draw < test::sweep(2000, 100000); ++draw) {
    for (const ShapeOracle& one : everyShape(random)) {
      const test::Patch& patch = one.patches[random.below(one.patches.size())];
      const Vec3 p_WT =
          patch.at(random.between(-patch.a_half, patch.a_half), random.between(-patch.b_half, patch.b_half));
      const Nearest nearest = closestPoint(one.shape, p_WT);
      ASSERT_EQ(nearest.status, Status::Unique) << one.name;
      ASSERT_LE((nearest.p_WP - p_WT).norm(), kRound_m) << one.name << " " << p_WT.transpose();
      ASSERT_LE(std::abs(nearest.height_m), kRound_m) << one.name;
    }
  }
}

TEST(ShapeNearest, TheNearestPointOfTheNearestPointIsItself) {
  sweepAll(test::sweep(2000, 100000), 20070606, [](const ShapeOracle& one, const Vec3&, const Nearest& nearest) {
    ASSERT_LE((closestPoint(one.shape, nearest.p_WP).p_WP - nearest.p_WP).norm(), kRound_m);
  });
}

}  // namespace
}  // namespace underact::shape
