#include "core/base/decompositions.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "core/base/determinant.h"
#include "core/base/singular_values.h"
#include "tests/support/random.h"

namespace underact {
namespace {

constexpr double kEpsilon = std::numeric_limits<double>::epsilon();

Eigen::MatrixXd drawn(test::Random& random, Eigen::Index rows, Eigen::Index columns) {
  return Eigen::MatrixXd::NullaryExpr(rows, columns, [&random] { return random.between(-1.0, 1.0); });
}

}  // namespace

// Backward stable: off by a few n eps of the sizes of what is multiplied (Higham, Accuracy and Stability, 20.3).
TEST(LeastSquares, LeaveWhatIsAcrossEveryColumn) {
  test::Random random(test::Seed{20261124});
  for (int round = 0; round < 100; ++round) {
    const Eigen::MatrixXd A = drawn(random, 40, 4), b = drawn(random, 40, 3);
    const Eigen::MatrixXd left = leastSquaresRest(A, b);
    EXPECT_EQ(left, b - A * leastSquares(A, b));
    EXPECT_LT((A.transpose() * left).norm(), 100.0 * 40.0 * kEpsilon * A.norm() * b.norm());
    EXPECT_LT(left.norm(), b.norm());
  }
}

TEST(SolveSymmetric, GivesBackWhatWasMultiplied) {
  test::Random random(test::Seed{20261125});
  for (int round = 0; round < 100; ++round) {
    const Eigen::MatrixXd half = drawn(random, 4, 8);
    Eigen::MatrixXd A = half * half.transpose();
    const Eigen::MatrixXd b = drawn(random, 4, 2);
    const Eigen::MatrixXd whole = A;
    A.triangularView<Eigen::StrictlyUpper>().setConstant(std::numeric_limits<double>::quiet_NaN());
    const Eigen::MatrixXd x = solveSymmetric(A, b);  // of which the lower half counts
    EXPECT_LT((whole * x - b).norm(), 100.0 * 4.0 * kEpsilon * (whole.norm() * x.norm() + b.norm()));
  }
}

TEST(PrincipalAxes, RiseAndPutTheMatrixTogether) {
  test::Random random(test::Seed{20261126});
  for (int round = 0; round < 100; ++round) {
    const Mat3 half = drawn(random, 3, 3);
    const Mat3 matrix = half + half.transpose();
    const PrincipalAxes principal = principalAxes(matrix);
    EXPECT_LE(principal.values[0], principal.values[1]);
    EXPECT_LE(principal.values[1], principal.values[2]);
    const Mat3 together = principal.axes * principal.values.asDiagonal() * principal.axes.transpose();
    EXPECT_LT((together - matrix).norm(), 100.0 * 3.0 * kEpsilon * matrix.norm());
  }
}

TEST(SingularValues, FallAndAreTheLengthsOfWhatTheirVectorsBecome) {
  test::Random random(test::Seed{20261127});
  for (int round = 0; round < 100; ++round) {
    const Eigen::MatrixXd A = drawn(random, 3, 1 + round % 7);
    const SingularValues right = rightSingularValues(A), left = leftSingularValues(A);
    const double min = 100.0 * 7.0 * kEpsilon * A.squaredNorm();
    ASSERT_EQ(right.vectors.cols(), A.cols());  // the whole space, not what A leaves of it
    ASSERT_EQ(left.vectors.cols(), 3);
    for (Eigen::Index i = 0; i < right.values.size(); ++i) {
      if (i > 0) EXPECT_LE(right.values[i], right.values[i - 1]);
      const double square = right.values[i] * right.values[i];
      EXPECT_LT((A.transpose() * (A * right.vectors.col(i)) - square * right.vectors.col(i)).norm(), min);
      EXPECT_LT((A * (A.transpose() * left.vectors.col(i)) - square * left.vectors.col(i)).norm(), min);
    }
  }
}

TEST(SingularValues, OfTwoHalfDiametersAreTheHalfAxesOfTheEllipse) {
  Eigen::Matrix<double, 3, 2> pair;
  pair << 3.0, -3.0, 2.0, 2.0, 0.0, 0.0;  // 3 sqrt(2) along x, 2 sqrt(2) along y, 45 degrees later each
  const EllipseAxes ellipse = ellipseAxes(pair);
  EXPECT_NEAR(ellipse.half_m[0], 3.0 * std::sqrt(2.0), 1e-14);
  EXPECT_NEAR(ellipse.half_m[1], 2.0 * std::sqrt(2.0), 1e-14);
  EXPECT_NEAR(std::abs(ellipse.axes(0, 0)), 1.0, 1e-15);
  EXPECT_NEAR(std::abs(ellipse.axes(1, 1)), 1.0, 1e-15);
  EXPECT_NEAR(std::abs(ellipse.axes(2, 2)), 1.0, 1e-15);
}

TEST(Determinant, OfAShearIsOneAndOfEqualRowsNothing) {
  Eigen::MatrixXd matrix = Eigen::MatrixXd::Identity(6, 6);
  matrix.row(4) += 3.0 * matrix.row(1);
  EXPECT_EQ(determinantOf(matrix), 1.0);
  matrix.row(0).swap(matrix.row(5));
  EXPECT_EQ(determinantOf(matrix), -1.0);
  matrix.row(2) = matrix.row(3);
  EXPECT_EQ(determinantOf(matrix), 0.0);
}

}  // namespace underact
