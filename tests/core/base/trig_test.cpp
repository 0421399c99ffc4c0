#include "core/base/trig.h"

#include <bit>
#include <cmath>
#include <cstdint>

#include "core/base/units.h"
#include "tests/support/property.h"

namespace underact {
namespace {

std::uint64_t bitsOf(double value) {
  return std::bit_cast<std::uint64_t>(value);
}

}  // namespace

TEST(Trig, IsWithinTwoUlpOfTheLibrary) {  // 1 ulp is promised here, and glibc itself may be off by one
  test::Random random(test::Seed{1});
  for (int i = 0; i < 100'000; ++i) {
    const double angle_rad = random.between(-10.0, 10.0);
    const SinCos both = sinCos(angle_rad);
    ASSERT_NEAR(both.sin, std::sin(angle_rad), 2 * 0x1p-53) << angle_rad;
    ASSERT_NEAR(both.cos, std::cos(angle_rad), 2 * 0x1p-53) << angle_rad;
    const double y = random.between(-1.0, 1.0), x = random.between(-1.0, 1.0);
    ASSERT_NEAR(atan2Of(y, x), std::atan2(y, x), 4 * 0x1p-52) << y << " " << x;
  }
}

TEST(Trig, TwoAtOnceHaveTheBitsOfEachAlone) {
  test::Random random(test::Seed{2});
  for (int i = 0; i < 100'000; ++i) {
    const double a_rad = random.between(-10.0, 10.0), b_rad = random.between(-1e-3, 1e-3);
    const SinCosPair pair = sinCosOfTwo(a_rad, b_rad);
    ASSERT_EQ(bitsOf(pair.first.sin), bitsOf(sinCos(a_rad).sin)) << a_rad;
    ASSERT_EQ(bitsOf(pair.first.cos), bitsOf(sinCos(a_rad).cos)) << a_rad;
    ASSERT_EQ(bitsOf(pair.second.sin), bitsOf(sinCos(b_rad).sin)) << b_rad;
    ASSERT_EQ(bitsOf(pair.second.cos), bitsOf(sinCos(b_rad).cos)) << b_rad;
    const AnglePair angles = atan2OfTwo(a_rad, b_rad, b_rad, -a_rad);
    ASSERT_EQ(bitsOf(angles.first_rad), bitsOf(atan2Of(a_rad, b_rad))) << a_rad << " " << b_rad;
    ASSERT_EQ(bitsOf(angles.second_rad), bitsOf(atan2Of(b_rad, -a_rad))) << a_rad << " " << b_rad;
  }
}

TEST(Trig, HasTheBitsItHadWhenSessionsWereFirstRecorded) {  // a replay must give these on every machine
  std::uint64_t sum = 0;
  for (int i = -5000; i < 5000; ++i) {
    const SinCos both = sinCos(1e-3 * i);
    sum = std::rotl(sum, 1) ^ bitsOf(both.sin) ^ std::rotl(bitsOf(both.cos), 7) ^ bitsOf(atan2Of(both.sin, both.cos));
  }
  EXPECT_EQ(sum, 9045471224921320797U);
}

TEST(Trig, GivesNaNForNaNAndExactQuarterTurns) {
  EXPECT_TRUE(std::isnan(sinCos(kNotANumber).sin));
  EXPECT_TRUE(std::isnan(sinCosOfTwo(kInfinity, 0.0).first.cos));
  EXPECT_EQ(sinCos(0.0).sin, 0.0);
  EXPECT_EQ(sinCos(0.0).cos, 1.0);
  EXPECT_EQ(atan2Of(0.0, -1.0), kPi);
  EXPECT_EQ(atan2Of(1.0, 0.0), kPi / 2);
  EXPECT_EQ(atan2Of(0.0, 1.0), 0.0);
}

}  // namespace underact
