#include "core/base/rotation.h"

#include <cmath>

#include "core/base/axis_geometry.h"
#include "tests/support/property.h"

namespace underact {
namespace {

Mat3 turnBy(const Vec3& w) {
  const double angle_rad = w.norm();
  return angle_rad > 0.0 ? Eigen::AngleAxisd(angle_rad, w / angle_rad).toRotationMatrix() : Mat3::Identity();
}

}  // namespace

TEST(RotationVector, IsTheInverseOfTheTurn) {
  test::Random random(test::Seed{20070671});
  for (int i = 0; i < test::sweep(20'000, 1'000'000); ++i) {
    const double angle_rad = i % 2 == 0 ? random.between(0.0, kPi - 1e-3) : std::pow(10.0, random.between(-12.0, 0.0));
    const Vec3 w = angle_rad * random.direction();
    // The matrix is rounded to some 1e-16; its own sine and cosine give the angle back to that.
    ASSERT_LE((rotationVector(turnBy(w)) - w).norm(), 4e-15) << angle_rad;
  }
}

TEST(RotationVector, NearHalfATurnItStillIsTheTurn) {
  test::Random random(test::Seed{20070672});
  for (int i = 0; i < test::sweep(20'000, 1'000'000); ++i) {
    const double short_rad = i % 100 == 0 ? 0.0 : std::pow(10.0, random.between(-16.0, -2.0));
    const Mat3 R = turnBy((kPi - short_rad) * random.direction());
    const Vec3 w = rotationVector(R);
    ASSERT_LE(w.norm(), kPi * (1.0 + 4 * 0x1p-52));
    // Either of two axes at half a turn, so compare the turns: nine numbers of some ulp of pi.
    ASSERT_LE((turnBy(w) - R).norm(), 12 * kPi * 0x1p-52) << short_rad;
  }
}

TEST(RotationVector, QuarterAndHalfTurnsByHand) {
  EXPECT_EQ(rotationVector(Mat3::Identity()), Vec3::Zero());
  Mat3 R;
  R << 0, -1, 0, 1, 0, 0, 0, 0, 1;
  EXPECT_LE((rotationVector(R) - Vec3(0, 0, kPi / 2)).norm(), 1e-15);
  for (int axis = 0; axis < 3; ++axis) {
    R = -Mat3::Identity();
    R(axis, axis) = 1.0;
    EXPECT_NEAR(std::abs(rotationVector(R)[axis]), kPi, 1e-15);
    EXPECT_NEAR(rotationVector(R).norm(), kPi, 1e-15);
  }
}

TEST(RotationVector, NotFiniteInNotFiniteOut) {
  Mat3 R = Mat3::Identity();
  R(1, 0) = kNotANumber;
  EXPECT_FALSE(rotationVector(R).allFinite());
}

}  // namespace underact
