#include <gtest/gtest.h>

#include "app/gui/model/limit_names.h"
#include "app/gui/model/stability.h"

namespace underact::gui::test {

TEST(ServoFigures, TheLimitThatCutsMostIsTheOneNamed) {
  EXPECT_EQ(mostLimiting({}), "");
  EXPECT_EQ(mostLimiting({.clamp_N = 0.2, .speed_N = 0.3, .slew_N = 0.1}), "speed");
  EXPECT_EQ(mostLimiting({.clamp_N = 0.4, .speed_N = 0.3}), "maximum force");
  EXPECT_EQ(mostLimiting({.edge_N = 0.1}), "edge");
  EXPECT_EQ(mostLimiting({.heat_N = 0.1}), "heat");
  EXPECT_EQ(mostLimiting({.slew_N = 0.1}), "slew rate");
  EXPECT_EQ(mostLimiting({.clamp_N = 9.0, .frozen = true}), "frozen sample");  // nothing is sent then
}

TEST(ServoFigures, CalmStiffnessIsBelowTheExactLimitsOfTheTable) {
  // Mass, damping, kd, rate -> exact limit with one tick of delay, by the spectral radius of the sampled loop.
  EXPECT_NEAR(calmStiffness(0.0, 0.1, 1000), 66.7, 0.1);
  EXPECT_NEAR(calmStiffness(0.0, 0.1, 4000), 266.7, 0.1);
  EXPECT_LE(calmStiffness(0.5, 0.1, 1000), 395.3);
  EXPECT_LE(calmStiffness(0.5, 1.0, 1000), 997.4 * 1.01);
  EXPECT_LE(calmStiffness(2.0, 0.1, 1000), 1331.6);
}

}  // namespace underact::gui::test
