#include "core/lab/stopwatch.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <chrono>
#include <thread>

#include "tests/support/random.h"

namespace underact::lab {
namespace {

TEST(Quantile, IsTheLeastValueThatTheShareKeepsWithin) {
  test::Random random(test::Seed{20261122});
  for (int round = 0; round < 300; ++round) {
    std::vector<double> values(1 + random.below(30));
    for (double& value : values) value = static_cast<double>(random.below(12));
    for (const double share : {0.1, 0.5, 0.9, 0.99, 1.0}) {
      const double found = quantile(values, share);
      const auto count = [&](const auto& is_meant) { return std::count_if(values.begin(), values.end(), is_meant); };
      const double asked = share * static_cast<double>(values.size());
      EXPECT_EQ(std::count(values.begin(), values.end(), found) > 0, true);
      EXPECT_GE(static_cast<double>(count([&](double value) { return value <= found; })), asked);
      EXPECT_LT(static_cast<double>(count([&](double value) { return value < found; })), asked);
    }
  }
}

TEST(Quantile, OfTwoTheMedianIsTheSmaller) {
  EXPECT_EQ(quantile({3.0, 2.0}, 0.5), 2.0);
  EXPECT_EQ(quantile({3.0, 2.0}, 0.9), 3.0);
  EXPECT_EQ(quantile({7.0}, 0.01), 7.0);
}

TEST(Stopwatch, TellsTheMedianAndTheLongestAndForgets) {
  using std::chrono::milliseconds;
  Stopwatch watch(4);
  EXPECT_EQ(watch.cost().max_ns, 0.0);
  for (const int ms : {0, 0, 0, 20, 60}) watch.time([ms] { std::this_thread::sleep_for(milliseconds(ms)); });
  watch.forgetLast();
  const Cost cost = watch.cost();
  EXPECT_GE(cost.max_ns, 19.9e6);  // a sleep is never shorter; reading the clock takes less than 0.1 ms off
  EXPECT_EQ(cost.p99_ns, cost.max_ns);
  EXPECT_LT(cost.p50_ns, cost.max_ns);
}

}  // namespace
}  // namespace underact::lab
