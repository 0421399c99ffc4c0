#include <gtest/gtest.h>

#include "app/gui/lateness.h"
#include "app/gui/options.h"
#include "app/gui/stability.h"
#include "app/gui/words.h"
#include "tests/stories/picture_difference.h"

namespace underact::gui::test {

TEST(Parts, LatenessForgetsWhatIsOlderThanTenSeconds) {
  Lateness lateness(100);
  for (int tick = 0; tick < 1000; ++tick) lateness.add(500'000);
  EXPECT_DOUBLE_EQ(lateness.percentile_us(0.99), 500.0);
  for (int tick = 0; tick < 1000; ++tick) lateness.add(tick < 980 ? 7'000 : 90'000);
  EXPECT_DOUBLE_EQ(lateness.percentile_us(0.5), 7.0);
  EXPECT_DOUBLE_EQ(lateness.percentile_us(0.99), 90.0);
}

TEST(Parts, CalmStiffnessIsBelowTheExactLimitsOfTheTable) {
  // Mass, damping, kd, rate -> exact limit with one tick of delay, by the spectral radius of the sampled loop.
  EXPECT_NEAR(calmStiffness(0.0, 0.1, 1000), 66.7, 0.1);
  EXPECT_NEAR(calmStiffness(0.0, 0.1, 4000), 266.7, 0.1);
  EXPECT_LE(calmStiffness(0.5, 0.1, 1000), 395.3);
  EXPECT_LE(calmStiffness(0.5, 1.0, 1000), 997.4 * 1.01);
  EXPECT_LE(calmStiffness(2.0, 0.1, 1000), 1331.6);
}

TEST(Parts, NumbersHaveARealMinusAndNoNegativeZero) {
  EXPECT_EQ(numberText(-1.24, 1), QString(QChar(0x2212)) + "1.2");
  EXPECT_EQ(numberText(-0.04, 1), "0.0");
  EXPECT_EQ(numberText(kNotANumber, 1), QString(QChar(0x2013)));
  EXPECT_EQ(directionText({0, 0, -2}), QString("0.000, 0.000, ") + QChar(0x2212) + "1.000");
}

TEST(Parts, TheCommandLineIsUnderstoodOrSaidToBeWrong) {
  EXPECT_EQ(parseOptions({"a.json", "--rate", "2000"}).rate_hz, 2000);
  EXPECT_EQ(parseOptions({"a.json"}).scene, "a.json");
  EXPECT_TRUE(parseOptions({"--help"}).help);
  EXPECT_FALSE(parseOptions({"--rate", "50"}).wrong.empty());
  EXPECT_FALSE(parseOptions({"--rate"}).wrong.empty());
  EXPECT_FALSE(parseOptions({"--picture", "a.json"}).wrong.empty());
  EXPECT_FALSE(parseOptions({"a.json", "b.json"}).wrong.empty());
  EXPECT_FALSE(parseOptions({"--fast"}).wrong.empty());
}

TEST(Parts, ThePictureDifferenceIsThatOfTheWorstBlock) {
  QImage a(640, 480, QImage::Format_RGB32);
  a.fill(Qt::white);
  QImage b = a;
  for (int y = 32; y < 48; ++y) {
    for (int x = 32; x < 40; ++x) b.setPixelColor(x, y, Qt::black);
  }
  EXPECT_DOUBLE_EQ(worstBlockDifference(a, a), 0.0);
  EXPECT_DOUBLE_EQ(worstBlockDifference(a, b), 0.5);
  EXPECT_DOUBLE_EQ(worstBlockDifference(a, QImage(16, 16, QImage::Format_RGB32)), 1.0);
}

}  // namespace underact::gui::test
