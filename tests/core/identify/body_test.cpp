#include "core/identify/body.h"

#include <gtest/gtest.h>

#include <cmath>

namespace underact::identify {
namespace {

/// Where the body is after a held force, by a million small steps of the momentum equation: shares no line with the
/// code.
Motion bySmallSteps(const Body& body, Motion motion, double force_N, double period_s, double share = 1.0) {
  constexpr int kSteps = 1'000'000;
  const double dt_s = period_s / kSteps, friction_N = share * body.friction_N;
  for (int step = 0; step < kSteps; ++step) {
    const double pull_N = force_N + body.bias_N - body.damping_N_s_per_m * motion.v_m_per_s;
    const double free = motion.v_m_per_s + dt_s / body.mass_kg * pull_N, lost = dt_s / body.mass_kg * friction_N;
    motion.v_m_per_s = std::abs(free) <= lost ? 0.0 : free - std::copysign(lost, free);
    motion.x_m += dt_s * motion.v_m_per_s;
  }
  return motion;
}

// A step of 1e-9 s misses the way by half of it times the velocity, and the moment of a turn by one step.
constexpr double kWay_m = 2e-9, kVelocity_m_per_s = 1e-6;

void expectSame(const Body& body, const Motion& from, double force_N, double period_s, double share = 1.0) {
  const Motion exact = BodyStep(body, period_s)(from, force_N, share);
  const Motion steps = bySmallSteps(body, from, force_N, period_s, share);
  EXPECT_NEAR(exact.x_m, steps.x_m, kWay_m);
  EXPECT_NEAR(exact.v_m_per_s, steps.v_m_per_s, kVelocity_m_per_s);
}

TEST(Body, StaysStuckUpToItsFrictionAndGoesOffBeyond) {
  const BodyStep step({0.045, 0.26, 0.0, 0.0}, 1e-3);
  EXPECT_EQ(step({0.01, 0.0}, 0.26).x_m, 0.01);
  EXPECT_EQ(step({0.01, 0.0}, -0.26).v_m_per_s, 0.0);
  // (0.36 - 0.26) N / 0.045 kg for 1 ms
  EXPECT_NEAR(step({0.0, 0.0}, 0.36).v_m_per_s, 0.1 / 0.045 * 1e-3, 1e-15);
  EXPECT_NEAR(step({0.0, 0.0}, -0.36).x_m, -0.5 * 0.1 / 0.045 * 1e-6, 1e-18);
}

TEST(Body, ABiasCountsAsAForceThatIsAlwaysThere) {
  const BodyStep step({0.045, 0.26, 0.0, 0.1}, 1e-3);
  EXPECT_EQ(step({0.0, 0.0}, 0.16).v_m_per_s, 0.0);
  EXPECT_GT(step({0.0, 0.0}, 0.17).v_m_per_s, 0.0);
  EXPECT_EQ(step({0.0, 0.0}, -0.36).v_m_per_s, 0.0);
}

TEST(Body, MovesAsSmallStepsSay) {
  for (const double damping : {0.0, 1e-4, 0.3, 3.0, -0.2}) {
    const Body body{0.045, 0.26, damping, 0.02};
    expectSame(body, {0.0, 0.3}, 0.5, 2e-3);
    expectSame(body, {0.0, -0.3}, -0.88, 2e-3);
  }
}

TEST(Body, TurnsAndStopsBetweenTwoSamples) {
  for (const double damping : {0.0, 0.5, 3.0}) {
    expectSame({0.02, 0.1, damping, 0.0}, {0.0, 0.02}, -0.8, 2e-3);   // turns, and goes back
    expectSame({0.02, 0.3, damping, 0.0}, {0.0, 0.02}, -0.25, 2e-3);  // stops, and sticks
  }
}

TEST(Body, OnlyTheShareOfTheFrictionAlongTheWayActs) {
  expectSame({0.045, 0.4, 0.5, 0.0}, {0.0, 0.2}, 0.3, 2e-3, 0.6);
  EXPECT_GT(BodyStep({0.045, 0.4, 0.0, 0.0}, 1e-3)({0.0, 0.0}, 0.3, 0.6).v_m_per_s, 0.0);  // 0.24 N hold 0.3 N not
}

TEST(Body, SmallAndLargeDampingMeetWhereTheSeriesEnds) {
  // z = b t / m = 0.01 at b = 0.45: both sides of it.
  const double below = BodyStep({0.045, 0.0, 0.45 * (1.0 - 1e-9), 0.0}, 1e-3)({0.0, 0.3}, 0.5).x_m;
  const double above = BodyStep({0.045, 0.0, 0.45 * (1.0 + 1e-9), 0.0}, 1e-3)({0.0, 0.3}, 0.5).x_m;
  EXPECT_NEAR(below, above, 1e-14);
}

}  // namespace
}  // namespace underact::identify
