#include "core/servo/deadlines.h"

#include <gtest/gtest.h>

#include "core/system/cores.h"
#include "tests/support/random.h"

namespace underact::servo {
namespace {

constexpr std::int64_t kPeriod_ns = 1'000'000;

using system::Interruptions;

TEST(Deadlines, ATickOnTimeIsFollowedByTheNextDeadline) {
  Deadlines deadlines(kPeriod_ns, 5'000'000, {});
  EXPECT_EQ(deadlines.wakeAt_ns(5'000'000), 6'000'000);
  const Wake wake = deadlines.begin(6'000'040);
  EXPECT_EQ(wake.lateness_ns, 40);
  EXPECT_EQ(wake.left_out, 0);
  EXPECT_EQ(deadlines.wakeAt_ns(6'020'000), 7'000'000);
}

TEST(Deadlines, LatenessBelowAPeriodLeavesNothingOut) {
  Deadlines deadlines(kPeriod_ns, 0, {});
  EXPECT_EQ(deadlines.begin(1'999'999).left_out, 0);
  EXPECT_EQ(deadlines.wakeAt_ns(1'999'999), 2'009'999);  // a rest, since the deadline is only 1 ns away
}

TEST(Deadlines, WhatPassedIsLeftOutAndThePhaseKept) {
  Deadlines deadlines(kPeriod_ns, 0, {});
  const Wake wake = deadlines.begin(4'300'000);  // due at 1 ms; those of 2, 3 and 4 ms have passed
  EXPECT_EQ(wake.lateness_ns, 3'300'000);
  EXPECT_EQ(wake.left_out, 3);
  EXPECT_EQ(deadlines.wakeAt_ns(4'310'000), 5'000'000);
  EXPECT_EQ(deadlines.begin(5'000'000).lateness_ns, 0);
}

TEST(Deadlines, EveryDeadlineIsTickedOrLeftOutAndNoTwoTicksShareAPeriodAfterAStall) {
  test::Random random(test::Seed{1963});
  for (int run = 0; run < 200; ++run) {
    Deadlines deadlines(kPeriod_ns, 0, {});
    std::int64_t now_ns = 0, ticks = 0, left_out = 0;
    for (int tick = 0; tick < 200; ++tick) {
      const std::int64_t wake_ns = deadlines.wakeAt_ns(now_ns);
      ASSERT_GT(wake_ns, now_ns);  // it always sleeps
      now_ns = wake_ns + static_cast<std::int64_t>(random.between(0.0, tick % 17 == 0 ? 9e6 : 1e5));
      const Wake wake = deadlines.begin(now_ns);
      ASSERT_GE(wake.lateness_ns, 0);
      ++ticks;
      left_out += wake.left_out;
      // As many as there were deadlines up to now, however long the stalls: none twice, none made up for.
      ASSERT_EQ(ticks + left_out, now_ns / kPeriod_ns);
      now_ns += static_cast<std::int64_t>(random.between(0.0, tick % 31 == 0 ? 3e6 : 5e4));
    }
  }
}

TEST(Deadlines, ATickThatNeverKeepsUpStillRestsEachTime) {
  Deadlines deadlines(kPeriod_ns, 0, {});
  std::int64_t now_ns = deadlines.wakeAt_ns(0);
  for (int tick = 0; tick < 50; ++tick) {
    deadlines.begin(now_ns);
    const std::int64_t end_ns = now_ns + 3 * kPeriod_ns / 2;
    now_ns = deadlines.wakeAt_ns(end_ns);
    ASSERT_GE(now_ns, end_ns + 10'000);
  }
}

TEST(Deadlines, AnOverrunIsTheTicksOwnOrTheArms) {
  Deadlines deadlines(kPeriod_ns, 0, {});
  deadlines.end(kPeriod_ns, kPeriod_ns / 2 - 1);
  EXPECT_EQ(deadlines.causeOf({}), LateCause::Overrun);
  deadlines.end(kPeriod_ns, kPeriod_ns / 2);
  EXPECT_EQ(deadlines.causeOf({}), LateCause::Device);
  deadlines.end(3 * kPeriod_ns, 2 * kPeriod_ns);
  EXPECT_EQ(deadlines.causeOf({7, 7}), LateCause::Device);  // for sure, where the counters only may be the cause
  deadlines.end(kPeriod_ns - 1, kPeriod_ns - 1);
  EXPECT_EQ(deadlines.causeOf({7, 7}), LateCause::Woken);
}

TEST(Deadlines, WhatTheSystemCountedSinceTheLastLateTickIsTheCause) {
  Deadlines deadlines(kPeriod_ns, 0, {10, 3});
  EXPECT_EQ(deadlines.causeOf({10, 3}), LateCause::Woken);  // as at the beginning
  EXPECT_EQ(deadlines.causeOf({11, 4}), LateCause::PageFault);
  EXPECT_EQ(deadlines.causeOf({11, 5}), LateCause::Preempted);
  EXPECT_EQ(deadlines.causeOf({11, 5}), LateCause::Woken);
}

TEST(LateCause, HasANameOfItsOwnForEach) {
  EXPECT_STREQ(name(LateCause::Overrun), "overrun");
  EXPECT_STREQ(name(LateCause::Device), "device");
  EXPECT_STREQ(name(LateCause::PageFault), "page_fault");
  EXPECT_STREQ(name(LateCause::Preempted), "preempted");
  EXPECT_STREQ(name(LateCause::Woken), "woken");
}

TEST(FirstCore, IsTheFirstOfAListAsLinuxWritesIt) {
  EXPECT_EQ(system::firstCore("3\n"), 3);
  EXPECT_EQ(system::firstCore("2-3,7\n"), 2);
  EXPECT_EQ(system::firstCore("5,7"), 5);
  EXPECT_EQ(system::firstCore("0"), 0);
}

TEST(FirstCore, IsNoneOfAnythingElse) {
  for (const char* list : {"", "\n", "-1", "x", "3x", " 3", "(null)"})
    EXPECT_EQ(system::firstCore(list), std::nullopt) << list;
}

}  // namespace
}  // namespace underact::servo
