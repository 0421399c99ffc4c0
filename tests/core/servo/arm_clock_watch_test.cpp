#include "core/servo/arm_clock_watch.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>

#include "core/system/clock.h"
#include "tests/support/property.h"

namespace underact::servo {
namespace {

using test::Random;
using test::Seed;

constexpr std::int64_t kMillisecond_ns = 1'000'000;

/// Ticks at the servo's times, of which the arm's clock makes `sample_ns`; the first tick that is a fault, or -1.
template <class Clock>
std::int64_t firstFault(std::int64_t ticks, std::int64_t period_ns, Clock&& sample_ns) {
  ArmClockWatch watch;
  for (std::int64_t tick = 0; tick < ticks; ++tick) {
    const std::int64_t now_ns = tick * period_ns;
    if (watch.check(sample_ns(tick, now_ns), now_ns, now_ns, period_ns).kind != FaultKind::None) return tick;
  }
  return -1;
}

}  // namespace

TEST(ArmClockWatch, ARateOffByMoreThanATenthIsFoundWithinASecondAndASmallerOneNever) {
  for (const std::int64_t period_ns : {100'000, 1'000'000, 10'000'000}) {
    for (const double rate : {0.01, 0.5, 0.85, 1.15, 2.0, 100.0, 1000.0, 1e6}) {
      const std::int64_t tick = firstFault(
          3 * system::kSecond_ns / period_ns, period_ns,
          [&](auto, std::int64_t now_ns) { return static_cast<std::int64_t>(rate * static_cast<double>(now_ns)); });
      EXPECT_GT(tick, 0) << rate;
      EXPECT_LE(tick * period_ns, system::kSecond_ns) << rate;
    }
    for (const double rate : {0.95, 0.9999, 1.0, 1.0001, 1.05}) {
      EXPECT_EQ(firstFault(600 * system::kSecond_ns / period_ns / 60, period_ns,
                           [&](auto, std::int64_t now_ns) {
                             return static_cast<std::int64_t>(rate * static_cast<double>(now_ns));
                           }),
                -1)
          << rate;
    }
  }
}

TEST(ArmClockWatch, ALeapIsFoundInTheTickInWhichItCame) {
  constexpr std::int64_t kLast = std::numeric_limits<std::int64_t>::max();
  for (const std::int64_t leap_ns :
       {200 * kMillisecond_ns, 3'600 * system::kSecond_ns, kLast - 3 * system::kSecond_ns}) {
    EXPECT_EQ(firstFault(3000, kMillisecond_ns,
                         [&](std::int64_t tick, std::int64_t now_ns) { return now_ns + (tick >= 700 ? leap_ns : 0); }),
              700)
        << leap_ns;
  }
}

TEST(ArmClockWatch, SaysHowFarEachOfTheTwoWent) {
  ArmClockWatch watch;
  EXPECT_EQ(watch.check(0, 0, 0, kMillisecond_ns).kind, FaultKind::None);
  const Fault ahead = watch.check(3600 * system::kSecond_ns, kMillisecond_ns, kMillisecond_ns, kMillisecond_ns);
  EXPECT_EQ(ahead.kind, FaultKind::OddClock);
  EXPECT_NEAR(ahead.seen, 3600.0, 1e-9);
  EXPECT_NEAR(ahead.allowed, 0.001, 1e-12);
  EXPECT_EQ(describe(ahead),
            "The arm's clock advanced by 3600.00 s while 0.00 s passed. Force is off. Restart the servo to reopen the "
            "arm, then press Start.");
  Fault behind;
  for (int tick = 0; behind.kind == FaultKind::None && tick < 1000; ++tick)
    behind = watch.check(3600 * system::kSecond_ns + tick * 10'000, tick * kMillisecond_ns, tick * kMillisecond_ns,
                         kMillisecond_ns);
  EXPECT_EQ(behind.kind, FaultKind::OddClock);
  EXPECT_LT(behind.seen, 0.002);
  EXPECT_NEAR(behind.allowed, 0.102, 0.001);
}

TEST(ArmClockWatch, ASampleThatIsNotNewerIsForTheTickToJudge) {
  EXPECT_EQ(firstFault(5000, kMillisecond_ns, [](auto, auto) { return std::int64_t{5}; }), -1);
  EXPECT_EQ(firstFault(5000, kMillisecond_ns,
                       [](std::int64_t tick, std::int64_t now_ns) {
                         return now_ns - (tick > 50 ? 3600 * system::kSecond_ns : 0);
                       }),
            -1);
}

// A simulated arm counts its reads, and ticks that are late leave some out; any share of the two is well.
TEST(ArmClockWatch, AnArmThatCountsItsSamplesIsRightWhereTicksAreLate) {
  for (int draw = 0; draw < test::sweep(50, 2000); ++draw) {
    Random random(Seed{700 + static_cast<std::uint64_t>(draw)});
    ArmClockWatch watch;
    std::int64_t now_ns = 0, counted_ns = 0;
    for (int tick = 0; tick < 20'000; ++tick) {
      now_ns += kMillisecond_ns * (1 + static_cast<std::int64_t>(random.below(20) == 0 ? random.below(90) : 0));
      counted_ns += kMillisecond_ns;
      ASSERT_EQ(watch.check(counted_ns, now_ns, now_ns, kMillisecond_ns).kind, FaultKind::None) << tick;
    }
  }
}

// A real arm stamps by a clock of its own, off by a crystal's error; its samples come late by what the line and the
// system make of it, some not at all, and the thread that takes them is held up before and after.
TEST(ArmClockWatch, NoHealthyArmIsTakenForASickOne) {
  for (int draw = 0; draw < test::sweep(50, 2000); ++draw) {
    Random random(Seed{9000 + static_cast<std::uint64_t>(draw)});
    const double rate = 1.0 + random.between(-5e-4, 5e-4);
    const std::int64_t period_ns = draw % 2 == 0 ? kMillisecond_ns : 10 * kMillisecond_ns;
    const auto offset_ns = static_cast<std::int64_t>(random.bits() >> 2U);
    ArmClockWatch watch;
    std::int64_t now_ns = 0, last_ns = 0;
    for (int tick = 0; tick < 10'000; ++tick) {
      now_ns += period_ns;
      if (random.below(50) == 0) now_ns += static_cast<std::int64_t>(random.below(300)) * kMillisecond_ns;
      if (random.below(30) == 0) continue;  // no sample
      const auto held_up_ns =
          static_cast<std::int64_t>(random.below(40) == 0 ? random.below(250) : 0) * kMillisecond_ns;
      const std::int64_t earliest_ns = now_ns,
                         taken_ns = now_ns + static_cast<std::int64_t>(random.below(100)) * held_up_ns / 100;
      now_ns += held_up_ns;
      const std::int64_t old_ns = static_cast<std::int64_t>(random.below(60)) * kMillisecond_ns;  // how old it is
      last_ns = std::max(last_ns + 1000, static_cast<std::int64_t>(rate * static_cast<double>(taken_ns - old_ns)));
      ASSERT_EQ(watch.check(offset_ns + last_ns, earliest_ns, now_ns, period_ns).kind, FaultKind::None)
          << "draw " << draw << ", tick " << tick;
    }
  }
}

TEST(ArmClockWatch, AnyNumbersAtAllAreBorne) {
  Random random(Seed{77});
  ArmClockWatch watch;
  std::int64_t now_ns = 0;
  for (int tick = 0; tick < test::sweep(20'000, 2'000'000); ++tick) {
    now_ns += static_cast<std::int64_t>(random.below(5'000'000));
    const Fault fault = watch.check(static_cast<std::int64_t>(random.bits()), now_ns, now_ns, kMillisecond_ns);
    ASSERT_TRUE(fault.seen >= 0.0 && fault.seen <= 1e9 + 1.0 && fault.allowed >= 0.0) << fault.seen;
  }
}

}  // namespace underact::servo
