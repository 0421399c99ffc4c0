#include "core/base/nearest_rotation.h"

#include <gtest/gtest.h>

#include <cmath>

#include "core/base/rotation.h"
#include "tests/support/random.h"

namespace underact {
namespace {

Mat3 rounded(const Mat3& R, double unit) {
  return R.unaryExpr([unit](double entry) { return unit * std::round(entry / unit); });
}

TEST(NearestRotation, OfFewDecimalsIsThePolarFactor) {  // oracle: by singular values
  test::Random random({20260701});
  for (int draw = 0; draw < 300; ++draw) {
    const Mat3 R = Eigen::AngleAxisd(random.between(-3.1, 3.1), random.direction()).toRotationMatrix();
    const Mat3 given = rounded(R, 1e-3);
    const Eigen::JacobiSVD<Mat3> svd(given, Eigen::ComputeFullU | Eigen::ComputeFullV);
    const Mat3 found = nearestRotation(given);
    EXPECT_LE((found - svd.matrixU() * svd.matrixV().transpose()).cwiseAbs().maxCoeff(),
              (rotationNote(given).empty() ? 2e-6 : 1e-14));
    EXPECT_LE((found * found.transpose() - Mat3::Identity()).cwiseAbs().maxCoeff(), 2e-15);
    EXPECT_TRUE(rotationProblem(given).empty());
    EXPECT_EQ(rotationNote(given).empty(), offRotation(given) < 1e-6);
    EXPECT_TRUE(rotationNote(rounded(R, 1e-6)).empty());
  }
}

TEST(NearestRotation, SaysHowFarOffAMatrixIs) {
  const double half = 0.7071;  // 7e-6 off
  Mat3 R;
  R << half, -half, 0, half, half, 0, 0, 0, 1;
  EXPECT_NEAR(offRotation(R), std::sqrt(0.5) - half, 1e-12);
  EXPECT_EQ(rotationNote(R),
            "This matrix is 6.8e-06 off a rotation, and the nearest one is taken. With six decimals it is "
            "exact enough.");
  EXPECT_TRUE(rotationProblem(R).empty());
  R << 0.71, -0.71, 0, 0.71, 0.71, 0, 0, 0, 1;
  EXPECT_EQ(
      rotationProblem(R),
      "This is not a rotation matrix: a number in it is 0.0029 off the nearest one, and 0.001 is allowed. Give at "
      "least four decimals, better six.");
}

TEST(NearestRotation, RefusesAMirrorAndWhatIsNoMatrix) {
  for (const Mat3& R : {Mat3(-Mat3::Identity()), Mat3(Mat3::Zero()), Mat3(Mat3::Constant(kNotANumber)),
                        Mat3(1e300 * Mat3::Identity()), Mat3(Vec3(1, 1, -1).asDiagonal())}) {
    EXPECT_EQ(offRotation(R), kInfinity);
    EXPECT_NE(rotationProblem(R).find("right-handed frame"), std::string::npos);
  }
}

}  // namespace
}  // namespace underact
