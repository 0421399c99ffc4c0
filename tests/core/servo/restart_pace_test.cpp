#include "core/servo/restart_pace.h"

#include <gtest/gtest.h>

#include <vector>

namespace underact::servo {
namespace {

constexpr std::int64_t kPaceSecond_ns = 1'000'000'000;

}  // namespace

TEST(RestartPace, TheFirstComesAlmostAtOnceAndEachNextTwiceAsLate) {
  RestartPace pace;
  EXPECT_EQ(pace.next_ns(5 * kPaceSecond_ns), 5 * kPaceSecond_ns + 20'000'000);
  EXPECT_EQ(pace.next_ns(6 * kPaceSecond_ns), 6 * kPaceSecond_ns + 40'000'000);
  EXPECT_EQ(pace.next_ns(7 * kPaceSecond_ns), 7 * kPaceSecond_ns + 80'000'000);
}

TEST(RestartPace, StartsAProgramThatDiesAtOnceAtMostSixTimesAMinute) {
  RestartPace pace;
  std::vector<std::int64_t> starts_ns;
  for (std::int64_t now_ns = 0; now_ns < 3600 * kPaceSecond_ns; now_ns = starts_ns.back() + 1)
    starts_ns.push_back(pace.next_ns(now_ns));
  ASSERT_GT(starts_ns.size(), 300U) << "and it is not given up";
  for (std::size_t at = RestartPace::kMax; at < starts_ns.size(); ++at)
    ASSERT_GE(starts_ns[at] - starts_ns[at - RestartPace::kMax], RestartPace::kWindow_ns) << at;
}

TEST(RestartPace, StartsAProgramThatLastedAMinuteAtOnce) {
  RestartPace pace;
  for (int time = 0; time < 5; ++time) (void)pace.next_ns(time * kPaceSecond_ns);
  EXPECT_EQ(pace.next_ns(100 * kPaceSecond_ns), 100 * kPaceSecond_ns + RestartPace::kFirst_ns);
}

}  // namespace underact::servo
