#include <gtest/gtest.h>

#include "core/shape/direction.h"
#include "core/shape/shape.h"

namespace underact::shape {
namespace {

const Vec3 kZero = Vec3::Zero();
const Vec3 kUp{0, 0, 1};
const Vec3 kNan{0, kNotANumber, 0};
const Vec3 kInf{kInfinity, 0, 0};

template <class Made>
std::size_t problemsOf(const Result<Made>& made) {
  return made ? 0 : made.problems().size();
}

TEST(ShapeMake, EveryProblemIsNamedNotTheFirst) {
  EXPECT_EQ(problemsOf(makePoint(kNan, {})), 1U);
  EXPECT_EQ(problemsOf(makeSphere(kNan, 0.0, {})), 2U);
  EXPECT_EQ(problemsOf(makeLine(kInf, kZero, {})), 2U);
  EXPECT_EQ(problemsOf(makePlane(kInf, kNan, {})), 2U);
  EXPECT_EQ(problemsOf(makeCircle(kNan, kZero, -1.0, {})), 3U);
  EXPECT_EQ(problemsOf(makeCylinder(kNan, kInf, kNotANumber, {})), 3U);
  EXPECT_EQ(problemsOf(makeBox(kNan, {1, 0, 1}, Mat3::Zero(), {})), 3U);
}

TEST(ShapeMake, RadiusMustBeAboveZeroAndFinite) {
  for (const double radius_m : {0.0, -0.0, -1.0, kInfinity, -kInfinity, kNotANumber}) {
    EXPECT_FALSE(makeSphere(kZero, radius_m, {})) << radius_m;
    EXPECT_FALSE(makeCircle(kZero, kUp, radius_m, {})) << radius_m;
    EXPECT_FALSE(makeCylinder(kZero, kUp, radius_m, {})) << radius_m;
  }
  EXPECT_TRUE(makeSphere(kZero, 1e-12, {}));
  EXPECT_TRUE(makeCircle(kZero, kUp, 1e12, {}));
}

TEST(ShapeMake, AProblemCarriesItsPlace) {
  const Result<Sphere> sphere = makeSphere(kZero, -1.0, {"a.json", 3, 7, "constraints[0].radius_mm"});
  ASSERT_FALSE(sphere);
  EXPECT_EQ(describe(sphere.problems()[0]), "a.json:3:7: error: constraints[0].radius_mm: The radius must be above 0.");
}

TEST(ShapeMake, AnyLengthOfDirectionGivesAUnitVector) {
  for (const double length : {5e-324, 1e-300, 1e-12, 1.0, 1e12, 1e300, 1.7e308}) {
    const Vec3 unit = unitOf(length * Vec3(0, 1, 0)).value();
    EXPECT_EQ(unit, Vec3(0, 1, 0)) << length;
    EXPECT_NEAR(makeLine(kZero, length * Vec3(1, 1, -1), {}).value().axis_W.norm(), 1.0, 4 * 0x1p-53) << length;
  }
  EXPECT_FALSE(unitOf(kZero));
  EXPECT_FALSE(unitOf(kNan));
  EXPECT_FALSE(unitOf(kInf));
}

TEST(ShapeMake, ABoxWantsARotation) {
  const Vec3 size(0.1, 0.1, 0.1);
  Mat3 mirrored = Mat3::Identity();
  mirrored(2, 2) = -1.0;
  Mat3 sheared = Mat3::Identity();
  sheared(0, 1) = 3e-3;
  Mat3 rounded = Mat3::Identity();
  rounded(0, 1) = 5e-7, rounded(1, 0) = -5e-7;
  EXPECT_FALSE(makeBox(kZero, size, mirrored, {}));
  EXPECT_FALSE(makeBox(kZero, size, sheared, {}));
  EXPECT_FALSE(makeBox(kZero, size, 2.0 * Mat3::Identity(), {}));
  EXPECT_FALSE(makeBox(kZero, {0.1, kInfinity, 0.1}, Mat3::Identity(), {}));
  EXPECT_FALSE(makeBox(kZero, {0.1, 0.1, 5e-324}, Mat3::Identity(), {})) << "half of it is 0";
  const Mat3 R_WB = makeBox(kZero, size, rounded, {}).value().R_WB;
  EXPECT_LE((R_WB * R_WB.transpose() - Mat3::Identity()).cwiseAbs().maxCoeff(), 4 * 0x1p-52);
  EXPECT_NEAR(R_WB(0, 1), 5e-7, 1e-12);
  EXPECT_EQ(makeBox(kZero, size, Mat3::Identity(), {}).value().R_WB, Mat3::Identity());
}

TEST(ShapeMake, WhatHasAnInsideCanBeAWall) {
  EXPECT_FALSE(hasSides(Point{kZero}));
  EXPECT_FALSE(hasSides(Line{kZero, kUp}));
  EXPECT_FALSE(hasSides(Circle{kZero, kUp, 1.0}));
  EXPECT_FALSE(hasSides(scaled(Shape(Circle{kZero, kUp, 1.0}), {1, 2, 3})));
  for (const Shape& shape : {Shape(Sphere{kZero, 1.0}), Shape(Plane{kZero, kUp}), Shape(Cylinder{kZero, kUp, 1.0}),
                             Shape(makeBox(kZero, {1, 1, 1}, Mat3::Identity(), {}).value())}) {
    EXPECT_TRUE(hasSides(shape));
    EXPECT_TRUE(hasSides(scaled(shape, {1, 2, 3})));
  }
}

TEST(ShapeMake, ScalingWhatIsScaledAlreadyChangesNothing) {
  const Shape once = scaled(Shape(Circle{{0.1, 0, 0}, kUp, 0.05}), {1, 2, 3});
  const Shape twice = scaled(once, {1, 2, 3});
  EXPECT_EQ(std::get<Ellipse>(once).first_m, std::get<Ellipse>(twice).first_m);
}

}  // namespace
}  // namespace underact::shape
