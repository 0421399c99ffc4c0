#include "core/servo/histogram.h"

#include <algorithm>
#include <vector>

#include "tests/support/property.h"

namespace underact::servo {

TEST(Histogram, IsAllZeroWhileEmpty) {
  const Percentiles none = Histogram{}.percentiles();
  EXPECT_EQ(none.p50_us, 0.0);
  EXPECT_EQ(none.max_us, 0.0);
}

TEST(Histogram, OneDurationIsEveryPercentile) {
  Histogram histogram;
  histogram.add(123'456);
  EXPECT_EQ(histogram.percentiles().p50_us, 123.456);
  EXPECT_EQ(histogram.percentiles().max_us, 123.456);
}

TEST(Histogram, NegativeAndHugeDurationsStayInside) {
  Histogram histogram;
  histogram.add(-5);
  histogram.add(std::int64_t{1} << 62);
  EXPECT_EQ(histogram.count(), 2);
  EXPECT_EQ(histogram.percentiles().max_us, static_cast<double>(std::int64_t{1} << 35) * 1e-3);
}

TEST(Histogram, PercentilesAreWithinOneBucketOfTheSortedOnes) {
  test::Random random(test::Seed{7});
  std::vector<double> all_ns;
  Histogram histogram;
  for (int i = 0; i < 20'000; ++i) {
    const double ns = std::exp(random.between(0.0, 20.0));
    all_ns.push_back(std::floor(ns));
    histogram.add(static_cast<std::int64_t>(ns));
  }
  std::sort(all_ns.begin(), all_ns.end());
  const Percentiles found = histogram.percentiles();
  const auto exact_us = [&](double share) { return 1e-3 * all_ns[static_cast<std::size_t>(share * 19'999)]; };
  // A bucket is 1/32 of its value wide; two neighbours in the sorted list add far less.
  EXPECT_NEAR(found.p50_us, exact_us(0.50), exact_us(0.50) / 30);
  EXPECT_NEAR(found.p99_us, exact_us(0.99), exact_us(0.99) / 30);
  EXPECT_NEAR(found.p999_us, exact_us(0.999), exact_us(0.999) / 30);
  EXPECT_EQ(found.max_us, 1e-3 * all_ns.back());
}

}  // namespace underact::servo
