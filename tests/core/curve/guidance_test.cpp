#include "core/curve/guidance.h"

#include "core/curve/along.h"
#include "tests/core/curve/oracle.h"

namespace underact::curve {
namespace {

using test::Random;
using test::Seed;

constexpr double kDt_s = 1e-3;

/// A hand, a curve and all that remembers.
struct Led {
  std::shared_ptr<const Curve> curve;
  Guidance guide;
  SearchState search = {};
  GuidanceState state = {};
  Nearest nearest = {};
  GuidedTarget at(const Vec3& p_WT, double dt_s = kDt_s) {
    nearest = nearestPoint(*curve, Search::Hybrid, p_WT, search);
    return guidedTarget(*curve, guide, nearest, p_WT, dt_s, state);
  }
};

const std::vector<Vec3> kLine{{0, 0, 0}, {0.03, 0, 0}, {0.1, 0, 0}};
const std::vector<Vec3> kSquare{{0, 0, 0}, {0.1, 0, 0}, {0.1, 0.1, 0}, {0, 0.1, 0}};

TEST(Guidance, WithoutAHintOrAtFullStrengthOfPositionTheTargetIsTheNearestPoint) {
  for (const Guidance& guide : {Guidance{0.0, 0.0, 0.01}, Guidance{1.0, 0.2, 0.01}}) {
    Led led{curveOf(kLine, CurveKind::Spline), guide};
    for (double x_m = 0.02; x_m < 0.08; x_m += 1e-4) {
      const GuidedTarget guided = led.at({x_m, 0.005, 0});
      ASSERT_EQ(guided.p_WP, led.nearest.p_WP);  // to the bit
      ASSERT_EQ(guided.s_m, led.nearest.s_m);
      ASSERT_FALSE(guided.is_slewing);
    }
  }
}

TEST(Guidance, RunsAtTheHintsSpeedAndWaitsAtItsLead) {
  Led led{curveOf(kLine, CurveKind::Polyline), {0.25, 0.1, 0.01}};
  EXPECT_NEAR(led.at({0.02, 0.005, 0}).guide_s_m, 0.02, 1e-17);  // starts at the hand
  for (int tick = 1; tick <= 300; ++tick) {
    const GuidedTarget guided = led.at({0.02, 0.005, 0});
    const double ahead_m = std::min(0.1 * 1e-3 * tick, 0.01);
    ASSERT_NEAR(guided.guide_s_m, 0.02 + ahead_m, 1e-15);
    ASSERT_LT((guided.p_WP - Vec3(0.02 + 0.75 * ahead_m, 0, 0)).norm(), 1e-15);  // the blend by t
    ASSERT_FALSE(guided.is_slewing);
  }
}

TEST(Guidance, GoesTheOtherWayWithANegativeHint) {
  Led led{curveOf(kLine, CurveKind::Spline), {0.0, -0.1, 0.01}};
  for (int tick = 0; tick <= 300; ++tick) led.at({0.05, 0.005, 0});
  EXPECT_NEAR(led.at({0.05, 0.005, 0}).p_WP.x(), 0.04, 1e-15);
}

TEST(Guidance, HoldsNobodyBackWhoIsFaster) {
  Led led{curveOf(kLine, CurveKind::Polyline), {0.0, 0.05, 0.01}};
  for (double x_m = 0.01; x_m < 0.08; x_m += 2e-4) {  // 0.2 m/s
    const GuidedTarget guided = led.at({x_m, 0.001, 0});
    ASSERT_EQ(guided.guide_s_m, led.nearest.s_m);
    ASSERT_EQ(guided.p_WP, led.nearest.p_WP);
  }
}

TEST(Guidance, ComesBackWithAHandThatGoesBack) {
  Led led{curveOf(kLine, CurveKind::Polyline), {0.0, 0.05, 0.01}};
  for (int tick = 0; tick < 500; ++tick) led.at({0.08, 0.001, 0});
  for (double x_m = 0.08; x_m > 0.02; x_m -= 2e-4) {
    ASSERT_LE(led.at({x_m, 0.001, 0}).guide_s_m, x_m + 0.01 + 1e-15);
  }
}

TEST(Guidance, StopsAtAnOpenEndAndGoesRoundAClosedOne) {
  Led open{curveOf(kLine, CurveKind::Polyline), {0.0, 0.1, 0.02}};
  for (int tick = 0; tick < 500; ++tick) open.at({0.095, 0.001, 0});
  EXPECT_EQ(open.at({0.095, 0.001, 0}).p_WP, Vec3(0.1, 0, 0));
  for (const CurveKind kind : {CurveKind::Polyline, CurveKind::Spline}) {
    Led closed{curveOf(kSquare, kind, true), {0.0, 0.1, 0.02}};
    Vec3 p_WT(0.0, 0.005, 0);
    double rounds_m = 0.0, last_m = closed.at(p_WT).guide_s_m;
    for (int tick = 0; tick < 20'000; ++tick) {  // the hand lets itself be drawn
      const GuidedTarget guided = closed.at(p_WT);
      p_WT += 0.02 * (guided.p_WP - p_WT);
      rounds_m += arcLengthBetween(*closed.curve, last_m, guided.guide_s_m);
      last_m = guided.guide_s_m;
      ASSERT_LE(arcLengthBetween(*closed.curve, closed.nearest.s_m, guided.guide_s_m), 0.02 + 1e-14);
      ASSERT_GE(arcLengthBetween(*closed.curve, closed.nearest.s_m, guided.guide_s_m), -1e-14);
    }
    EXPECT_GT(rounds_m, 3.0 * lengthOf(*closed.curve));
    EXPECT_LE(rounds_m, 20.0 * 0.1 + 0.02);
  }
}

TEST(Guidance, IsAQuarterOfAClosedCurveAheadAtMost) {
  Led led{curveOf(kSquare, CurveKind::Polyline, true), {0.0, 1.0, 5.0}};
  for (int tick = 0; tick < 2000; ++tick) led.at({0.05, 0.001, 0});
  EXPECT_NEAR(led.at({0.05, 0.001, 0}).guide_s_m, 0.15, 1e-15);
}

TEST(Guidance, TheTargetNeverMovesFasterThanTheSlewBeyondTheHand) {
  Random random(Seed{20070620});
  for (int draw = 0; draw < test::sweep(20, 1000); ++draw) {
    const CurveKind kind = draw % 2 == 0 ? CurveKind::Polyline : CurveKind::Spline;
    const bool closed = draw % 4 >= 2;
    Led led{curveOf(randomPath(random, 20, 0.01), kind, closed),
            {random.between(0, 1), random.between(-2, 2), random.between(1e-3, 0.05)}};
    Vec3 p_WT = random.inBox(0.05), way_W = random.direction();
    Vec3 last_WP = led.at(p_WT).p_WP;
    for (int tick = 0; tick < 2000; ++tick) {
      if (tick % 50 == 0) way_W = random.direction();
      if (tick % 300 == 299) led.guide.t = random.between(0, 1);  // a slider that jumps
      const Vec3 step_W = 3e-4 * way_W + (tick % 100 == 99 ? random.inBox(0.01) : Vec3(0, 0, 0));
      p_WT += step_W;
      if (p_WT.norm() > 0.1) p_WT *= 0.5, way_W = -way_W;
      const Vec3 moved_W = p_WT - led.state.p_WT;
      const GuidedTarget guided = led.at(p_WT);
      ASSERT_LE((guided.p_WP - last_WP).norm(), kSlew_m_per_s * kDt_s + moved_W.norm() + 1e-15);
      ASSERT_TRUE(guided.is_slewing || (guided.p_WP - pointAt(*led.curve, guided.s_m)).norm() < 1e-14);
      last_WP = guided.p_WP;
    }
  }
}

TEST(Guidance, TheTargetKeepsUpWithTheFastestHand) {  // the slew is beyond what the hand itself moves
  Led led{curveOf(kLine, CurveKind::Polyline), {}};
  for (double x_m = 0.0; x_m < 0.1; x_m += 0.01) {  // 10 m/s
    const GuidedTarget guided = led.at({x_m, 0.001, 0});
    ASSERT_EQ(guided.p_WP, led.nearest.p_WP);
    ASSERT_FALSE(guided.is_slewing);
  }
}

TEST(Guidance, AChangeOfBranchTakesItsTimeAndArrives) {
  const std::vector<Vec3> hairpin{{0, 0.01, 0},     {0.02, 0.01, 0},  {0.04, 0.01, 0},
                                  {0.04, -0.01, 0}, {0.02, -0.01, 0}, {0, -0.01, 0}};
  Led led{curveOf(hairpin, CurveKind::Polyline), {}};
  led.at({0.01, 1e-6, 0});
  int ticks = 1;
  while (led.at({0.01, -1e-6, 0}).is_slewing && ticks < 100) ++ticks;
  EXPECT_EQ(ticks, 10);  // 20 mm at 2 m/s
  EXPECT_EQ(led.state.p_WP, Vec3(0.01, -0.01, 0));
  Led at_once{led.curve, {}};
  at_once.at({0.01, 1e-6, 0});
  EXPECT_EQ(at_once.at({0.01, -1e-6, 0}, 0.0).p_WP, Vec3(0.01, -0.01, 0));  // dt 0: unknown
}

TEST(Guidance, ATipThatIsNotFiniteLeavesTheStateAsItWas) {
  Led led{curveOf(kLine, CurveKind::Spline), {0.0, 0.1, 0.01}};
  for (int tick = 0; tick < 50; ++tick) led.at({0.02, 0.005, 0});
  const GuidanceState before = led.state;
  const GuidedTarget guided = led.at({kNotANumber, 0, 0});
  EXPECT_EQ(guided.p_WP, before.p_WP);
  EXPECT_EQ(led.state.s_m, before.s_m);
  EXPECT_EQ(led.state.p_WT, before.p_WT);
  for (const double dt_s : {kNotANumber, kInfinity, -1.0}) {
    EXPECT_TRUE(led.at({0.02, 0.005, 0}, dt_s).p_WP.allFinite());
    EXPECT_TRUE(std::isfinite(led.state.s_m));
  }
}

}  // namespace
}  // namespace underact::curve
