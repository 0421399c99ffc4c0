#include "core/registration/steady_tip.h"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/support/random.h"

namespace underact::registration {
namespace {

constexpr std::int64_t kMillisecond_ns = 1'000'000;
const Vec3 kMark(0.05, -0.06, 0.02);

/// What comes of samples every millisecond, at place(k).
template <class Place>
std::optional<HeldTip> hold(SteadyTip& still, int samples, Place place, std::int64_t from_ns = 0) {
  std::optional<HeldTip> held;
  for (int at = 0; at < samples && !held; ++at) held = still.add(from_ns + at * kMillisecond_ns, place(at));
  return held;
}

TEST(SteadyTip, ATipThatRestsGivesItsPlaceAfterHalfASecond) {
  SteadyTip still;
  still.begin();
  EXPECT_FALSE(hold(still, 499, [](int) { return kMark; }));
  EXPECT_NEAR(still.share(), 0.996, 1e-9);
  const std::optional<HeldTip> held = still.add(500 * kMillisecond_ns, kMark);
  ASSERT_TRUE(held);
  EXPECT_EQ(held->p_WT, kMark);
  EXPECT_EQ(held->spread_m, 0.0);
  EXPECT_FALSE(held->moved);
  EXPECT_FALSE(still.isRunning());
  EXPECT_FALSE(still.add(501 * kMillisecond_ns, kMark));
}

TEST(SteadyTip, TheMeanAndTheSpreadAreThoseOfTheSamples) {
  test::Random random({3});
  std::vector<Vec3> samples;
  for (int at = 0; at < 501; ++at) samples.push_back(kMark + random.inBox(0.3e-3));
  SteadyTip still;
  still.begin();
  const std::optional<HeldTip> held = hold(still, 501, [&](int at) { return samples[static_cast<std::size_t>(at)]; });
  ASSERT_TRUE(held);
  Vec3 mean = Vec3::Zero();
  for (const Vec3& sample : samples) mean += sample / 501.0;
  double squares = 0.0;
  for (const Vec3& sample : samples) squares += (sample - mean).squaredNorm() / 501.0;
  EXPECT_LT((held->p_WT - mean).norm(), 1e-15);
  EXPECT_NEAR(held->spread_m, std::sqrt(squares), 1e-12);
  EXPECT_FALSE(held->moved);
}

TEST(SteadyTip, ATipThatMovesIsSaidToHaveMoved) {
  SteadyTip still;
  still.begin();
  std::optional<HeldTip> held = hold(still, 600, [](int at) { return Vec3(kMark + at * 4e-6 * Vec3::UnitX()); });
  ASSERT_TRUE(held);
  EXPECT_TRUE(held->moved);  // 2 mm in all: its spread is only 0.6 mm, its halves are 1 mm apart
  EXPECT_LT(held->spread_m, 1e-3);
  EXPECT_NEAR(held->drift_m, 1e-3, 2e-5);
  still.begin();
  held = hold(still, 600, [](int at) { return Vec3(kMark + (at % 100 < 50 ? 1.2e-3 : -1.2e-3) * Vec3::UnitZ()); });
  ASSERT_TRUE(held);
  EXPECT_TRUE(held->moved);
  EXPECT_NEAR(held->spread_m, 1.2e-3, 1e-6);
}

TEST(SteadyTip, NothingComesBeforeItIsAskedAndAfterItEnded) {
  SteadyTip still;
  EXPECT_FALSE(hold(still, 2000, [](int) { return kMark; }));
  still.begin();
  hold(still, 100, [](int) { return kMark; });
  still.end();
  EXPECT_FALSE(hold(still, 2000, [](int) { return kMark; }));
}

TEST(SteadyTip, AGapInTimeAndAJumpBackBeginItAnew) {
  SteadyTip still;
  still.begin();
  EXPECT_FALSE(hold(still, 400, [](int) { return Vec3(1.0, 1.0, 1.0); }));
  const std::optional<HeldTip> held = hold(
      still, 600, [](int) { return kMark; }, 700 * kMillisecond_ns);  // 0.3 s of silence
  ASSERT_TRUE(held);
  EXPECT_EQ(held->p_WT, kMark);
  still.begin();
  hold(
      still, 400, [](int) { return Vec3(1.0, 1.0, 1.0); }, 10'000 * kMillisecond_ns);
  const std::optional<HeldTip> after = hold(still, 600, [](int) { return kMark; });
  ASSERT_TRUE(after);
  EXPECT_EQ(after->p_WT, kMark);
  EXPECT_EQ(after->samples, 501);
}

TEST(SteadyTip, TheSameSampleOnceMoreCountsOnceAndNoNumberNotAtAll) {
  SteadyTip still;
  still.begin();
  std::optional<HeldTip> held;
  for (int at = 0; at <= 500 && !held; ++at) {
    held = still.add(at * kMillisecond_ns, kMark);
    if (held) break;
    EXPECT_FALSE(still.add(at * kMillisecond_ns, kMark + Vec3::UnitX()));
    EXPECT_FALSE(still.add(at * kMillisecond_ns, Vec3::Constant(kNotANumber)));
  }
  ASSERT_TRUE(held);
  EXPECT_EQ(held->samples, 501);
  EXPECT_EQ(held->p_WT, kMark);
}

}  // namespace
}  // namespace underact::registration
