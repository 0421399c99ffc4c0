#include <gtest/gtest.h>

#include <cmath>

#include "core/shape/shape.h"
#include "tests/support/shape_oracle.h"

// Where a formula divides by nothing, overflows, or is fed what no arm sends.
namespace underact::shape {
namespace {

using test::everyShape;
using test::Random;
using test::ShapeOracle;

const Vec3 kC{0.010, 0.020, 0.030};

std::vector<Shape> middles() {  // shapes with an axis or a centre in kC
  std::vector<Shape> all{makeSphere(kC, 0.04, {}).value(), makeCircle(kC, {-1, 1, -1}, 0.04, {}).value(),
                         makeCylinder(kC, {-1, 1, -1}, 0.04, {}).value(),
                         makeBox(kC, {0.06, 0.06, 0.06}, Mat3::Identity(), {}).value()};
  for (std::size_t i = 0; i < 4; ++i) all.push_back(scaled(all[i], {1.0, 1.0, 1.0}));
  return all;
}

TEST(ShapeExtremes, InTheMiddleNothingIsNearest) {
  for (const Shape& shape : middles()) {
    const Nearest nearest = closestPoint(shape, kC);
    EXPECT_EQ(nearest.status, Status::NotUnique) << shape.index();
    EXPECT_EQ(nearest.p_WP, kC) << shape.index();
    EXPECT_NEAR(std::abs(nearest.height_m), shape.index() == 6 || shape.index() == 10 ? 0.03 : 0.04, 1e-16)
        << shape.index();
  }
}

TEST(ShapeExtremes, OnTheAxisTheDistanceIsThatOfEveryPoint) {
  const Vec3 axis_W = Vec3(-1, 1, -1).normalized();
  const Nearest circle = closestPoint(makeCircle(kC, axis_W, 0.04, {}).value(), kC + 0.03 * axis_W);
  EXPECT_EQ(circle.status, Status::NotUnique);
  EXPECT_NEAR(circle.height_m, 0.05, 1e-16);
  const Nearest cylinder = closestPoint(makeCylinder(kC, axis_W, 0.04, {}).value(), kC + 0.03 * axis_W);
  EXPECT_EQ(cylinder.status, Status::NotUnique);
  EXPECT_NEAR(cylinder.height_m, -0.04, 1e-16);
}

TEST(ShapeExtremes, OnTheLongAxisOfAnEllipsoidTheDistanceIsThatOfTheTwoMirroredPoints) {
  // By hand, semi axes 2 and 1, tip at 0.75 on the long one: x = 4 * 0.75 / 3 = 1, y = +-sqrt(1 - 1/4); distance^2 =
  // 1/16 + 3/4.
  const double by_hand = std::sqrt(0.8125);
  const Nearest ellipsoid = closestPoint(Ellipsoid{Vec3::Zero(), {2, 1, 1}}, {0.75, 0, 0});
  EXPECT_EQ(ellipsoid.status, Status::NotUnique);
  EXPECT_NEAR(ellipsoid.height_m, -by_hand, 4e-16);
  const Ellipse ellipse{Vec3::Zero(), {1, 0, 0}, {0, 1, 0}, {0, 0, 1}, 2.0, 1.0};
  EXPECT_EQ(closestPoint(ellipse, {0.75, 0, 0}).status, Status::NotUnique);
  EXPECT_NEAR(closestPoint(ellipse, {0.75, 0, 0}).height_m, by_hand, 4e-16);
  EXPECT_NEAR(closestPoint(ellipse, {0.75, 0, 3}).height_m, std::sqrt(0.8125 + 9.0), 8e-16);
  EXPECT_EQ(closestPoint(EllipticCylinder{ellipse}, {0.75, 0, 3}).status, Status::NotUnique);
  EXPECT_NEAR(closestPoint(EllipticCylinder{ellipse}, {0.75, 0, 3}).height_m, -by_hand, 4e-16);
}

TEST(ShapeExtremes,
     AMillimetreE12OffTheAxisTheNearestPointIsThere) {  // errata 4: 0.07 mm off where one projection is left out
  const Vec3 axis_W = Vec3(-1, 1, -1).normalized(), across_W = axis_W.unitOrthogonal();
  const Circle circle = makeCircle(Vec3::Zero(), axis_W, 0.04, {}).value();
  const Cylinder cylinder = makeCylinder(Vec3::Zero(), axis_W, 0.04, {}).value();
  for (const double off_m : {1e-15, 1e-12, 1e-9, 1e-6}) {
    for (const double along_m : {0.0, 0.004}) {
      const Vec3 p_WT = along_m * axis_W + off_m * across_W;
      // The tip itself is rounded to ulp(0.004) = 9e-19 m: its direction from the axis turns by that over off_m, and so
      // P.
      const double allowed_m = 64 * 0x1p-52 * 0.04 + 8 * 0.04 * 0x1p-52 * along_m / off_m;
      const Nearest on_circle = closestPoint(circle, p_WT), on_cylinder = closestPoint(cylinder, p_WT);
      ASSERT_EQ(on_circle.status, Status::Unique);
      ASSERT_EQ(on_cylinder.status, Status::Unique);
      EXPECT_LE((on_circle.p_WP - 0.04 * across_W).norm(), allowed_m) << off_m << " " << along_m;
      EXPECT_LE((on_cylinder.p_WP - 0.04 * across_W - along_m * axis_W).norm(), allowed_m) << off_m << " " << along_m;
      // Rounded or not, it is a point of the shape. One projection alone leaves it out of the plane by 1e-3 of the
      // radius.
      EXPECT_NEAR(on_circle.p_WP.dot(axis_W), 0.0, 4 * 0x1p-52 * 0.04) << off_m << " " << along_m;
      EXPECT_NEAR(on_circle.p_WP.norm(), 0.04, 4 * 0x1p-52 * 0.04);
      EXPECT_NEAR(on_cylinder.p_WP.dot(axis_W), along_m, 4 * 0x1p-52 * 0.04);
    }
  }
}

TEST(ShapeExtremes, ThePlacesRoundingCountsWhicheverOfThemIsLarger) {
  const Circle circle = makeCircle({0.3, 0.3, 0.3}, {1, 1, 1}, 0.04, {}).value();
  const Cylinder cylinder = makeCylinder({0.3, 0.3, 0.3}, {1, 1, 1}, 0.04, {}).value();
  for (const Vec3& p_WT : {Vec3(1e-16, 0, 0), Vec3(0.4, 0.4 + 1e-16, 0.4)}) {
    EXPECT_EQ(closestPoint(circle, p_WT).status, Status::NotUnique);
    EXPECT_EQ(closestPoint(cylinder, p_WT).status, Status::NotUnique);
    EXPECT_EQ(closestPoint(circle, p_WT + Vec3(1e-14, 0, 0)).status, Status::Unique);
    EXPECT_EQ(closestPoint(cylinder, p_WT + Vec3(1e-14, 0, 0)).status, Status::Unique);
  }
}

TEST(ShapeExtremes, GainsOfAMillionMillionToOneLeaveTheSectionAcrossItsAxis) {  // one projection leaves it 1e-10 askew
  const Vec3 scale(1.0, 1e-6, 1e-6), axis_W = Vec3(1, 1, 0).normalized();
  const EllipticCylinder cylinder = scaled(Cylinder{kC, axis_W, 0.04}, scale);
  const Vec3 scaled_axis_W = scale.cwiseProduct(axis_W).normalized();
  EXPECT_LE(cylinder.section.axis_W.cross(scaled_axis_W).norm(), 4 * 0x1p-52);
}

TEST(ShapeExtremes, CloserThanItsRoundingToTheAxisIsOnTheAxis) {
  const Circle circle = makeCircle(Vec3::Zero(), {0, 0, 1}, 0.04, {}).value();
  EXPECT_EQ(closestPoint(circle, {1e-18, 0, 0.1}).status, Status::NotUnique);
  EXPECT_EQ(closestPoint(circle, {1e-15, 0, 0.1}).status, Status::Unique);
  EXPECT_EQ(closestPoint(circle, {1e-151, 0, 0}).status, Status::NotUnique);
  EXPECT_EQ(closestPoint(circle, {1e-140, 0, 0}).status, Status::Unique);
  EXPECT_EQ(closestPoint(Sphere{Vec3::Zero(), 0.04}, {1e-151, 0, 0}).status, Status::NotUnique);
  EXPECT_EQ(closestPoint(Sphere{Vec3::Zero(), 0.04}, {0, 1e-140, 0}).p_WP, Vec3(0, 0.04, 0));
}

TEST(ShapeExtremes, FiniteInFiniteOut) {  // up to 1e100, where a square is still a number
  const std::vector<double> sizes{0.0,    -0.0,  5e-324, -5e-324, 1e-310, 1e-300, 1e-200, 1e-151, 1e-150,
                                  1e-100, 1e-16, 1e-15,  1e-12,   1e-9,   1e-6,   1e-3,   0.04,   0.1,
                                  1.0,    1e3,   1e9,    1e12,    1e50,   1e77,   -1e99,  1e100,  -1e100};
  Random random(test::Seed{20070611});
  for (int draw = 0; draw < test::sweep(2000, 100000) / 20; ++draw) {
    std::vector<ShapeOracle> all = everyShape(random);
    for (const ShapeOracle& one : all) {
      for (int k = 0; k < 40; ++k) {
        const Vec3 p_WT(sizes[random.below(sizes.size())], sizes[random.below(sizes.size())],
                        sizes[random.below(sizes.size())]);
        const Nearest nearest = closestPoint(one.shape, p_WT);
        ASSERT_TRUE(nearest.p_WP.allFinite()) << one.name << " " << p_WT.transpose();
        ASSERT_TRUE(std::isfinite(nearest.height_m)) << one.name << " " << p_WT.transpose();
        if (nearest.status == Status::NotUnique) {
          ASSERT_EQ(nearest.p_WP, p_WT) << one.name;
        }
      }
    }
  }
}

TEST(ShapeExtremes, AboutTheOriginFiniteInFiniteOut) {  // no centre to hide a tiny coordinate behind
  const std::vector<double> sizes{0.0,    5e-324, -1e-310, 1e-300, 1e-200, 1e-155, 1e-151,
                                  1e-100, 1e-17,  1e-9,    0.04,   1e12,   1e100};
  const Vec3 scale(1.0, 0.5, 0.7), zero = Vec3::Zero();
  std::vector<Shape> all{Sphere{zero, 0.04},
                         Circle{zero, {0, 0, 1}, 0.04},
                         Cylinder{zero, {0, 1, 0}, 0.04},
                         makeBox(zero, {0.06, 0.02, 0.04}, Mat3::Identity(), {}).value(),
                         Line{zero, {1, 0, 0}},
                         Plane{zero, {0, 0, 1}}};
  for (std::size_t i = 0; i < 6; ++i) all.push_back(scaled(all[i], scale));
  for (const Shape& shape : all) {
    for (const double x : sizes) {
      for (const double y : sizes) {
        for (const double z : sizes) {
          const Nearest nearest = closestPoint(shape, {x, -y, z});
          ASSERT_TRUE(nearest.p_WP.allFinite() && std::isfinite(nearest.height_m))
              << shape.index() << " " << x << " " << y << " " << z;
        }
      }
    }
  }
}

TEST(ShapeExtremes, ATerametreAwayTheDirectionIsRight) {
  Random random(test::Seed{20070612});
  for (int draw = 0; draw < 100; ++draw) {
    for (const ShapeOracle& one : everyShape(random)) {
      const Vec3 p_WT = 1e9 * random.direction();
      const Nearest nearest = closestPoint(one.shape, p_WT);
      ASSERT_EQ(nearest.status, Status::Unique) << one.name;
      // 64 ulp of 1e9 m, divided by a scale of 0.2.
      ASSERT_NEAR(one.off(nearest.p_WP.cwiseQuotient(one.scale)), 0.0, 5 * 64 * 0x1p-52 * 1e9) << one.name;
    }
  }
}

TEST(ShapeExtremes, WhatIsNotANumberComesBackAndNothingHangs) {
  Random random(test::Seed{20070613});
  const std::vector<double> odd{kNotANumber, kInfinity, -kInfinity, 1e200, -1e308, 0.0};
  for (const ShapeOracle& one : everyShape(random)) {
    for (const double x : odd) {
      for (const double y : odd) {
        for (const double z : odd) {
          const Nearest nearest = closestPoint(one.shape, {x, y, z});
          EXPECT_TRUE(nearest.status == Status::Unique || nearest.status == Status::NotUnique);
        }
      }
    }
  }
}

}  // namespace
}  // namespace underact::shape
