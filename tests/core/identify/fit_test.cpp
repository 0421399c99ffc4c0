// The estimators on motions that are made here: by the body's own equation, with noise and steps of a known size.
#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "core/base/units.h"
#include "core/identify/body_fit.h"
#include "core/identify/encoder_steps.h"
#include "core/identify/identified.h"
#include "core/identify/press.h"

namespace underact::identify {
namespace {

constexpr double kPeriod_s = 1e-3;
constexpr double kStep_m = 0.055e-3;  // of an encoder at the tip

/// Rows of a body that a spring of 100 N/m, clamped at 0.88 N, draws to targets 10 mm to each side.
std::vector<MotionRow> swingsOf(const Body& body, double step_m, int targets = 8) {
  const BodyStep step(body, kPeriod_s);
  std::vector<MotionRow> rows;
  Motion motion;
  for (int target = 0; target < targets; ++target) {
    const double target_m = target % 2 == 0 ? 0.010 : -0.010;
    for (int tick = 0; tick < 400; ++tick) {
      MotionRow row;
      row.time_ns = 1'000'000 * static_cast<std::int64_t>(rows.size());
      row.p_WT.x() = step_m > 0.0 ? step_m * std::round(motion.x_m / step_m) : motion.x_m;
      row.p_WP.x() = target_m;
      const double asked_N = 100.0 * (target_m - row.p_WT.x());
      row.f_T_W.x() = std::clamp(asked_N, -0.88, 0.88);
      row.is_cut = asked_N != row.f_T_W.x();
      rows.push_back(row);
      motion = step(motion, row.f_T_W.x());
    }
  }
  return rows;
}

BodyFit fitOf(const std::vector<MotionRow>& rows) {
  const Result<BodyFit> fit = fitBody(windowsOf(rows, Vec3::UnitX(), kPeriod_s));
  EXPECT_TRUE(static_cast<bool>(fit));
  return fit ? fit.value() : BodyFit{};
}

TEST(BodyFit, FindsTheBodyToRoundingWhereNothingIsRounded) {
  const Body body{0.045, 0.26, 0.4, 0.03};
  const BodyFit fit = fitOf(swingsOf(body, 0.0));
  // What is left is the last step of the iteration: a share of 1e-10 of the sum of squares.
  EXPECT_NEAR(fit.body.mass_kg, body.mass_kg, 1e-5 * body.mass_kg);
  EXPECT_NEAR(fit.body.friction_N, body.friction_N, 1e-5);
  EXPECT_NEAR(fit.body.damping_N_s_per_m, body.damping_N_s_per_m, 1e-4);
  EXPECT_NEAR(fit.body.bias_N, body.bias_N, 1e-5);
  EXPECT_LT(fit.residual_m, 1e-7);
}

TEST(BodyFit, EncoderStepsLeaveTheirOwnNoiseAndItsUncertaintyCoversTheError) {
  const Body body{0.08, 0.15, 0.5, -0.02};
  const BodyFit fit = fitOf(swingsOf(body, kStep_m));
  EXPECT_NEAR(fit.residual_m, kStep_m / std::sqrt(12.0), 0.15 * kStep_m / std::sqrt(12.0));  // of an even spread
  // Five deviations: a normal error is beyond once in a million. Not a hundredth of it either, or it says nothing.
  EXPECT_NEAR(fit.body.mass_kg, body.mass_kg, 5.0 * fit.uncertainty.mass_kg);
  EXPECT_NEAR(fit.body.friction_N, body.friction_N, 5.0 * fit.uncertainty.friction_N);
  EXPECT_NEAR(fit.body.damping_N_s_per_m, body.damping_N_s_per_m, 5.0 * fit.uncertainty.damping_N_s_per_m);
  EXPECT_NEAR(fit.body.bias_N, body.bias_N, 5.0 * fit.uncertainty.bias_N);
  EXPECT_LT(fit.uncertainty.mass_kg, 0.005 * body.mass_kg);
  EXPECT_LT(fit.uncertainty.friction_N, 0.02 * body.friction_N);
}

TEST(BodyFit, MoreSwingsMakeItMoreCertain) {
  const Body body{0.08, 0.15, 0.5, 0.0};
  const BodyFit few = fitOf(swingsOf(body, kStep_m, 4)), many = fitOf(swingsOf(body, kStep_m, 32));
  // Eight times the swings: sqrt(8) = 2.8 times; half of that, since the swings repeat and their steps with them.
  EXPECT_LT(many.uncertainty.mass_kg, few.uncertainty.mass_kg / 1.4);
  EXPECT_LT(many.uncertainty.friction_N, few.uncertainty.friction_N / 1.4);
}

TEST(BodyFit, ATipThatStandsStillTellsNothingAndSaysSo) {
  EXPECT_FALSE(fitBody(windowsOf(swingsOf({0.045, 0.9, 0.0, 0.0}, kStep_m), Vec3::UnitX(), kPeriod_s)));
}

TEST(BodyFit, AMotionThatNoBodyMakesIsRefused) {
  std::vector<MotionRow> rows = swingsOf({0.045, 0.26, 0.4, 0.0}, 0.0);
  for (std::size_t row = 0; row < rows.size(); ++row)  // a hand that goes to and fro as it likes
    rows[row].p_WT.x() = 0.01 * std::sin(0.05 * static_cast<double>(row)) * std::cos(0.013 * static_cast<double>(row));
  EXPECT_FALSE(fitBody(windowsOf(rows, Vec3::UnitX(), kPeriod_s)));
}

TEST(BodyFit, IsAskedWindowByWindowWhetherItGoesOnAndEndsAtTheFirstNo) {
  const std::vector<Window> windows = windowsOf(swingsOf({0.08, 0.15, 0.5, 0.0}, kStep_m), Vec3::UnitX(), kPeriod_s);
  int asked = 0;
  const Result<BodyFit> whole = fitBody(windows, [&] { return ++asked < 0; });
  ASSERT_TRUE(static_cast<bool>(whole));
  EXPECT_GT(asked, static_cast<int>(3 * windows.size())) << "three beginnings, a round each at least";
  const int all = asked;
  for (const int when : {1, 2, all / 2, all}) {
    asked = 0;
    EXPECT_FALSE(fitBody(windows, [&] { return ++asked >= when; }));
    EXPECT_EQ(asked, when) << "it went on";
  }
}

TEST(Windows, NoneGoesOverAGapAndRestsAreLeftOut) {
  std::vector<MotionRow> rows = swingsOf({0.045, 0.26, 0.4, 0.0}, 0.0, 2);
  for (std::size_t row = 100; row < rows.size(); ++row) rows[row].time_ns += 5'000'000;
  for (const Window& window : windowsOf(rows, Vec3::UnitX(), kPeriod_s)) {
    EXPECT_TRUE(window.first_row >= 100 || window.first_row + window.travel_m.size() <= 100);
    EXPECT_LE(window.travel_m.size(), 250U);
  }
  EXPECT_TRUE(windowsOf(rows, Vec3::UnitY(), kPeriod_s).empty());
}

TEST(Windows, FrictionCountsByTheDirectionOfTheWholeMotion) {
  std::vector<MotionRow> rows;
  for (int tick = 0; tick < 200; ++tick) {
    MotionRow row;
    row.time_ns = std::int64_t{1'000'000} * tick;
    row.p_WT = 1e-3 * tick * Vec3(0.3, 0.4, 0.0);  // 0.5 m/s, 3 : 4 : 5
    rows.push_back(row);
  }
  const std::vector<Window> windows = windowsOf(rows, Vec3::UnitX(), kPeriod_s);
  ASSERT_EQ(windows.size(), 1U);
  // A way across of one encoder step in 4 mm is taken off: a share of 1e-4.
  for (const double share : windows[0].friction_share) EXPECT_NEAR(share, 0.6, 2e-3);
}

TEST(StiffnessFromSwing, IsTheOneOfTheSpringThatPulledWhateverWasSaidToBeSent) {
  const Body body{0.3, 0.05, 0.3, 0.0};
  std::vector<MotionRow> rows = swingsOf(body, kStep_m, 12);
  for (MotionRow& row : rows) row.f_T_W.setZero();
  const auto found = stiffnessFromSwing(rows, Vec3::UnitX(), kPeriod_s, body, 100.0);
  ASSERT_TRUE(found);
  EXPECT_NEAR(found->value_N_per_m, 100.0, 1.0);  // 55 um steps; without them see below
  EXPECT_LT(found->uncertainty_N_per_m, 1.0);
  std::vector<MotionRow> exact = swingsOf(body, 0.0, 12);
  const auto without = stiffnessFromSwing(exact, Vec3::UnitX(), kPeriod_s, body, 100.0);
  ASSERT_TRUE(without);
  EXPECT_NEAR(without->value_N_per_m, 100.0, 0.1);  // with integrals in place of sums it was 1 to 3 % low
}

TEST(Steps, AreFoundExactlyFromWholeMultiples) {
  std::mt19937 random(7);
  for (const double count : {15280.0, 4915.0, 1024.0}) {
    const double step = 2.0 * kPi / count;
    std::vector<double> signal;
    int at = 40;
    for (int index = 0; index < 500; ++index)
      signal.push_back(step * (at += static_cast<int>(random() % 7U) - 3) + 0.123);
    const auto found = stepOf(signal);
    ASSERT_TRUE(found);
    EXPECT_NEAR(found->value, step, 1e-10 * step);
  }
}

TEST(Steps, AreFoundWhereOneAloneNeverCame) {
  std::vector<double> signal;
  for (int index = 0, at = 0; index < 100; ++index) signal.push_back(1e-3 * (at += index % 2 == 0 ? 2 : 3));
  const auto found = stepOf(signal);
  ASSERT_TRUE(found);
  EXPECT_NEAR(found->value, 1e-3, 1e-12);
}

TEST(Steps, AreFoundFromFewLargeJumps) {  // a turn of the stylus that is said 20 times a second
  std::vector<double> signal;
  for (const int at : {0, 47, 150, 99, 33, 68, 161, 104, 30, 71, 140}) signal.insert(signal.end(), 50, 1e-3 * at);
  const auto found = stepOf(signal);
  ASSERT_TRUE(found);
  EXPECT_NEAR(found->value, 1e-3, 1e-12);
}

TEST(Steps, OfASmoothSignalOrOneThatHardlyMovesThereAreNone) {
  std::vector<double> smooth, still(500, 0.3);
  for (int index = 0; index < 500; ++index) smooth.push_back(std::sin(0.01 * index));
  EXPECT_FALSE(stepOf(smooth));
  EXPECT_FALSE(stepOf(still));
}

TEST(Noise, OfStepsInASlowMotionIsStepOverRootTwelve) {
  std::vector<MotionRow> rows(4000);
  for (std::size_t row = 0; row < rows.size(); ++row)
    rows[row].p_WT.y() = kStep_m * std::round(8e-6 * static_cast<double>(row) / kStep_m);  // 8 mm/s
  // 0.8 mm in a tenth of a second are 15 steps: the parabola takes 3 of so many degrees of freedom, and bends a little.
  EXPECT_NEAR(slowNoise(rows, kPeriod_s).y(), kStep_m / std::sqrt(12.0), 0.1 * kStep_m / std::sqrt(12.0));
  EXPECT_EQ(slowNoise(rows, kPeriod_s).x(), 0.0);
}

TEST(Noise, AtRestIsTheDeviationAboutTheMean) {
  std::vector<MotionRow> rows(1000);
  for (std::size_t row = 0; row < rows.size(); ++row) rows[row].p_WT = Vec3(row % 2 == 0 ? 1e-5 : -1e-5, 0.05, 0.0);
  EXPECT_NEAR(restNoise(rows).x(), 1e-5, 1e-15);
  EXPECT_NEAR(restNoise(rows).y(), 0.0, 1e-15);
}

/// Two presses of 3 mm; force there is k x, back it is k x - gap, from 0.88 N on it is cut.
std::vector<MotionRow> pressed(double k_N_per_m, double gap_N) {
  std::vector<MotionRow> rows;
  for (int tick = 0; tick < 4000; ++tick) {
    const double turn = 2.0 * kPi * tick / 2000.0, x_m = 1.5e-3 * (1.0 - std::cos(turn));
    MotionRow row;
    row.time_ns = std::int64_t{1'000'000} * tick;
    row.p_WT.y() = -x_m;
    const double asked_N = k_N_per_m * x_m - (std::sin(turn) < 0.0 ? gap_N : 0.0);
    row.is_cut = asked_N > 0.88;
    row.f_T_W.y() = std::clamp(asked_N, 0.0, 0.88);
    if (asked_N < 0.0) row.f_T_W.y() = asked_N;
    rows.push_back(row);
  }
  return rows;
}

TEST(Press, FindsTheSlopeTheGapAndTheClamp) {
  const Result<Press> press = pressOf(pressed(500.0, 0.1), -Vec3::UnitY(), kPeriod_s);
  ASSERT_TRUE(static_cast<bool>(press));
  EXPECT_NEAR(press.value().stiffness_N_per_m.value, 500.0, 1e-9);
  EXPECT_NEAR(press.value().down_N_per_m, 500.0, 1e-9);
  EXPECT_NEAR(press.value().hysteresis_N, 0.1, 1e-9);
  // Up to 0.88 N / 500 N/m there, to 0.98 N back; a tick goes 4.7 um.
  EXPECT_NEAR(press.value().clamped_at_m.value(), 1.76e-3, 5e-6);
  EXPECT_NEAR(press.value().linear_m, 1.96e-3, 5e-6);
  EXPECT_NEAR(press.value().max_N, 0.88, 1e-12);
}

TEST(Press, OneWayOnlyIsRefused) {
  std::vector<MotionRow> rows = pressed(500.0, 0.0);
  rows.resize(1000);
  EXPECT_FALSE(pressOf(rows, -Vec3::UnitY(), kPeriod_s));
}

TEST(Blocks, AWindowOfTooFewTicksHasNone) {  // a light arm at a low rate: the step from block to block would be none
  Window window;
  window.period_s = 0.01;
  window.travel_m = {0.0, 0.01, 0.02, 0.03, 0.04, 0.05};
  window.target_m.assign(6, 0.1);
  window.force_N.assign(6, 0.5);
  window.friction_share.assign(6, 1.0);
  window.is_cut.assign(6, false);
  EXPECT_TRUE(blocksOf(std::vector{window}, 0.02).empty());
  EXPECT_TRUE(blocksOf(std::vector{window}, 0.001).empty());
}

TEST(Mean, CountsAllAlikeAndTheirScatterWhereChanceDoesNotExplainIt) {
  const Estimate alike = meanOf({{1.0, 0.1}, {1.0, 0.1}, {1.0, 0.1}, {1.0, 0.1}});
  EXPECT_NEAR(alike.value, 1.0, 1e-15);
  EXPECT_NEAR(alike.uncertainty, 0.05, 1e-15);
  const Estimate apart = meanOf({{1.0, 0.001}, {2.0, 0.001}});
  EXPECT_NEAR(apart.value, 1.5, 1e-12);
  EXPECT_NEAR(apart.uncertainty, 0.5, 1e-12);  // the deviation of two, sqrt(1/2), over sqrt(2)
  EXPECT_NEAR(meanOf({{1.0, 0.1}, {2.0, 0.2}}).value, 1.5, 1e-12);
  EXPECT_EQ(meanOf({{1.0, 0.1}}).uncertainty, 0.1);
  EXPECT_NEAR(meanOf({{0.9, 0.1}, {1.0, 0.1}, {1.1, 0.1}}).uncertainty, 0.1 / std::sqrt(3.0), 1e-15) << "chance";
  EXPECT_NEAR(meanOf({{0.7, 0.1}, {1.0, 0.1}, {1.3, 0.1}}).uncertainty, 0.3 / std::sqrt(3.0), 1e-15) << "no chance";
}

TEST(Estimate, BelowTwoDeviationsIsNotTold) {
  EXPECT_TRUE((Estimate{0.21, 0.1}.isSignificant()));
  EXPECT_FALSE((Estimate{0.19, 0.1}.isSignificant()));
  EXPECT_NEAR((Estimate{0.05, 0.1}.limit()), 0.25, 1e-15);
  EXPECT_NEAR((Estimate{-0.05, 0.1}.limit()), 0.2, 1e-15);
}

}  // namespace
}  // namespace underact::identify
