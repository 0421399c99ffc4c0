#include "core/ghost/trajectory.h"

#include <gtest/gtest.h>

#include <cmath>

#include "core/arm/forward.h"

namespace underact::ghost {
namespace {

const arm::Geometry& geometry() {
  return arm::findPreset(arm::kDefaultArm)->geometry;
}

/// A hand that swings gently about where the arm rests.
arm::JointAngles jointsAt(double time_s) {
  const double swing = 0.2 * std::sin(2.0 * time_s);
  return {swing, 0.6 + swing, 2.4 - swing, 0.3 * swing, 0.8, swing};
}

Trajectory swing(double rate_hz, int ticks) {
  TrajectoryBuilder maker(geometry(), rate_hz);
  for (int tick = 0; tick < ticks; ++tick) maker.add(jointsAt(tick / rate_hz), false);
  return maker.take();
}

/// 0 to 1 s along x from 0 to 10 mm; then, elsewhere, 1.5 to 2 s along y.
Trajectory withGap() {
  const auto at = [](double x_m, double y_m) { return StylusPose{{x_m, y_m, 0.0}, Vec3::UnitZ()}; };
  Trajectory trajectory;
  trajectory.rows = {{0.0, at(0.0, 0.0)}, {1.0, at(0.010, 0.0)}, {1.5, at(0.050, 0.0), true}, {2.0, at(0.050, 0.010)}};
  return trajectory;
}

TEST(Trajectory, IsWhereTheHandWasAtEveryTickThoughAtMost250RowsASecondAreKept) {
  for (const double rate_hz : {100.0, 250.0, 600.0, 1000.0, 10'000.0}) {
    const int ticks = static_cast<int>(3.0 * rate_hz) + 2;  // it ends between two rows
    const Trajectory trajectory = swing(rate_hz, ticks);
    EXPECT_LE(static_cast<double>(trajectory.rows.size()), 3.0 * kRowsPerSecond + 3.0) << rate_hz;
    EXPECT_EQ(trajectory.duration_s(), (ticks - 1) / rate_hz);
    EXPECT_EQ(trajectory.jumps, 0);
    for (int tick = 0; tick < ticks; tick += 7) {
      const Pose X_WG = arm::tipPose(geometry(), jointsAt(tick / rate_hz));
      const StylusPose place = poseAt(trajectory, tick / rate_hz);
      // What a line cuts off a bend: the acceleration, below 2 m/s2 here, times 4 ms squared, over 8.
      ASSERT_LT((place.p_WG - X_WG.translation()).norm(), 4e-6) << rate_hz << " " << tick;
      ASSERT_LT((place.stylus_W - X_WG.linear().col(2)).norm(), 1e-4);
      ASSERT_NEAR(place.stylus_W.norm(), 1.0, 1e-12);
    }
  }
}

TEST(Trajectory, IsHeldAtItsBeginningAndItsEnd) {
  const Trajectory trajectory = withGap();
  EXPECT_EQ(poseAt(trajectory, -1.0).p_WG, trajectory.rows.front().place.p_WG);
  EXPECT_EQ(poseAt(trajectory, kNotANumber).p_WG, trajectory.rows.front().place.p_WG);
  EXPECT_EQ(poseAt(trajectory, 2.0).p_WG, trajectory.rows.back().place.p_WG);
  EXPECT_EQ(poseAt(trajectory, kInfinity).p_WG, trajectory.rows.back().place.p_WG);
}

TEST(Trajectory, StandsStillBeforeAGapAndIsElsewhereAfterIt) {
  const Trajectory trajectory = withGap();
  EXPECT_NEAR(poseAt(trajectory, 0.25).p_WG.x(), 0.0025, 1e-15);
  EXPECT_EQ(poseAt(trajectory, 1.0).p_WG.x(), 0.010);
  EXPECT_EQ(poseAt(trajectory, 1.499).p_WG.x(), 0.010);
  EXPECT_EQ(poseAt(trajectory, 1.5).p_WG.x(), 0.050);
  EXPECT_NEAR(poseAt(trajectory, 1.75).p_WG.y(), 0.005, 1e-15);
}

TEST(Trajectory, KeepsTheTickAfterAGapAndCountsItAsAJumpOnlyWhereTheHandIsElsewhere) {
  TrajectoryBuilder maker(geometry(), 1000.0);
  for (int tick = 0; tick < 100; ++tick) maker.add(jointsAt(0.0), tick == 0 || tick == 33);  // stopped and started
  for (int tick = 0; tick < 99; ++tick) maker.add(jointsAt(0.7), tick == 2);
  for (int tick = 0; tick < 3; ++tick) maker.add(jointsAt(0.0), tick == 0);
  const Trajectory trajectory = maker.take();
  EXPECT_EQ(trajectory.jumps, 1) << "nothing says that the second one is no motion";
  EXPECT_FALSE(trajectory.rows.front().begins_anew);
  EXPECT_EQ(poseAt(trajectory, 0.1985).p_WG, arm::tipPose(geometry(), jointsAt(0.7)).translation());
  EXPECT_EQ(poseAt(trajectory, 0.199).p_WG, arm::tipPose(geometry(), jointsAt(0.0)).translation());
}

TEST(Trajectory, JointsThatAreNoNumbersStandStill) {
  TrajectoryBuilder maker(geometry(), 250.0);
  maker.add(jointsAt(0.3), false);
  maker.add({kNotANumber, 0, 0, 0, 0, 0}, false);
  maker.add({0, 0, kInfinity, 0, 0, 0}, true);
  const Trajectory trajectory = maker.take();
  ASSERT_EQ(trajectory.rows.size(), 3U);
  for (const TrajectoryRow& row : trajectory.rows) EXPECT_EQ(row.place.p_WG, trajectory.rows.front().place.p_WG);
  EXPECT_EQ(trajectory.jumps, 0);
}

TEST(Trajectory, HasNoPointsWithoutTicks) {
  EXPECT_TRUE(TrajectoryBuilder(geometry(), 1000.0).take().rows.empty());
}

TEST(Trajectory, AStylusThatTurnsRoundHasADirectionAllTheWay) {
  Trajectory trajectory;
  trajectory.rows = {{0.0, {Vec3::Zero(), Vec3::UnitZ()}}, {1.0, {Vec3::Zero(), -Vec3::UnitZ()}}};
  for (double time_s = 0.0; time_s <= 1.0; time_s += 0.125)
    EXPECT_NEAR(poseAt(trajectory, time_s).stylus_W.norm(), 1.0, 1e-15) << time_s;
}

TEST(Trajectory, InAMirrorIsAtTheOtherSideAndTwiceItself) {
  const Trajectory trajectory = swing(250.0, 300), other = mirrored(trajectory, {}), again = mirrored(other, {});
  ASSERT_EQ(other.rows.size(), trajectory.rows.size());
  for (std::size_t index = 0; index < trajectory.rows.size(); ++index) {
    const StylusPose &one = trajectory.rows[index].place, &image = other.rows[index].place;
    EXPECT_EQ(image.p_WG, Vec3(-one.p_WG.x(), one.p_WG.y(), one.p_WG.z()));
    EXPECT_EQ(image.stylus_W, Vec3(-one.stylus_W.x(), one.stylus_W.y(), one.stylus_W.z()));
    EXPECT_EQ(again.rows[index].place.p_WG, one.p_WG);
  }
  EXPECT_GT(poseAt(trajectory, 0.5).p_WG.x() - poseAt(other, 0.5).p_WG.x(), 0.01) << "it was at one side";
  const StylusPose &one = trajectory.rows[7].place,
                   image = mirrored(trajectory, {1, 0.1}).rows[7].place;  // that of another arm
  EXPECT_EQ(image.p_WG, Vec3(one.p_WG.x(), 0.2 - one.p_WG.y(), one.p_WG.z()));
  EXPECT_EQ(image.stylus_W, Vec3(one.stylus_W.x(), 0.0 - one.stylus_W.y(), one.stylus_W.z()));
}

TEST(WayAhead, IsInEvenStepsAndEndsAtAGapAndAtTheEnd) {
  const Trajectory trajectory = withGap();
  const std::vector<Vec3> free = ahead(trajectory, 0.2, 0.4, 5);
  ASSERT_EQ(free.size(), 5U);
  for (std::size_t step = 0; step < 5; ++step)
    EXPECT_NEAR(free[step].x(), 0.002 + 0.001 * static_cast<double>(step), 1e-15);
  EXPECT_NEAR(ahead(trajectory, 0.8, 1.0, 5).back().x(), 0.010, 1e-15) << "not across the gap";
  EXPECT_NEAR(ahead(trajectory, 0.8, 0.4, 5).back().x(), 0.010, 1e-15) << "nor into it";
  EXPECT_TRUE(ahead(trajectory, 1.2, 1.0, 5).empty()) << "it stands still there";
  EXPECT_NEAR(ahead(trajectory, 1.6, 1.0, 5).back().y(), 0.010, 1e-15);
  EXPECT_TRUE(ahead(trajectory, 2.0, 1.0, 5).empty());
}

}  // namespace
}  // namespace underact::ghost
