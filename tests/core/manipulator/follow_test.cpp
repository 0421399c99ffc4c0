#include "core/manipulator/follow.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <iostream>
#include <numeric>

#include "core/manipulator/global.h"
#include "tests/core/manipulator/hand.h"

namespace underact::manipulator {
namespace {

constexpr double kTick_s = 1e-3;

Pose pointingAt(double angle_rad, const Vec3& p_WT) {
  return test::poseOf(test::about(Vec3::UnitZ(), angle_rad) * test::tipAt(Vec3::Zero()).linear(), p_WT);
}

/// The golden vectors' ring whose stylus is turned away: minima at 0.4766 rad and, 187 mJ above it, at -0.5253.
Manipulator opposed() {
  Wanted wanted;
  wanted.chain = test::ring();
  wanted.orientation = Orientation::Angle;
  wanted.ko_N_m_per_rad = 0.25;
  return test::made(wanted);
}

/// A hand that wanders, and now and then is somewhere else at once.
class WildHand {
 public:
  explicit WildHand(std::uint64_t seed, const Vec3& about_W) : random_({seed}), about_W_(about_W) {}
  Pose next() {
    if (random_.below(50) == 0) X_WT_ = test::anyPose(random_, 0.15), X_WT_.translation() += about_W_;
    if (random_.below(50) == 0) X_WT_.translation() = about_W_;
    X_WT_.translation() += 0.0003 * random_.direction();
    X_WT_.linear() = test::about(random_.direction(), 0.003) * X_WT_.linear();
    return X_WT_;
  }

 private:
  test::property::Random random_;
  Vec3 about_W_;
  Pose X_WT_ = Pose::Identity();
};

/// All that a tick gives, in one row of numbers.
std::array<double, 24> numbersOf(const Followed& followed, const State& state) {
  std::array<double, 24> all{};
  std::size_t next = 0;
  for (const Vec3& v : {followed.p_WP, followed.at.f_W, followed.moment_W, followed.f_along_T_W}) {
    for (const double x : v) all[next++] = x;
  }
  for (const double theta : state.theta) all[next++] = theta;
  all[next++] = followed.left;
  all[next++] = followed.better_J;
  all[next++] = followed.at.energy_J;
  all[next++] = followed.steps;
  return all;
}

std::vector<test::Held> allOnes() {
  std::vector<test::Held> all = test::heldOnes();
  for (const std::size_t i : {0UL, 2UL, 3UL, 4UL}) {  // and those with a closed form, or with the thesis's law
    Wanted wanted;
    wanted.chain = all[i].manipulator.chain;
    wanted.orientation = i == 2 ? Orientation::None : Orientation::Axis;
    wanted.ko_N_m_per_rad = 0.25;
    wanted.law = i == 0 ? ForceLaw::Thesis52 : ForceLaw::Energy;
    all.push_back({all[i].name + " by formula", test::made(wanted), all[i].X_WT});
  }
  return all;
}

}  // namespace

TEST(Follow, TheTargetNeverMovesFasterThanItsSlewWhateverTheHandDoes) {
  for (const test::Held& one : allOnes()) {
    const Manipulator& m = one.manipulator;
    WildHand hand(20070641, one.X_WT.translation());
    State state;
    Vec3 last = follow(m, one.X_WT, 0.0, state).p_WP;
    for (int tick = 0; tick < test::property::sweep(3'000, 100'000); ++tick) {
      const double dt_s = tick % 7 == 0 ? 2e-3 : kTick_s;
      const Followed followed = follow(m, hand.next(), dt_s, state);
      ASSERT_TRUE(followed.p_WP.allFinite()) << one.name << ", tick " << tick;
      ASSERT_TRUE(followed.moment_W.allFinite()) << one.name << ", tick " << tick;
      ASSERT_TRUE(followed.is_unique) << one.name << ", tick " << tick;
      ASSERT_LE((followed.p_WP - last).norm(), kSlew_m_per_s * dt_s * (1.0 + 1e-12)) << one.name << ", tick " << tick;
      ASSERT_LE(followed.steps, m.options.max_steps) << one.name << ", tick " << tick;
      last = followed.p_WP;
    }
  }
}

TEST(Follow, ASmoothHandTakesFewStepsAndKeepsTheTolerance) {
  std::array<int, 21> taken{};
  for (const test::Held& one : test::heldOnes()) {
    test::property::Random random(test::property::Seed{20070642});
    const test::Loop loop{one.X_WT.translation(), 0.03 * random.direction(), 0.02 * random.direction(),
                          0.005 * random.direction()};
    const Vec3 about_W = random.direction();
    int cold_steps = 0;
    State state = settledState(one.manipulator, test::poseOf(one.X_WT.linear(), loop.place(0.0)), cold_steps);
    for (int tick = 1; tick <= test::property::sweep(1'000, 50'000); ++tick) {
      const double s = 0.006 * tick;  // some 0.2 m/s
      const Pose X_WT = test::poseOf(test::about(about_W, 0.2 * std::sin(s)) * one.X_WT.linear(), loop.place(s));
      const Followed followed = follow(one.manipulator, X_WT, kTick_s, state);
      ASSERT_LE(followed.left, one.manipulator.options.tolerance) << one.name << ", tick " << tick;
      ASSERT_FALSE(followed.slewing) << one.name << ", tick " << tick;
      ++taken[static_cast<std::size_t>(followed.steps)];
    }
  }
  std::cout << "[    STEPS ]";
  for (std::size_t steps = 0; steps < taken.size(); ++steps) std::cout << " " << steps << ": " << taken[steps];
  std::cout << "\n";
  const int ticks = std::accumulate(taken.begin(), taken.end(), 0);
  EXPECT_GT(3 * taken[1], 2 * ticks);  // it starts where the joints go on as they did
  // More where a minimum is flat: an arm that is just stretched, a pole that the hand passes.
  EXPECT_LT(std::accumulate(taken.begin() + 4, taken.end(), 0), ticks / 100);
}

TEST(Follow, TwoRunsAreEqualToTheBit) {
  for (const test::Held& one : allOnes()) {
    WildHand first(20070643, one.X_WT.translation()), second(20070643, one.X_WT.translation());
    State here, there;
    for (int tick = 0; tick < test::property::sweep(1'000, 20'000); ++tick) {
      const Followed a = follow(one.manipulator, first.next(), kTick_s, here);
      const Followed b = follow(one.manipulator, second.next(), kTick_s, there);
      const std::array<double, 24> left = numbersOf(a, here), right = numbersOf(b, there);
      ASSERT_EQ(std::memcmp(left.data(), right.data(), sizeof left), 0) << one.name << ", tick " << tick;
    }
  }
}

TEST(Follow, ABetterMinimumIsAnnouncedAndTakenAfterAWhileAndTheTargetGoesThereSlowly) {
  const Manipulator m = opposed();
  const Pose X_WT = pointingAt(3.0, {0.055, 0, 0});
  State state;
  state.theta[0] = -0.5252628586;
  state.p_WP = test::energyAt(m, X_WT, state.theta).tip.X_WT.translation();
  state.begun = true;
  int announced = 0, left = 0, arrived = 0;
  for (int tick = 1; tick <= 2'000 && arrived == 0; ++tick) {
    const Vec3 last = state.p_WP;
    const Followed followed = follow(m, X_WT, kTick_s, state);
    ASSERT_LE((followed.p_WP - last).norm(), kSlew_m_per_s * kTick_s * (1.0 + 1e-12));
    if (followed.better_J > 0.0 && announced == 0) announced = tick;
    ASSERT_NEAR(followed.at.theta[0], left > 0 || followed.at.theta[0] > 0.0 ? 0.4766366887 : -0.5252628586, 1e-9);
    if (followed.at.theta[0] > 0.0 && left == 0) {
      left = tick;
      EXPECT_TRUE(followed.slewing);
      EXPECT_NEAR(followed.better_J, 1e-3 * (1142.3778041233577 - 955.42366108697), 1e-9);
    }
    if (left > 0 && !followed.slewing) arrived = tick;
  }
  ASSERT_GT(announced, 0);
  EXPECT_LE(announced, 400);
  EXPECT_NEAR(left - announced, kBetterFor_s / kTick_s, 2.0);
  const double travel_m = 2.0 * 0.05 * std::sin(0.5 * (0.4766366887 + 0.5252628586));
  EXPECT_NEAR(arrived - left, travel_m / (kSlew_m_per_s * kTick_s), 2.0);
  EXPECT_NEAR(state.theta[0], 0.4766366886973705, 1e-9);
}

TEST(Follow, TheLeastMinimumIsKept) {
  const Manipulator m = opposed();
  const Pose X_WT = pointingAt(3.0, {0.055, 0, 0});
  int cold_steps = 0;
  State state = settledState(m, X_WT, cold_steps);
  for (int tick = 0; tick < 2'000; ++tick) {
    const Followed followed = follow(m, X_WT, kTick_s, state);
    ASSERT_EQ(followed.better_J, 0.0);
    ASSERT_NEAR(followed.at.theta[0], 0.4766366886973705, 1e-9);
  }
}

TEST(Follow, FromALimitTheWatchFindsTheNearerOneRoundTheOtherWay) {
  // The stylus at 2.5 rad of a joint that turns from -2 to 2: held at -2 it is 1.78 rad away, at 2 half a rad.
  for (const double shift_rad : {0.0, 5.0}) {  // the joint's room wherever it is
    Wanted wanted;
    wanted.chain = test::ring(shift_rad - 2.0, shift_rad + 2.0);
    wanted.method = Method::Iterative;
    const Manipulator m = test::made(wanted);
    const Pose X_WT = pointingAt(0.0, 0.06 * Vec3(std::cos(shift_rad + 2.5), std::sin(shift_rad + 2.5), 0.0));
    State state;
    state.theta[0] = shift_rad - 2.0;
    state.p_WP = test::energyAt(m, X_WT, state.theta).tip.X_WT.translation();
    state.begun = true;
    bool announced = false;
    for (int tick = 0; tick < 1'000; ++tick) announced = follow(m, X_WT, kTick_s, state).better_J > 0.0 || announced;
    EXPECT_TRUE(announced) << shift_rad;
    EXPECT_EQ(state.theta[0], shift_rad + 2.0);
  }
}

TEST(Follow, AStylusThatIsNowhereLeavesThePastAsItWas) {
  for (const test::Held& one : allOnes()) {
    int cold_steps = 0;
    State state = settledState(one.manipulator, one.X_WT, cold_steps);
    const Followed before = follow(one.manipulator, one.X_WT, kTick_s, state);
    for (const double strange : {kNotANumber, kInfinity}) {
      Pose nowhere = one.X_WT, unturned = one.X_WT;
      nowhere.translation().y() = strange;
      unturned.linear()(0, 2) = strange;
      for (const Pose& X_WT : {nowhere, unturned}) {
        EXPECT_FALSE(follow(one.manipulator, X_WT, kTick_s, state).is_unique) << one.name;
      }
    }
    const Followed after = follow(one.manipulator, one.X_WT, kTick_s, state);
    EXPECT_TRUE(after.is_unique) << one.name;
    EXPECT_LE((after.p_WP - before.p_WP).norm(), 1e-10) << one.name;
  }
}

TEST(Follow, TheThesissLawStandsWhereItGoesOn) {
  Wanted wanted;
  wanted.chain = test::ring();
  wanted.orientation = Orientation::Angle;
  wanted.ko_N_m_per_rad = 0.25;
  wanted.law = ForceLaw::Thesis52;
  const Manipulator m = test::made(wanted);
  const Pose X_WT = pointingAt(3.0, {0.055, 0, 0});  // its tip is at the stylus's place, whatever the turn
  int cold_steps = 1;
  State state = settledState(m, X_WT, cold_steps);
  EXPECT_EQ(cold_steps, 0);
  EXPECT_NEAR(state.theta[0], 0.0, 1e-15);
  EXPECT_FALSE(follow(m, X_WT, kTick_s, state).slewing);
}

TEST(Follow, AFirstTickStartsAtHomeAndAColdStartAtTheLeastMinimum) {
  const Manipulator m = opposed();
  const Pose X_WT = pointingAt(-3.0, {0.055, 0, 0});  // mirrored: the least minimum is at -0.4766
  int cold_steps = 0;
  EXPECT_NEAR(settledState(m, X_WT, cold_steps).theta[0], -0.4766366886973705, 1e-9);
  EXPECT_GT(cold_steps, 0);
  State state;
  const Followed first = follow(m, X_WT, kTick_s, state);
  EXPECT_FALSE(first.slewing);  // there is nowhere to come from
  EXPECT_TRUE(state.begun);
  EXPECT_EQ(first.p_WP, first.at.tip.X_WT.translation());
}

}  // namespace underact::manipulator
