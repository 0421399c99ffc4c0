#include "core/control/velocity.h"

#include <cmath>
#include <utility>
#include <vector>

#include "tests/core/control/tick.h"
#include "tests/support/property.h"

namespace underact::control {
namespace {

constexpr double kStep_m = 55e-6;  // an encoder's, at the tip

std::vector<std::pair<const char*, Velocity>> everyFilter() {
  return {{"low-pass", LowPass{}},
          {"raw", RawDifference{}},
          {"adaptive window", AdaptiveWindow{16, Vec3::Constant(kStep_m)}},
          {"longest window", AdaptiveWindow{kLongestWindow, Vec3::Constant(kStep_m)}},
          {"Kalman", Kalman{20e-6, 10.0}}};
}

/// So long at a steady rate that each filter has settled.
VelocityState moving(const Velocity& velocity, const Vec3& rate_W, int ticks = 3000) {
  VelocityState state;
  for (int n = 0; n <= ticks; ++n) updateRate(velocity, state, kTick_s * n * rate_W, n == 0 ? 0.0 : kTick_s);
  return state;
}

TEST(Velocity, EveryFilterEndsAtTheRateOfASteadyMotion) {
  const Vec3 rate_W(0.1, -0.2, 0.05);
  for (const auto& [name, velocity] : everyFilter()) {
    // Places of up to 0.6 m lose 1.1e-16 m each, over 1 ms.
    EXPECT_LE((moving(velocity, rate_W).rate_W - rate_W).cwiseAbs().maxCoeff(), 1e-12) << name;
  }
}

TEST(Velocity, NoFilterTakesTheFirstSampleForAMotion) {
  for (const auto& [name, velocity] : everyFilter()) {
    VelocityState state;
    updateRate(velocity, state, {0.05, -0.02, 0.1}, kTick_s);
    EXPECT_EQ(state.rate_W, kZero) << name;
    updateRate(velocity, state, {0.05, -0.02, 0.1}, kTick_s);
    EXPECT_EQ(state.rate_W, kZero) << name;
  }
}

TEST(Velocity, ATargetThatIsPutElsewhereIsNoRateUnderAnyFilter) {
  const Vec3 rate_W(0.1, -0.2, 0.05), jump_W(0.03, 0.02, -0.05);
  for (const auto& [name, velocity] : everyFilter()) {
    VelocityState still = moving(velocity, rate_W), jumped = still;
    jumped.has_last = false;  // as tick::carryOver() leaves it
    for (int n = 3001; n < 3100; ++n) {
      const Vec3 e_W = kTick_s * n * rate_W;
      updateRate(velocity, still, e_W, kTick_s);
      updateRate(velocity, jumped, e_W + jump_W, kTick_s);
      ASSERT_LE((jumped.rate_W - still.rate_W).cwiseAbs().maxCoeff(), 1e-12) << name << ", tick " << n;
    }
  }
}

TEST(Velocity, AnotherFilterGoesOnFromTheRateThatTheOneBeforeItHad) {
  const Vec3 rate_W(0.1, -0.2, 0.05);
  for (const auto& [from, before] : everyFilter()) {
    for (const auto& [to, after] : everyFilter()) {
      VelocityState state = moving(before, rate_W);
      for (int n = 3001; n < 3050; ++n) {
        updateRate(after, state, kTick_s * n * rate_W, kTick_s);
        ASSERT_LE((state.rate_W - rate_W).cwiseAbs().maxCoeff(), 1e-11) << from << " to " << to << ", tick " << n;
      }
    }
  }
}

TEST(Velocity, ATickWithoutTimeChangesNoRate) {
  for (const auto& [name, velocity] : everyFilter()) {
    VelocityState state = moving(velocity, {0.1, 0, 0});
    const Vec3 rate_W = state.rate_W;
    updateRate(velocity, state, {0.3, 0.1, 0}, 0.0);
    EXPECT_EQ(state.rate_W, rate_W) << name;
  }
}

TEST(Velocity, FromAWallThatNobodyTouchedEveryFilterStartsAtRest) {
  for (const auto& [name, velocity] : everyFilter()) {
    VelocityState state = moving(velocity, {0.1, -0.2, 0.05});
    resetToZero(state);
    EXPECT_EQ(state.rate_W, kZero) << name;
    updateRate(velocity, state, {1e-4, 0, 0}, kTick_s);  // 0.1 m/s into it
    EXPECT_GT(state.rate_W.x(), 0.0) << name;
    EXPECT_LE(state.rate_W.x(), 0.1 * (1 + 1e-12)) << name << ": the hand's, not that of a jump";
    EXPECT_EQ(state.rate_W.y(), 0.0) << name;
  }
}

TEST(Velocity, AfterALostSignalEveryFilterIsAsNew) {
  for (const auto& [name, velocity] : everyFilter()) {
    VelocityState fresh, used = moving(velocity, {0.1, -0.2, 0.05});
    reset(used);
    test::Random random(test::Seed{6001});
    for (int n = 0; n < 100; ++n) {
      const Vec3 e_W = random.inBox(0.01);
      updateRate(velocity, fresh, e_W, kTick_s);
      updateRate(velocity, used, e_W, kTick_s);
      ASSERT_EQ(used.rate_W, fresh.rate_W) << name << ", tick " << n;
    }
  }
}

TEST(RawDifference, IsTheLastDifferenceOverItsTime) {
  VelocityState state;
  updateRate(RawDifference{}, state, {0.01, 0.02, 0.03}, 0.0);
  updateRate(RawDifference{}, state, {0.01 + 0x1p-10, 0.02, 0.03}, 0x1p-9);
  EXPECT_NEAR(state.rate_W.x(), 0.5, 1e-14);
  EXPECT_EQ(state.rate_W.y(), 0.0);
}

TEST(AdaptiveWindow, ByHand) {  // noise 1, ticks of 1 s: 0 0 1 0 0 5
  const AdaptiveWindow adaptive{4, Vec3::Constant(1.0)};
  VelocityState state;
  const double signal[] = {0, 0, 1, 0, 0, 5};
  // At 2: 0 0 1: least squares 0.5. At 3: 0 0 1 0: 0.1. At 4: 0 0 1 0 0: 0. At 5: 0 5 alone, since the line from 0 at 3
  // passes 2.5 over the sample at 4.
  const double expected[] = {0.0, 0.0, 0.5, 0.1, 0.0, 5.0};
  for (std::size_t n = 0; n < 6; ++n) {
    updateRate(adaptive, state, Vec3::Constant(signal[n]), n == 0 ? 0.0 : 1.0);
    EXPECT_NEAR(state.rate_W.x(), expected[n], 1e-15) << n;
  }
}

/// The filter's rule spelled out: every window tried, every line drawn.
double byDefinition(const std::vector<double>& t_s, const std::vector<double>& e, std::size_t now, int longest,
                    double noise) {
  double rate = 0.0;
  for (std::size_t n = 1; n <= static_cast<std::size_t>(longest) && n <= now; ++n) {
    const double ends = (e[now] - e[now - n]) / (t_s[now] - t_s[now - n]);
    for (std::size_t i = 1; i < n; ++i) {
      if (std::abs(e[now] - ends * (t_s[now] - t_s[now - i]) - e[now - i]) > noise) return rate;
    }
    double mean_t = 0.0, mean_e = 0.0, tt = 0.0, te = 0.0;
    for (std::size_t i = 0; i <= n; ++i) {
      mean_t += t_s[now - i] / static_cast<double>(n + 1);
      mean_e += e[now - i] / static_cast<double>(n + 1);
    }
    for (std::size_t i = 0; i <= n; ++i) {
      tt += (t_s[now - i] - mean_t) * (t_s[now - i] - mean_t);
      te += (t_s[now - i] - mean_t) * (e[now - i] - mean_e);
    }
    rate = te / tt;
  }
  return rate;
}

TEST(AdaptiveWindow, IsItsDefinitionForAnyMotionAndAnyTicks) {
  test::Random random(test::Seed{6002});
  for (int draw = 0; draw < test::sweep(100, 10000); ++draw) {
    const int longest = 1 + static_cast<int>(random.below(kLongestWindow));
    const AdaptiveWindow adaptive{longest, Vec3(kStep_m, 0.5 * kStep_m, 3.0 * kStep_m)};
    VelocityState state;
    std::vector<double> t_s;
    std::vector<double> e[3];
    const double speed = random.between(0.0, 0.3), turn = random.between(1.0, 60.0);
    double now_s = 0.0;
    for (std::size_t n = 0; n < 150; ++n) {
      const double dt_s = n == 0 ? 0.0 : random.between(0.5e-3, 2e-3);
      now_s += dt_s;
      t_s.push_back(now_s);
      Vec3 e_W = Vec3::Constant(speed / turn * std::sin(turn * now_s)) + random.inBox(0.4 * kStep_m);
      for (Eigen::Index axis = 0; axis < 3; ++axis) e[axis].push_back(e_W[axis]);
      updateRate(adaptive, state, e_W, dt_s);
      for (Eigen::Index axis = 0; axis < 3; ++axis) {
        // Sums of up to 33 places of 0.3 m over at least 0.5 ms.
        ASSERT_NEAR(state.rate_W[axis], byDefinition(t_s, e[axis], n, longest, adaptive.noise[axis]), 1e-9)
            << draw << ", tick " << n << ", axis " << axis;
      }
    }
  }
}

TEST(Kalman, SettlesAtTheGainsOfTheKnownFormula) {
  // Steady gains of a filter for place and velocity under white acceleration q, by iterating Riccati's equation here in
  // other words: P <- F P F' + Q, K = P H' / (H P H' + R), P <- (1 - K H) P.
  const double noise = 20e-6, acceleration = 10.0, q = acceleration * acceleration * 1e-3;
  Eigen::Matrix2d F, Q, P = Eigen::Matrix2d::Identity();
  F << 1.0, kTick_s, 0.0, 1.0;
  Q << q * kTick_s * kTick_s * kTick_s / 3, q * kTick_s * kTick_s / 2, q * kTick_s * kTick_s / 2, q * kTick_s;
  Eigen::Vector2d K = Eigen::Vector2d::Zero();
  const Eigen::RowVector2d H(1.0, 0.0);
  for (int n = 0; n < 5000; ++n) {
    P = F * P * F.transpose() + Q;
    K = P * H.transpose() / (P(0, 0) + noise * noise);
    P = (Eigen::Matrix2d::Identity() - K * H) * P;
  }
  const Velocity kalman = Kalman{noise, acceleration};
  VelocityState state = moving(kalman, kZero);
  updateRate(kalman, state, {kStep_m, 0, 0}, kTick_s);  // a step of the signal, out of the blue
  EXPECT_NEAR(state.place_W.x(), K[0] * kStep_m, 1e-9 * kStep_m);
  EXPECT_NEAR(state.rate_W.x(), K[1] * kStep_m, 1e-9 * K[1] * kStep_m);
}

TEST(Velocity, FiniteInFiniteOut) {
  test::Random random(test::Seed{6003});
  for (const auto& [name, velocity] : everyFilter()) {
    VelocityState state;
    for (int n = 0; n < test::sweep(5000, 500000); ++n) {
      const double dt_s = random.below(10) == 0 ? 0.0 : std::pow(10.0, random.between(-9.0, -1.0));
      updateRate(velocity, state, std::pow(10.0, random.between(-30.0, 12.0)) * random.direction(), dt_s);
      ASSERT_TRUE(state.rate_W.allFinite()) << name << ", tick " << n;
      if (random.below(20) == 0) resetToZero(state);
      if (random.below(20) == 0) reset(state);
      if (random.below(20) == 0) state.has_last = false;
    }
  }
}

}  // namespace
}  // namespace underact::control
