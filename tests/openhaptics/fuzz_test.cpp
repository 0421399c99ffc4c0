// Random errors and random results, no numbers and huge ones among them, at every call.
#include "tests/openhaptics/arm_fixture.h"
#include "tests/support/property.h"

namespace underact::device::openhaptics {

TEST_F(OpenHapticsArmTest, InAStormOfErrorsAndNonsenseNoForceIsBlindOrBad) {
  const std::int64_t frames = test::sweep(10'000, 1'000'000);
  rate_hz = 4000;
  std::int64_t seen = 0, without_sample = 0, stops = 0, failures = 0;
  for (std::uint64_t seed = 1; seen < frames; ++seed) {
    far->reset();
    open();
    ASSERT_NE(arm, nullptr);
    drive();
    ASSERT_TRUE(ticksOn(50));
    far->storm(true, seed);
    ASSERT_TRUE(ticksOn(400));
    (void)arm->trouble();
    arm->endDrive();
    if (!arm->trouble().empty()) ++stops;
    if (!arm->reopen().empty()) ++failures;  // in the storm: it may fail, and must not crash
    if (arm->drive(*pusher, rate_hz)) (void)ticksOn(100);
    (void)arm->listing();
    EXPECT_EQ(far->badForces(), 0) << seed;
    EXPECT_EQ(far->blindForces(), 0) << seed;
    far->storm(false, seed);
    seen += pusher->ticks;
    without_sample += pusher->without_sample;
    close();
    ASSERT_TRUE(rests()) << seed;
  }
  EXPECT_GT(without_sample, seen / 20) << "else it was no storm";
  EXPECT_GT(stops, 0);
  EXPECT_GT(failures, 0);
}

}  // namespace underact::device::openhaptics
