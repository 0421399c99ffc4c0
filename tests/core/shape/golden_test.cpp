#include <gtest/gtest.h>

#include "core/base/units.h"
#include "core/control/law.h"
#include "core/target/target.h"
#include "tests/support/constraint_vectors.h"

namespace underact::shape {
namespace {

using test::GoldenCase;
using test::GoldenSet;

/// Core has no unit: mm and N/mm go in as they are. allowed: added to each tolerance, mm.
void expectCase(const GoldenSet& set, const GoldenCase& one, double unit, double allowed) {
  SCOPED_TRACE(set.shape.name + " " + one.tag + " P " + ::testing::PrintToString(one.P.transpose()));
  const Result<Shape> shape = makeShape(set.shape, unit);
  ASSERT_TRUE(shape);
  const Vec3 p_WT = unit * one.P;
  const Nearest nearest = closestPoint(shape.value(), p_WT);
  const Vec3 kp = one.kp / unit;
  control::LawState state;
  const Vec3 f_T_W = control::force(control::P{kp}, state, nearest.p_WP - p_WT, {});
  EXPECT_TRUE(f_T_W.allFinite());
  if (one.degenerate) {
    EXPECT_EQ(nearest.status, Status::NotUnique);
    EXPECT_EQ(nearest.p_WP, p_WT);
    EXPECT_EQ(f_T_W, Vec3::Zero());
    const double largest =
        std::max(one.P.cwiseAbs().maxCoeff(), set.shape.radius);  // the file states no tolerance: meta.tol
    EXPECT_NEAR(std::abs(nearest.height_m), unit * one.distance, unit * 64 * 0x1p-52 * largest);
    return;
  }
  EXPECT_EQ(nearest.status, Status::Unique);
  EXPECT_LE((nearest.p_WP - unit * one.Q).cwiseAbs().maxCoeff(), unit * (one.tol_Q + allowed));
  EXPECT_LE((f_T_W - one.force).cwiseAbs().maxCoeff(), one.tol_F + kp.maxCoeff() * unit * allowed);
  EXPECT_NEAR(std::abs(nearest.height_m), unit * one.distance, unit * (one.tol_Q + allowed));
}

TEST(ShapeGolden, HasAllItsCases) {
  std::size_t cases = 0, degenerate = 0;
  for (const GoldenSet& set : test::constraintVectors().sets) {
    cases += set.cases.size();
    for (const GoldenCase& one : set.cases) degenerate += one.degenerate ? 1 : 0;
  }
  EXPECT_EQ(test::constraintVectors().sets.size(), 30U);
  EXPECT_EQ(cases, 581U);
  EXPECT_EQ(degenerate, 23U);
  EXPECT_EQ(test::constraintVectors().anisotropic.size(), 18U);
}

TEST(ShapeGolden, EveryCaseInMillimetresIsWithinItsOwnTolerance) {
  for (const GoldenSet& set : test::constraintVectors().sets) {
    for (const GoldenCase& one : set.cases) expectCase(set, one, 1.0, 0.0);
  }
}

TEST(ShapeGolden, EveryCaseInMetresIsWithinItsToleranceAndNearAnAxisWithinThatOfTheConversion) {
  for (const GoldenSet& set : test::constraintVectors().sets) {
    for (const GoldenCase& one : set.cases) {
      // vectors/README: a program in metres rounds P once more; near an axis or centre 8 R ulp(|P|) / off_axis.
      const bool near = one.tag.rfind("near", 0) == 0 && !one.degenerate;
      const double ulp = 0x1p-52 * one.P.norm();
      expectCase(set, one, kMetrePerMillimetre, near ? 8.0 * set.shape.radius * ulp / offAxis(set.shape, one.P) : 0.0);
    }
  }
}

TEST(ShapeGolden, DirectionsWhoseSquaresOverflowOrVanishAreDirectionsStill) {
  for (const GoldenSet& set : test::constraintVectors().extreme) expectCase(set, set.cases.front(), 1.0, 0.0);
}

TEST(ShapeGolden, UnequalGainsInTheEuclideanMetricAreComponentwise) {
  for (const GoldenSet& set : test::constraintVectors().anisotropic) expectCase(set, set.cases.front(), 1.0, 0.0);
}

TEST(ShapeGolden, InvalidShapesAreRefused) {
  EXPECT_EQ(test::constraintVectors().invalid.size(), 6U);
  for (const test::GoldenShape& shape : test::constraintVectors().invalid)
    EXPECT_FALSE(makeShape(shape, 1.0)) << shape.name;
}

}  // namespace
}  // namespace underact::shape
