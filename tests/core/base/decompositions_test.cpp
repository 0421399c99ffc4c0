#include "core/base/decompositions.h"

#include <gtest/gtest.h>

#include <limits>

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
    const Eigen::MatrixXd left = b - A * leastSquares(A, b);
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

}  // namespace underact
