#include "core/base/axis_geometry.h"

#include <bit>
#include <cmath>

#include "tests/support/property.h"

namespace underact {

TEST(Across, LeavesNothingAlongTheAxisHoweverNearToIt) {
  test::Random random(test::Seed{20070681});
  for (int i = 0; i < test::sweep(10'000, 500'000); ++i) {
    const Vec3 axis_W = random.direction(), side_W = axis_W.cross(random.direction()).normalized();
    const double off = std::pow(10.0, random.between(-14.0, 0.0));
    const Vec3 across_W = perpendicularPart(axis_W, axis_W + off * side_W);
    // One pass alone would leave 1e-16 along the axis, as much as 1e-2 of the shortest.
    ASSERT_LE(std::abs(across_W.dot(axis_W)), 4e-16 * across_W.norm()) << off;
    ASSERT_LE((across_W - off * side_W).norm(), 2e-15) << off;
  }
}

TEST(ReferenceAcross, IsAUnitAcrossAnyAxisAndNoneIsNearlyAlongIt) {
  test::Random random(test::Seed{20070682});
  for (int i = 0; i < test::sweep(10'000, 500'000); ++i) {
    const Vec3 axis_W = random.direction(), u_W = referencePerpendicular(axis_W);
    ASSERT_NEAR(u_W.norm(), 1.0, 4e-16);
    ASSERT_NEAR(u_W.dot(axis_W), 0.0, 4e-16);
  }
  EXPECT_EQ(referencePerpendicular(Vec3::UnitZ()), Vec3::UnitX());  // the first of equals
  EXPECT_EQ(referencePerpendicular(Vec3::UnitX()), Vec3::UnitY());
}

TEST(AngleAround, CountsAsTheRightHandTurns) {
  test::Random random(test::Seed{20070683});
  for (int i = 0; i < test::sweep(10'000, 500'000); ++i) {
    const Vec3 axis_W = random.direction(), v_W = axis_W.cross(random.direction()) + random.between(-1, 1) * axis_W;
    if (perpendicularPart(axis_W, v_W).norm() < 1e-3) continue;
    const double turn_rad = random.between(-3.0, 3.0);
    const Vec3 turned_W = Eigen::AngleAxisd(turn_rad, axis_W) * v_W;
    ASSERT_NEAR(std::remainder(angleAround(axis_W, turned_W) - angleAround(axis_W, v_W) - turn_rad, 2.0 * kPi), 0.0,
                1e-12);
  }
  EXPECT_EQ(angleAround(Vec3::UnitZ(), Vec3::UnitZ()), 0.0);
}

TEST(Wrapped, IsTheSameAngleWithinHalfATurnAndLeavesOthersAlone) {
  test::Random random(test::Seed{20070684});
  for (int i = 0; i < test::sweep(10'000, 500'000); ++i) {
    const double angle_rad = random.between(-100.0, 100.0);
    ASSERT_LE(std::abs(wrapped(angle_rad)), kPi * (1.0 + 1e-14));
    ASSERT_NEAR(std::remainder(wrapped(angle_rad) - angle_rad, 2.0 * kPi), 0.0, 3e-14);
    const double small_rad = random.between(-kPi, kPi);
    ASSERT_EQ(std::bit_cast<std::uint64_t>(wrapped(small_rad)), std::bit_cast<std::uint64_t>(small_rad));
  }
  EXPECT_EQ(wrapped(kPi), kPi);
  EXPECT_EQ(wrapped(-kPi), -kPi);
  EXPECT_TRUE(std::isnan(wrapped(kNotANumber)));
}

}  // namespace underact
