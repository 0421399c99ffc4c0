#include <gtest/gtest.h>

#include <cmath>

#include "core/control/law.h"
#include "core/target/constraint.h"
#include "tests/support/constraint_vectors.h"
#include "tests/support/shape_oracle.h"

namespace underact::target {
namespace {

using test::Random;
using test::ShapeOracle;

const shape::Shape kSphere = shape::makeSphere({0.01, 0.02, 0.03}, 0.05, {}).value();
const Vec3 kEqualGains = Vec3::Constant(500.0);

TEST(Target, AWallIsFreeOnItsSideAndHoldsOnTheOther) {
  const Vec3 outside = {0.01, 0.02, 0.09}, inside = {0.01, 0.02, 0.07}, on = {0.01, 0.02, 0.08};
  const NearestOnShape ball = nearestOn(kSphere, kEqualGains);
  for (const auto& [side, free, held] : {std::tuple{Side::Outside, outside, inside}, {Side::Inside, inside, outside}}) {
    EXPECT_EQ(nearestTarget(ball, side, free).status, Status::Free);
    EXPECT_EQ(nearestTarget(ball, side, free).p_WP, free);
    EXPECT_EQ(nearestTarget(ball, side, free).distance_m, 0.0);
    EXPECT_EQ(nearestTarget(ball, side, held).status, Status::Unique);
    EXPECT_NEAR(nearestTarget(ball, side, held).distance_m, 0.01, 1e-16);
    EXPECT_LE((nearestTarget(ball, side, held).p_WP - on).norm(), 1e-16);
  }
  EXPECT_EQ(nearestTarget(ball, Side::Both, outside).status, Status::Unique);
  EXPECT_EQ(nearestTarget(ball, Side::Both, inside).status, Status::Unique);
}

TEST(Target, ExactlyOnAWallIsFree) {
  const shape::Shape floor = shape::makePlane({0, 0, 0}, {0, 1, 0}, {}).value();
  EXPECT_EQ(nearestTarget(nearestOn(floor, kEqualGains), Side::Outside, {0.1, 0, 0.2}).status, Status::Free);
  EXPECT_EQ(nearestTarget(nearestOn(floor, kEqualGains), Side::Inside, {0.1, 0, 0.2}).status, Status::Free);
  EXPECT_EQ(nearestTarget(nearestOn(floor, kEqualGains), Side::Both, {0.1, 0, 0.2}).status, Status::Unique);
}

TEST(Target, TheMiddleOfAWallIsFreeFromInsideAndDegenerateFromOutside) {
  const Vec3 middle(0.01, 0.02, 0.03);
  EXPECT_EQ(nearestTarget(nearestOn(kSphere, kEqualGains), Side::Inside, middle).status, Status::Free);
  for (const Side side : {Side::Both, Side::Outside}) {
    const Target target = nearestTarget(nearestOn(kSphere, kEqualGains), side, middle);
    EXPECT_EQ(target.status, Status::Degenerate);
    EXPECT_EQ(target.p_WP, middle);
    EXPECT_NEAR(target.distance_m, 0.05, 1e-17);
  }
}

TEST(Target, EqualGainsAreTheEuclideanMetricToTheLastBit) {
  Random random(test::Seed{20070801});
  for (int draw = 0; draw < test::sweep(2000, 100000) / 4; ++draw) {
    for (const ShapeOracle& one : test::everyShape(random)) {
      const Vec3 p_WT = random.inBox(0.2);
      const NearestOnShape held = nearestOn(one.plain, Vec3::Constant(random.between(0.0, 1e4)));
      ASSERT_FALSE(held.weighted);
      const Target target = nearestTarget(held, Side::Both, p_WT);
      const shape::Nearest nearest = closestPoint(one.plain, p_WT);
      ASSERT_EQ(target.p_WP, nearest.p_WP);
      ASSERT_EQ(target.distance_m, std::abs(nearest.height_m));
    }
  }
}

TEST(Target, OneGainThatDiffersIsEnoughForTheMetric) {
  for (const Vec3& stiffness : {Vec3(1, 1, 2), Vec3(1, 2, 2), Vec3(2, 1, 2)}) {
    EXPECT_TRUE(nearestOn(kSphere, stiffness).weighted) << stiffness.transpose();
  }
}

TEST(Target, APointIsTheSameInEveryMetric) {
  const shape::Shape point = shape::makePoint({0.1, 0.2, 0.3}, {}).value();
  const NearestOnShape held = nearestOn(point, {1.0, 0.0, 5.0});
  EXPECT_FALSE(held.weighted);
  EXPECT_EQ(nearestTarget(held, Side::Both, {0, 0, 0}).p_WP, Vec3(0.1, 0.2, 0.3));
}

/// ½ e^T K e, what the weighted nearest point makes least.
double energyOf(const Vec3& stiffness, const Vec3& e_W) {
  return 0.5 * e_W.dot(stiffness.cwiseProduct(e_W));
}

TEST(Target, WithUnequalGainsNoPointOfTheShapeHasLessEnergy) {
  Random random(test::Seed{20070802});
  for (int draw = 0; draw < test::sweep(2000, 100000) / 4; ++draw) {
    const Vec3 stiffness(random.between(100, 2000), random.between(100, 2000), random.between(100, 2000));
    for (const ShapeOracle& one : test::everyShape(random)) {
      if (one.scale != Vec3::Ones()) continue;  // nearestOn() scales the plain ones itself
      const Vec3 p_WT = random.inBox(0.2);
      const Target target = nearestTarget(nearestOn(one.plain, stiffness), Side::Both, p_WT);
      if (target.status != Status::Unique) continue;
      ASSERT_NEAR(one.off(target.p_WP), 0.0, 1e-12) << one.name;  // as in nearest_test
      ASSERT_NEAR(target.distance_m, (target.p_WP - p_WT).norm(), 1e-15);
      const double energy = energyOf(stiffness, target.p_WP - p_WT);
      for (int k = 0; k < 200; ++k) {  // any point at all, and points beside it
        const test::Patch& patch = one.patches[random.below(one.patches.size())];
        const Vec3 other =
            patch.at(random.between(-patch.a_half, patch.a_half), random.between(-patch.b_half, patch.b_half));
        ASSERT_LE(energy, energyOf(stiffness, other - p_WT) + 1e-12) << one.name;  // J: 1e-12 m of 1 N
      }
    }
  }
}

TEST(Target, WithUnequalGainsTheForceHasNoPartAlongTheConstraint) {  // errata: the stylus creeps where it has
  const Vec3 stiffness(1000.0, 250.0, 500.0);
  Random random(test::Seed{20070803});
  for (int draw = 0; draw < test::sweep(2000, 100000); ++draw) {
    const Vec3 c = random.inBox(0.1), n = random.direction(), p_WT = random.inBox(0.2);
    const double r = random.between(0.01, 0.1);
    const auto along = [&](const shape::Shape& shape, const auto& tangents) {
      const Target target = nearestTarget(nearestOn(shape, stiffness), Side::Both, p_WT);
      control::LawState state;
      const Vec3 f_T_W = control::force(control::P{stiffness}, state, target.p_WP - p_WT, {});
      double max_N = 0.0;
      for (const Vec3& tangent : tangents(target.p_WP)) max_N = std::max(max_N, std::abs(f_T_W.dot(tangent)));
      return max_N;
    };
    // 1000 N/m times the 1e-12 m that nearest_test allows.
    constexpr double kRound_N = 1e-9;
    const auto across = [&](const Vec3& normal) {
      return std::array<Vec3, 2>{normal.unitOrthogonal(), normal.cross(normal.unitOrthogonal()).normalized()};
    };
    ASSERT_LE(along(shape::Line{c, n}, [&](const Vec3&) { return std::array<Vec3, 1>{n}; }), kRound_N);
    ASSERT_LE(along(shape::Plane{c, n}, [&](const Vec3&) { return across(n); }), kRound_N);
    ASSERT_LE(along(shape::Sphere{c, r}, [&](const Vec3& q) { return across((q - c).normalized()); }), kRound_N);
    ASSERT_LE(
        along(shape::Circle{c, n, r}, [&](const Vec3& q) { return std::array<Vec3, 1>{n.cross(q - c).normalized()}; }),
        kRound_N);
    ASSERT_LE(along(shape::Cylinder{c, n, r},
                    [&](const Vec3& q) { return across(Vec3(q - c - (q - c).dot(n) * n).normalized()); }),
              kRound_N);
  }
}

TEST(Target, WithUnequalGainsAWallHasTheSameSides) {
  Random random(test::Seed{20070804});
  for (int draw = 0; draw < test::sweep(2000, 100000) / 4; ++draw) {
    for (const ShapeOracle& one : test::everyShape(random)) {
      const Vec3 p_WT = random.inBox(0.2);
      if (!one.has_sides || std::abs(one.off(p_WT)) < 1e-12 || one.scale != Vec3::Ones()) continue;
      const bool free =
          nearestTarget(nearestOn(one.plain, {900, 300, 100}), Side::Outside, p_WT).status == Status::Free;
      ASSERT_EQ(free, one.off(p_WT) > 0.0) << one.name;
    }
  }
}

TEST(Target, TheThesissOwnForceCreepsAndOursDoesNot) {  // the golden `anisotropic` line, first case
  for (const test::GoldenSet& set : test::constraintVectors().anisotropic) {
    if (set.shape.type != "line") continue;
    const Vec3 along = set.shape.direction.normalized();
    EXPECT_GT(std::abs(set.cases[0].force.dot(along)), 1.0);
    const shape::Shape line = test::makeShape(set.shape, 1.0).value();
    const Target target = nearestTarget(nearestOn(line, set.cases[0].kp), Side::Both, set.cases[0].P);
    const Vec3 f = set.cases[0].kp.cwiseProduct(target.p_WP - set.cases[0].P);
    EXPECT_NEAR(f.dot(along), 0.0, set.cases[0].tol_F);
  }
}

TEST(Target, OnlyTheRatioOfTheGainsCounts) {
  const Vec3 p_WT(0.1, -0.05, 0.02);
  const Target one = nearestTarget(nearestOn(kSphere, {1, 0.25, 0.5}), Side::Both, p_WT);
  const Target other = nearestTarget(nearestOn(kSphere, {1e6, 0.25e6, 0.5e6}), Side::Both, p_WT);
  EXPECT_EQ(one.p_WP, other.p_WP);
}

TEST(Target, HasTheWordsOfTheCommandLine) {
  EXPECT_STREQ(name(Status::Unique), "unique");
  EXPECT_STREQ(name(Status::Degenerate), "degenerate");
  EXPECT_STREQ(name(Status::Free), "free");
}

}  // namespace
}  // namespace underact::target
