#include <gtest/gtest.h>

#include "app/gui/servo/check_dialog.h"

namespace underact::gui::test {
namespace {

servo::CheckResult measured(double servo_p99_us, double servo_p999_us) {
  servo::CheckResult result;
  result.floor = {40, 100, 150, 4000};
  result.servo = {41, servo_p99_us, servo_p999_us, 9000};
  result.ticks = 30'000;
  return result;
}

}  // namespace

TEST(CheckVerdict, GoodIsWithinAThirdAtP99AndTwiceAtP999) {
  EXPECT_TRUE(verdictOf(measured(129, 299)).startsWith("The servo is as punctual"));
  EXPECT_TRUE(verdictOf(measured(131, 299)).startsWith("The servo is less punctual"));
  EXPECT_TRUE(verdictOf(measured(129, 301)).startsWith("The servo is less punctual"));
  EXPECT_EQ(verdictOf({}), "Nothing was measured.");
}

}  // namespace underact::gui::test
