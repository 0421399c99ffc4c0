#include "core/base/denormals.h"

#include <gtest/gtest.h>

#include <limits>
#include <thread>

namespace underact {
namespace {

constexpr double kSmallest = std::numeric_limits<double>::min();  // the smallest normal number

/// Computed when it is called: the compiler may not do it beforehand, with the bits of its own machine.
double halfOf(double value) {
  const volatile double operand = value;
  return 0.5 * operand;
}

double sumWithZero(double value) {
  const volatile double operand = value;
  return operand + 0.0;
}

#if defined(__x86_64__) || defined(__aarch64__)
static_assert(FlushDenormals::isKnown(), "else the tests below would prove nothing here");
#endif

TEST(FlushDenormals, TakesResultsAndOperandsBelowTheSmallestNormalNumberForZero) {
  const double denormal = halfOf(kSmallest);
  ASSERT_GT(denormal, 0.0);
  const FlushDenormals flush;
  EXPECT_EQ(halfOf(kSmallest) == 0.0, FlushDenormals::isKnown());
  EXPECT_EQ(sumWithZero(denormal) == 0.0, FlushDenormals::isKnown());
  EXPECT_EQ(halfOf(2.0 * kSmallest), kSmallest);  // normal numbers are what they were
}

TEST(FlushDenormals, IsOverWithItsLifeAndNestsLikeOne) {
  {
    const FlushDenormals outer;
    { const FlushDenormals inner; }
    EXPECT_EQ(halfOf(kSmallest), FlushDenormals::isKnown() ? 0.0 : 0.5 * kSmallest);
  }
  EXPECT_GT(halfOf(kSmallest), 0.0);
}

TEST(FlushDenormals, IsForItsOwnThreadOnly) {
  const std::thread::id here = std::this_thread::get_id();
  std::thread other([here] {
    ASSERT_NE(std::this_thread::get_id(), here);
    const FlushDenormals flush;
    EXPECT_EQ(halfOf(kSmallest) == 0.0, FlushDenormals::isKnown());
  });
  other.join();
  EXPECT_GT(halfOf(kSmallest), 0.0);
}

}  // namespace
}  // namespace underact
