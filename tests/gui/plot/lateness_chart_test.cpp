#include "app/gui/plot/lateness_chart.h"

#include <gtest/gtest.h>

namespace underact::gui::test {

TEST(LatenessChart, LatenessIsCountedInFiveBarsADecade) {
  servo::Histogram lateness;
  for (int tick = 0; tick < 1000; ++tick) lateness.add(50'000);
  lateness.add(200);
  lateness.add(2'000'000);
  lateness.add(3'000'000'000);
  LatenessChart chart;
  chart.present(lateness, 1000.0);
  EXPECT_EQ(chart.count(0), 1);                         // below 1.6 us
  EXPECT_EQ(chart.count(8), 1000);                      // 39.8 to 63.1 us
  EXPECT_EQ(chart.count(16), 1);                        // 1.58 to 2.51 ms
  EXPECT_EQ(chart.count(LatenessChart::kBars - 1), 1);  // and beyond
}

}  // namespace underact::gui::test
