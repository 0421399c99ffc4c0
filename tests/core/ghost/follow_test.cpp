#include "core/ghost/follow.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <functional>
#include <utility>

#include "tests/support/property.h"

namespace underact::ghost {
namespace {

constexpr std::int64_t kMillisecond_ns = 1'000'000;
constexpr int kWhole = 4002;  // ticks that the way takes, and one that rounding may ask for

/// 4 s along x at 50 mm/s, from the middle of W.
Trajectory straight() {
  Trajectory trajectory;
  trajectory.rows = {{0.0, {Vec3::Zero(), Vec3::UnitZ()}}, {4.0, {{0.200, 0.0, 0.0}, Vec3::UnitZ()}}};
  return trajectory;
}

/// Ticks at 1 kHz, with the tip where tip_W says at each time since the first, s.
struct Walk {
  Options options;
  Trajectory trajectory = straight();
  State state = {};
  std::int64_t now_ns = 7 * kMillisecond_ns;  // an arm's clock begins anywhere

  void ticks(int count, const std::function<Vec3(double)>& tip_W) {
    for (int tick = 0; tick < count; ++tick, now_ns += kMillisecond_ns)
      state =
          advanced(trajectory, options, state, now_ns, tip_W(1e-9 * static_cast<double>(now_ns - 7 * kMillisecond_ns)));
  }
};

/// What goes with the ghost, offset_m aside.
std::function<Vec3(double)> beside(double offset_m) {
  return [offset_m](double time_s) { return Vec3(std::min(0.05 * time_s, 0.2), offset_m, 0.0); };
}

Vec3 stays(double) {
  return Vec3::Zero();
}

TEST(Follow, WhoIsExactlyThereIsNoWayOff) {
  Walk walk;
  walk.ticks(kWhole, beside(0.0));
  EXPECT_EQ(walk.state.phase, Phase::Ended);
  EXPECT_NEAR(walk.state.tally.followed_s, 4.0, 0.0011);
  EXPECT_NEAR(walk.state.tally.largest_m, 0.0, 1e-9);
  EXPECT_NEAR(walk.state.tally.nearShare(), 1.0, 1e-12);
  EXPECT_EQ(walk.state.tally.waited_s, 0.0);
}

TEST(Follow, TheMeanTheLargestAndTheShareOfAHandThatIsNearForAQuarter) {
  Walk walk{.options = {.begins_near = false}};
  walk.ticks(kWhole, [](double time_s) { return beside(time_s <= 1.0 ? 0.006 : 0.016)(time_s); });
  EXPECT_NEAR(walk.state.tally.mean_m(), 0.25 * 0.006 + 0.75 * 0.016, 1e-5);
  EXPECT_NEAR(walk.state.tally.largest_m, 0.016, 1e-12);
  EXPECT_NEAR(walk.state.tally.nearShare(), 0.25, 1e-3);
}

TEST(Follow, WhoLagsIsAsFarOffAsTheGhostWentMeanwhile) {
  Walk walk{.options = {.begins_near = false}};
  walk.ticks(3000, [](double time_s) { return Vec3(0.05 * std::max(0.0, time_s - 0.2), 0.0, 0.0); });
  EXPECT_NEAR(walk.state.distance_m, 0.010, 1e-9);
}

TEST(Follow, ItBeginsWhenTheTipIsThere) {
  Walk walk;
  walk.ticks(1000, [](double) { return Vec3(0.0, 0.0101, 0.0); });
  EXPECT_EQ(walk.state.phase, Phase::Ready);
  EXPECT_EQ(walk.state.time_s, 0.0);
  EXPECT_NEAR(walk.state.distance_m, 0.0101, 1e-15);
  walk.ticks(100, [](double) { return Vec3(0.0, 0.0099, 0.0); });
  EXPECT_EQ(walk.state.phase, Phase::Going);
  EXPECT_NEAR(walk.state.time_s, 0.100, 1e-9);
  EXPECT_NEAR(walk.state.tally.followed_s, 0.100, 1e-9) << "nothing counted before";
  Walk at_once{.options = {.begins_near = false}};
  at_once.ticks(101, [](double) { return Vec3(0.0, 0.0150, 0.0); });
  EXPECT_NEAR(at_once.state.time_s, 0.100, 1e-9);
}

TEST(Follow, ItWaitsForWhoIsTooFarAndGoesOnWhenHeHasComeHalfTheWay) {
  Walk walk;
  walk.ticks(2000, stays);
  EXPECT_EQ(walk.state.phase, Phase::Waiting);
  EXPECT_NEAR(walk.state.ghost.p_WG.x(), 0.020, 1e-4);
  EXPECT_NEAR(walk.state.tally.followed_s, 0.4, 2e-3);
  EXPECT_NEAR(walk.state.tally.waited_s, 1.6, 2e-3);
  walk.ticks(500, [](double) { return Vec3(0.009, 0.0, 0.0); });  // 11 mm
  EXPECT_EQ(walk.state.phase, Phase::Waiting);
  walk.ticks(10, [](double) { return Vec3(0.011, 0.0, 0.0); });
  EXPECT_EQ(walk.state.phase, Phase::Going);
  walk.options.waits_beyond_m = 0.050;
  walk.ticks(500, stays);
  EXPECT_NEAR(walk.state.ghost.p_WG.x(), 0.0455, 2e-4);
  EXPECT_EQ(walk.state.phase, Phase::Going) << "46 mm";
  walk.ticks(500, stays);
  EXPECT_EQ(walk.state.phase, Phase::Waiting);
  walk.now_ns -= 100 * kMillisecond_ns;
  const double waited_s = walk.state.tally.waited_s;
  walk.ticks(1, stays);
  EXPECT_EQ(walk.state.tally.waited_s, waited_s) << "another clock";
  walk.options.waits = false;
  walk.ticks(1, stays);
  EXPECT_EQ(walk.state.phase, Phase::Going);
}

TEST(Follow, ItWaitsForNobodyWhereItIsNotAsked) {
  Walk walk{.options = {.waits = false}};
  walk.ticks(kWhole, stays);
  EXPECT_EQ(walk.state.phase, Phase::Ended);
  EXPECT_NEAR(walk.state.tally.largest_m, 0.200, 1e-9);
}

TEST(Follow, AtHalfTheSpeedItTakesTwiceAsLongAndTimesAreTheHands) {
  Walk walk{.options = {.speed = 0.5}};
  walk.ticks(4001, [](double time_s) { return beside(0.002)(0.5 * time_s); });
  EXPECT_NEAR(walk.state.time_s, 2.0, 1e-9);
  EXPECT_NEAR(walk.state.tally.followed_s, 4.0, 1e-9);
  EXPECT_NEAR(walk.state.tally.mean_m(), 0.002, 1e-9);
}

TEST(Follow, NoSpeedIsBeyondWhatAHandCanFollow) {
  for (const auto& [asked, is] : {std::pair(100.0, kFastest), std::pair(0.0, kSlowest), std::pair(-1.0, kSlowest)}) {
    Walk walk{.options = {.speed = asked, .waits = false}};
    walk.ticks(1001, stays);
    EXPECT_NEAR(walk.state.time_s, is, 1e-9) << asked;
  }
}

TEST(Follow, WhereItLoopsEachRoundCountsForItself) {
  Walk walk{.options = {.loops = true, .waits = false}};
  walk.ticks(kWhole, beside(0.003));
  EXPECT_EQ(walk.state.rounds, 1);
  ASSERT_TRUE(walk.state.last_round);
  EXPECT_NEAR(walk.state.last_round->mean_m(), 0.003, 1e-9);
  walk.ticks(1000, beside(0.003));  // the tip is at the end still
  EXPECT_EQ(walk.state.phase, Phase::Ready);
  walk.ticks(kWhole, stays);
  EXPECT_EQ(walk.state.rounds, 2);
  EXPECT_NEAR(walk.state.last_round->largest_m, 0.200, 1e-9);
  EXPECT_NEAR(walk.state.last_round->followed_s, 4.0, 2e-3);
}

TEST(Follow, AtItsEndItStaysAndNothingCountsAnyMore) {
  Walk walk;
  walk.ticks(kWhole, beside(0.0));
  const Tally before = walk.state.tally;
  walk.ticks(1000, stays);
  EXPECT_EQ(walk.state.phase, Phase::Ended);
  EXPECT_EQ(walk.state.rounds, 1);
  EXPECT_EQ(walk.state.tally.followed_s, before.followed_s);
  EXPECT_EQ(walk.state.tally.largest_m, before.largest_m);
  EXPECT_NEAR(walk.state.distance_m, 0.200, 1e-12) << "but it is told";
}

TEST(Follow, WhileItRestsNothingCountsAndNothingIsMadeUpFor) {
  Walk walk;
  walk.ticks(1001, beside(0.0));
  walk.options.plays = false;
  walk.ticks(5000, [](double) { return Vec3(0.05, 0.0, 0.0); });
  EXPECT_NEAR(walk.state.time_s, 1.0, 1e-9);
  EXPECT_NEAR(walk.state.tally.followed_s, 1.0, 1e-9);
  walk.ticks(1000, stays);
  EXPECT_NEAR(walk.state.distance_m, 0.050, 1e-9) << "but it is told";
  walk.options.plays = true;
  walk.ticks(100, [](double) { return Vec3(0.05, 0.0, 0.0); });
  EXPECT_NEAR(walk.state.time_s, 1.1, 1e-9);
}

TEST(Follow, AnotherClockAndAPauseOfTheArmTakeItNowhere) {
  Walk walk;
  walk.ticks(101, beside(0.0));
  const double time_s = walk.state.time_s;
  walk.now_ns -= 3'000 * kMillisecond_ns;
  walk.ticks(1, stays);
  walk.now_ns += 9'000 * kMillisecond_ns;
  walk.ticks(1, stays);
  EXPECT_EQ(walk.state.time_s, time_s);
  walk.ticks(1, stays);
  EXPECT_NEAR(walk.state.time_s, time_s + 0.001, 1e-12);
}

TEST(Follow, ATipThatIsNoNumberChangesNothing) {
  Walk walk;
  walk.ticks(500, beside(0.0));
  const State before = walk.state;
  walk.ticks(100, [](double) { return Vec3(kNotANumber, 0.0, 0.0); });
  EXPECT_EQ(walk.state.time_s, before.time_s);
  EXPECT_EQ(walk.state.distance_m, before.distance_m);
  EXPECT_EQ(walk.state.tick_ns, before.tick_ns);
}

// Whatever the hand does and the options are, numbers stay finite and say what they are called.
TEST(Follow, AnyHandGetsNumbersThatAreOnesAndFitTogether) {
  test::Random random({20261123});
  for (int draw = 0; draw < test::sweep(100, 2'000); ++draw) {
    Walk walk{.options = {.speed = random.between(0.0, 3.0),
                          .loops = random.below(2) == 0,
                          .begins_near = random.below(2) == 0,
                          .waits = random.below(2) == 0,
                          .waits_beyond_m = random.between(0.005, 0.1)}};
    for (int part = 0; part < 40; ++part) {
      const State before = walk.state;
      const Vec3 p_WT = random.inBox(0.2);
      walk.options.plays = random.below(8) != 0;
      walk.ticks(100, [&p_WT](double) { return p_WT; });
      const Tally& tally = walk.state.tally;
      ASSERT_TRUE(walk.state.ghost.p_WG.allFinite());
      ASSERT_LE(walk.state.time_s, 4.0);
      ASSERT_GE(walk.state.time_s + 4.0 * (walk.state.rounds - before.rounds), before.time_s);
      ASSERT_LE(tally.near_s, tally.followed_s);
      ASSERT_LE(tally.followed_s + tally.waited_s, 4.1);
      ASSERT_LE(tally.mean_m(), tally.largest_m * (1.0 + 1e-9));
    }
  }
}

}  // namespace
}  // namespace underact::ghost
