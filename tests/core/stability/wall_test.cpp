#include <cmath>

#include "core/stability/exact.h"
#include "core/stability/trial.h"
#include "tests/support/property.h"
#include "tests/support/random.h"
#include "tests/support/sampled_wall.h"

namespace underact::stability {
namespace {

constexpr double kShare = 0.02;  // to which the simulated loop must find what the eigenvalues say

/// The same wall for the tests' own eigenvalues, which know no filter.
test::SampledWall forOracle(const SampledWall& wall) {
  return {wall.mass_kg,      wall.damping_N_s_per_m, wall.hand_stiffness_N_per_m,
          wall.kd_N_s_per_m, wall.period_s(),        wall.delay_ticks};
}

struct Row {
  double mass_kg, damping_N_s_per_m, kd_N_s_per_m;
  std::int64_t period_ns;
  double limit_N_per_m[3];  // with a delay of 0, 1, 2 ticks
};

// The table of largest stable stiffnesses: an own script's, by spectral radius, to 0.1 N/m. Where it says "any" mass,
// 20 g: a light one shows soonest whether it is calm.
const Row kTable[]{
    {0.02, 0.1, 0.0, 1'000'000, {200.0, 66.7, 40.0}},     {0.045, 0.1, 0.5, 1'000'000, {1187.2, 395.3, 236.5}},
    {0.108, 1.0, 0.5, 1'000'000, {2990.8, 997.4, 598.5}}, {0.045, 0.1, 2.0, 1'000'000, {4019.1, 1331.6, 787.7}},
    {0.02, 0.1, 0.0, 250'000, {800.0, 266.7, 160.0}},     {0.045, 0.1, 0.5, 250'000, {4787.1, 1595.3, 956.5}},
    {0.045, 0.1, 2.0, 250'000, {16616.0, 5531.7, 3308.3}}};

TEST(SampledWall, EveryRowOfTheTableIsFoundByTheEigenvaluesAndInTheSimulatedLoop) {
  int number = -1;
  for (const Row& row : kTable) {
    ++number;
    for (int delay = 0; delay < 3; ++delay) {
      // Under a sanitizer each row and each delay, but not all with all.
      if (test::kIsWatched && !test::isSoak() && delay != number % 3) continue;
      SampledWall wall;
      wall.mass_kg = row.mass_kg;
      wall.damping_N_s_per_m = row.damping_N_s_per_m;
      wall.kd_N_s_per_m = row.kd_N_s_per_m;
      wall.period_ns = row.period_ns;
      wall.delay_ticks = delay;
      const double known = row.limit_N_per_m[delay];
      EXPECT_NEAR(exactLimit(wall).value(), known, 0.001 * known + 0.1) << row.mass_kg << " kg, delay " << delay;
      EXPECT_NEAR(simulatedLimit(wall), known, kShare * known) << row.mass_kg << " kg, delay " << delay;
    }
  }
}

TEST(SampledWall, CoarserEncodersCountSoManyTimesLess) {
  SampledWall wall;
  wall.coarseness = 4.0;
  const arm::Preset& arm = *arm::findPreset(arm::kDefaultArm);
  const sim::Plant plant = plantOf(wall);
  for (std::size_t joint = 0; joint < arm.counts_per_turn.size(); ++joint)
    EXPECT_EQ(plant.arm.counts_per_turn[joint], arm.counts_per_turn[joint] / 4.0) << joint;
}

/// Walls between the table's: other masses, hands, rates and delays, drawn once and for all.
SampledWall drawnWall(test::Random& random) {
  SampledWall wall;
  wall.mass_kg = random.between(0.02, 0.6);
  wall.damping_N_s_per_m = random.between(0.1, 6.0);
  wall.hand_stiffness_N_per_m = random.below(2) == 0 ? 0.0 : random.between(50.0, 300.0);
  wall.kd_N_s_per_m = random.below(3) == 0 ? 0.0 : random.between(0.1, 2.0);
  constexpr std::int64_t kPeriods_ns[]{250'000, 500'000, 1'000'000, 2'000'000};
  wall.period_ns = kPeriods_ns[random.below(4)];
  wall.delay_ticks = static_cast<int>(random.below(4));
  return wall;
}

TEST(SampledWall, TwentyMoreRowsBetweenThemAgreeToo) {
  test::Random random(test::Seed{20261122});
  for (int row = 0; row < test::dearSweep(20, 300); ++row) {
    const SampledWall wall = drawnWall(random);
    const double exact = exactLimit(wall).value();
    EXPECT_NEAR(exact, test::exactLimit(forOracle(wall)), 1e-6 * exact) << row;
    EXPECT_NEAR(simulatedLimit(wall), exact, kShare * exact)
        << row << ": " << wall.mass_kg << " kg, " << wall.damping_N_s_per_m << " N s/m, hand "
        << wall.hand_stiffness_N_per_m << " N/m, B " << wall.kd_N_s_per_m << ", T " << wall.period_ns << " ns, d "
        << wall.delay_ticks;
  }
}

TEST(SampledWall, WithAFilterTheSimulatedLimitIsThatOfTheEigenvalues) {
  SampledWall wall;
  wall.kd_N_s_per_m = 0.5;
  for (const std::int64_t period_ns : {250'000, 1'000'000}) {
    wall.period_ns = period_ns;
    for (const control::Velocity& velocity :
         {control::Velocity(control::LowPass{1.6e-3}), control::Velocity(control::LowPass{5e-3}), defaultKalman()}) {
      wall.velocity = velocity;
      const double exact = exactLimit(wall).value();
      EXPECT_NEAR(simulatedLimit(wall), exact, kShare * exact) << velocity.index() << " at " << period_ns << " ns";
    }
  }
}

TEST(SampledWall, AFilterTakesFromTheLimit) {
  SampledWall wall;
  wall.kd_N_s_per_m = 0.5;
  const double raw = exactLimit(wall).value();
  wall.velocity = control::LowPass{5e-3};
  EXPECT_LT(exactLimit(wall).value(), 0.7 * raw);
}

TEST(SampledWall, WithoutDelayAndFilterThePassiveLimitIsColgateAndSchenkels) {
  for (const double kd : {0.0, 0.5, 0.9}) {
    SampledWall wall;
    wall.damping_N_s_per_m = 1.0;
    wall.kd_N_s_per_m = kd;
    EXPECT_NEAR(passiveLimit(wall), colgateSchenkel(wall), 1e-6 * 2000.0) << kd;  // b > K T / 2 + |B|
  }
  SampledWall active;
  active.damping_N_s_per_m = 0.1;
  active.kd_N_s_per_m = 0.5;  // its damping alone is more than the arm's own, late by half a period
  EXPECT_EQ(passiveLimit(active), 0.0);
  EXPECT_EQ(colgateSchenkel(active), 0.0);
}

TEST(SampledWall, WhatIsPassiveIsStableInAnyHand) {
  test::Random random(test::Seed{19970101});
  for (int round = 0; round < test::sweep(200, 5000); ++round) {
    SampledWall wall = drawnWall(random);
    wall.hand_stiffness_N_per_m = 0.0;
    const double passive = passiveLimit(wall);
    for (const double hand : {0.0, 100.0, 3000.0}) {
      wall.hand_stiffness_N_per_m = hand;
      const double K = 0.999 * passive;
      if (K <= 0.0) continue;
      EXPECT_LE(spectralRadius(wall, K), 1.0 + 1e-12) << round;
    }
  }
}

TEST(SampledWall, ADelayIsWhatTheFormulaForAnyHandLeavesOut) {
  SampledWall wall;  // of 45 g, 0.1 N s/m
  EXPECT_NEAR(colgateSchenkel(wall), 200.0, 1e-9);
  wall.delay_ticks = 1;
  EXPECT_NEAR(colgateSchenkel(wall), 200.0, 1e-9);
  EXPECT_NEAR(exactLimit(wall).value(), 66.7, 0.1);
  EXPECT_NEAR(gilHulin(wall), 66.7, 0.1);
}

TEST(SampledWall, FrictionHoldsTheNominalStiffnessThatDampingAloneDoesNot) {
  SampledWall wall;  // 0.1 N s/m: 200 N/m
  EXPECT_EQ(tryWall(wall, 500.0).behaviour, Behaviour::Grows);
  wall.friction_N = 0.26;
  EXPECT_EQ(tryWall(wall, 500.0).behaviour, Behaviour::Rest);
  EXPECT_GT(simulatedLimit(wall), 500.0);
}

TEST(SampledWall, StepsOfTheEncodersKeepASwingAlive) {
  SampledWall wall;
  wall.damping_N_s_per_m = 0.11;  // some of it is left at 200 N/m
  wall.kd_N_s_per_m = 0.3;
  EXPECT_EQ(tryWall(wall, 200.0).behaviour, Behaviour::Rest);
  wall.coarseness = 1.0;
  const TrialResult stepped = tryWall(wall, 200.0);
  EXPECT_EQ(stepped.behaviour, Behaviour::LimitCycle);
  EXPECT_LT(stepped.amplitude_m, 3e-4);  // a few steps of 0.055 mm
  EXPECT_GT(stepped.amplitude_m, 1e-6);
}

TEST(SampledWall, CoarseStepsMakeNoSoftWallWild) {
  SampledWall wall;
  wall.coarseness = 2.0;
  for (const double kd : {0.05, 0.2, 5.0}) {
    wall.kd_N_s_per_m = kd;
    EXPECT_NE(tryWall(wall, 128.0).behaviour, Behaviour::Grows) << kd;  // what swings, swings by a step or two
    EXPECT_GT(simulatedLimit(wall), 190.0) << kd;
  }
}

TEST(SampledWall, OnlyALinearOneHasAnExactLimit) {
  SampledWall wall;
  EXPECT_TRUE(exactLimit(wall).has_value());
  wall.friction_N = 0.1;
  EXPECT_FALSE(exactLimit(wall).has_value());
  wall = {};
  wall.coarseness = 1.0;
  EXPECT_FALSE(exactLimit(wall).has_value());
  wall = {};
  wall.velocity = control::AdaptiveWindow{8, Vec3::Constant(1e-4)};
  EXPECT_FALSE(exactLimit(wall).has_value());
}

TEST(SwingObserver, TellsADecayASteadySwingAndGrowthApart) {
  const auto fate = [](double growth_a_tick, Motion motion) {
    SwingObserver observer(1.0, {100, 20'000, motion});
    double size = 0.5;
    for (int tick = 0; observer.goesOn(size * std::cos(0.7 * tick)); ++tick) size *= growth_a_tick;
    return observer.trial();
  };
  EXPECT_EQ(fate(0.999, Motion::Linear).behaviour, Behaviour::Rest);
  EXPECT_EQ(fate(1.001, Motion::Linear).behaviour, Behaviour::Grows);
  EXPECT_EQ(fate(0.999, Motion::Stepped).behaviour, Behaviour::Rest);
  EXPECT_EQ(fate(1.001, Motion::Stepped).behaviour, Behaviour::Grows);
  EXPECT_EQ(fate(1.0, Motion::Stepped).behaviour, Behaviour::LimitCycle);
  EXPECT_NEAR(fate(1.0, Motion::Stepped).amplitude_m, 0.5,
              0.5 * 0.7 * 0.7 / 2.0);                    // a sample within half a tick of each peak
  const auto slowly = [](double power, Motion motion) {  // by 5 % from each look to the next
    SwingObserver observer(1.0, {100, 20'000, motion});
    for (int tick = 0; observer.goesOn(0.3 * std::pow(1.0 + tick, power) * std::cos(0.7 * tick)); ++tick) continue;
    return observer.trial().behaviour;
  };
  EXPECT_EQ(slowly(0.07, Motion::Smooth), Behaviour::Grows);
  EXPECT_EQ(slowly(-0.07, Motion::Smooth), Behaviour::Rest);
  EXPECT_EQ(slowly(0.07, Motion::Stepped), Behaviour::LimitCycle);           // not beyond the push
  EXPECT_EQ(fate(kNotANumber, Motion::Linear).behaviour, Behaviour::Grows);  // nothing that is no number is calm
  SwingObserver stuck(1.0, {100, 20'000, Motion::Stepped});
  while (stuck.goesOn(0.4)) continue;  // by friction, beside its target
  EXPECT_EQ(stuck.trial().behaviour, Behaviour::Rest);
  EXPECT_EQ(stuck.trial().amplitude_m, 0.0);
}

}  // namespace
}  // namespace underact::stability
