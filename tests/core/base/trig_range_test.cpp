#include <cmath>

#include "core/base/trig.h"
#include "core/base/units.h"
#include "tests/support/property.h"

namespace underact {
namespace {

// Within 1 ulp (SLEEF's own bound for these forms); the long double value is exact to a small part of that.
void expectWithinAnUlp(double got, long double right) {
  const double near = static_cast<double>(right);
  const double ulp = std::nextafter(std::abs(near), kInfinity) - std::abs(near);
  ASSERT_LE(std::abs(static_cast<long double>(got) - right), 1.0L * ulp + 1e-320L) << got;
}

TEST(TrigRange, SinAndCosAreWithinAnUlp) {
  test::Random random(test::Seed{20070701});
  for (int draw = 0; draw < test::sweep(20000, 1000000); ++draw) {
    const double angle_rad = random.between(-1.0, 1.0) * std::pow(10.0, random.between(-8.0, 3.0));
    const SinCos both = sinCos(angle_rad);
    ASSERT_NO_FATAL_FAILURE(expectWithinAnUlp(both.sin, std::sin(static_cast<long double>(angle_rad)))) << angle_rad;
    ASSERT_NO_FATAL_FAILURE(expectWithinAnUlp(both.cos, std::cos(static_cast<long double>(angle_rad)))) << angle_rad;
  }
}

TEST(TrigRange, Atan2IsWithinAnUlpAllAround) {
  test::Random random(test::Seed{20070702});
  for (int draw = 0; draw < test::sweep(20000, 1000000); ++draw) {
    const double y = random.between(-1.0, 1.0) * std::pow(10.0, random.between(-8.0, 3.0));
    const double x = random.between(-1.0, 1.0) * std::pow(10.0, random.between(-8.0, 3.0));
    ASSERT_NO_FATAL_FAILURE(expectWithinAnUlp(atan2Of(y, x), std::atan2(static_cast<long double>(y), x)))
        << y << " " << x;
  }
}

TEST(TrigRange, TheAxesAreExact) {
  EXPECT_EQ(sinCos(0.0).sin, 0.0);
  EXPECT_EQ(sinCos(0.0).cos, 1.0);
  EXPECT_EQ(atan2Of(0.0, 1.0), 0.0);
  EXPECT_EQ(atan2Of(0.0, -1.0), kPi);
  EXPECT_EQ(atan2Of(1.0, 0.0), kPi / 2);
  EXPECT_EQ(atan2Of(-1.0, 0.0), -kPi / 2);
  EXPECT_EQ(atan2Of(0.0, 0.0), 0.0);
}

TEST(TrigRange, AnyFiniteAngleHasASine) {
  for (const double angle_rad : {5e-324, 1e-300, 1e10, 1e22, 1e100, 1e300, 1.7976931348623157e308}) {
    for (const double sign : {-1.0, 1.0}) {
      const SinCos both = sinCos(sign * angle_rad);
      EXPECT_NEAR(both.sin * both.sin + both.cos * both.cos, 1.0, 4 * 0x1p-53) << angle_rad;
    }
  }
  EXPECT_NEAR(sinCos(1e22).sin, -0.8522008497671888, 2e-16);  // Ng 1992, the classic check of the reduction
}

TEST(TrigRange, GivesNaNForWhatIsNotFinite) {
  for (const double angle_rad : {kInfinity, -kInfinity, kNotANumber}) {
    EXPECT_TRUE(std::isnan(sinCos(angle_rad).sin));
    EXPECT_TRUE(std::isnan(sinCos(angle_rad).cos));
  }
}

}  // namespace
}  // namespace underact
