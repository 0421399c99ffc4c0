#include "core/system/doorbell.h"

#include <gtest/gtest.h>

#include <chrono>
#include <thread>

#include "core/system/channel.h"
#include "core/system/clock.h"

namespace underact::system {
namespace {

TEST(Doorbell, RungBeforeAnyoneWaitsIsHeardAtOnceAndAsOne) {
  Doorbell bell;
  for (int ring = 0; ring < 1000; ++ring) bell.ring();
  EXPECT_TRUE(waitToRead(bell.descriptor(), 0));
  EXPECT_TRUE(bell.waitFor(0));
  EXPECT_FALSE(bell.waitFor(0));
  EXPECT_FALSE(waitToRead(bell.descriptor(), 0));
}

TEST(Doorbell, ThatNobodyRingsIsWaitedForAsLongAsWasSaid) {
  Doorbell bell;
  const std::int64_t begin_ns = monotonicNow_ns();
  EXPECT_FALSE(bell.waitFor(5'000'000));
  EXPECT_GE(monotonicNow_ns() - begin_ns, 5'000'000);
}

TEST(Doorbell, WakesWhoWaits) {
  Doorbell bell;
  const std::int64_t begin_ns = monotonicNow_ns();
  std::thread other([&bell] {
    std::this_thread::sleep_for(std::chrono::milliseconds(10));
    bell.ring();
  });
  EXPECT_TRUE(bell.waitFor(60'000'000'000));
  EXPECT_LT(monotonicNow_ns() - begin_ns, 30'000'000'000);
  other.join();
}

}  // namespace
}  // namespace underact::system
