#include "core/servo/timing.h"

#include <gtest/gtest.h>

namespace underact::servo {

TEST(Timing, LatenessLatelyForgetsWhatIsOlderThanTenSeconds) {
  Timing timing(100);
  const auto add = [&timing](std::int64_t lateness_ns) {
    TickRecord record;
    record.lateness_ns = lateness_ns;
    timing.add(record);
  };
  for (int tick = 0; tick < 1000; ++tick) add(500'000);
  EXPECT_NEAR(timing.lateLately().p99_us, 500.0, 500.0 / 32.0);
  for (int tick = 0; tick < 1000; ++tick) add(tick < 980 ? 7'000 : 90'000);
  EXPECT_NEAR(timing.lateLately().p50_us, 7.0, 7.0 / 32.0);
  EXPECT_NEAR(timing.lateLately().p99_us, 90.0, 90.0 / 32.0);
  EXPECT_NEAR(timing.lateness().max_us, 500.0, 500.0 / 32.0);  // since the start, it is still known
}

}  // namespace underact::servo
