#include "core/control/passivity.h"

#include <cmath>

#include "core/base/units.h"
#include "tests/core/control/tick.h"
#include "tests/support/property.h"

namespace underact::control {
namespace {

constexpr double kStiffness_N_per_m = 500.0;

/// A spring about the origin that is felt through samples, and a tip that goes where the test says.
struct Spring {
  EnergyState energy = {};
  double stiffness_N_per_m = kStiffness_N_per_m;
  double max_force_N = kInfinity;
  double level = 1.0;
  Passivity passivity = Passivity::Observe;
  Vec3 p_W = Vec3::Zero();
  Vec3 sent_T_W = Vec3::Zero();
  Vec3 damper_T_W = Vec3::Zero();
  bool edited = false;

  void tick(const Vec3& to_W) {
    PassivityInput passage;
    passage.displacement_T_W = to_W - p_W;
    passage.f_T_W = sent_T_W;
    passage.e_W = -to_W;
    const Vec3 spring_T_W = -stiffness_N_per_m * to_W;
    passage.stored_J = clampedEnergy(-0.5 * spring_T_W.dot(to_W), spring_T_W.norm(), max_force_N);
    passage.level = level;
    passage.dt_s = kTick_s;
    passage.pulls = true;
    passage.edited = edited;
    observe(energy, passage);
    damper_T_W = passivity == Passivity::Control ? damper(energy, passage) : Vec3(Vec3::Zero());
    const Vec3 asked_T_W = spring_T_W + damper_T_W;
    remember(energy, passage, asked_T_W);
    const double size_N = asked_T_W.norm();
    sent_T_W = level * (size_N > max_force_N ? max_force_N / size_N : 1.0) * asked_T_W;
    p_W = to_W;
    edited = false;
  }
};

TEST(Observer, SeesTheEnergyOfASampledSpringByHand) {
  Spring spring;
  spring.tick({0, 0, 0});
  spring.tick({0.001, 0, 0});  // the force in effect was 0
  EXPECT_EQ(spring.energy.energy_J, 0.0);
  spring.tick({0.002, 0, 0});  // against 0.5 N
  EXPECT_NEAR(spring.energy.energy_J, 0.5e-3, 1e-18);
  spring.tick({0.001, 0, 0});  // 1 N gives way
  EXPECT_NEAR(spring.energy.energy_J, -0.5e-3, 1e-18);
  spring.tick({0, 0, 0});  // 0.5 N
  EXPECT_NEAR(spring.energy.energy_J, -1e-3, 1e-18);
}

TEST(Observer, OfEachStepOfASampledSpringHalfKTimesItsSquareIsMissing) {
  // Along x by steps of dx in and out: a spring gives back K dx^2 / 2 more each tick, as a damper of K T / 2 below zero
  // would. Source: Colgate and Schenkel's bound b > K T / 2.
  for (const double step_m : {0.1e-3, 0.02e-3}) {
    Spring spring;
    spring.tick(Vec3::Zero());
    const int there = static_cast<int>(std::lround(2e-3 / step_m));
    for (int n = 1; n <= there; ++n) spring.tick({n * step_m, 0, 0});
    for (int n = there - 1; n >= 0; --n) spring.tick({n * step_m, 0, 0});
    const double v_m_per_s = step_m / kTick_s;
    const double leak_J = -0.5 * kStiffness_N_per_m * kTick_s * v_m_per_s * v_m_per_s * (2.0 * there * kTick_s);
    EXPECT_NEAR(spring.energy.energy_J, leak_J, 1e-9 * std::abs(leak_J));
    EXPECT_NEAR(spring.energy.balance_J, leak_J, 1e-9 * std::abs(leak_J)) << "and back at zero the reference is zero";
  }
}

TEST(Observer, SeesNoneWhereASpringIsMovedSlowlyThroughAClosedLoop) {
  // Round a loop of 1 to 3 mm in n steps: what a tick leaks goes with 1 / n, so ten times the steps leave a tenth.
  double last_J = 0.0;
  for (const int steps : {200, 2000, 20000}) {
    Spring spring;
    spring.tick({0.002, 0.001, 0.0});  // loaded at once: what it holds then is credited
    const double credit_J = spring.energy.energy_J;
    EXPECT_NEAR(credit_J, 0.5 * kStiffness_N_per_m * 5e-6, 1e-15);
    for (int n = 1; n <= steps; ++n) {
      const double a_rad = 2.0 * kPi * n / steps;
      spring.tick({0.001 + 0.001 * std::cos(a_rad), 0.001 + 0.002 * std::sin(a_rad), 0.001 * std::sin(2.0 * a_rad)});
    }
    const double leak_J = spring.energy.energy_J - credit_J;
    EXPECT_LT(leak_J, 0.0);
    if (last_J < 0.0) {
      EXPECT_NEAR(leak_J / last_J, 0.1, 0.005);
    }
    last_J = leak_J;
  }
  EXPECT_LT(std::abs(last_J), 1e-3 * 0.5 * kStiffness_N_per_m * 9e-6);
}

TEST(Observer, PairedWithTheForceOfTheSameTickItWouldSeeThatEnergyWithTheOtherSign) {
  // Why the pairing matters: the force asked for at the end of each step makes a lossy spring of an active one.
  double paired_J = 0.0, mistaken_J = 0.0, last_m = 0.0;
  for (int n = 1; n <= 40; ++n) {
    const double x_m = 1e-4 * (n <= 20 ? n : 40 - n);
    paired_J += kStiffness_N_per_m * last_m * (x_m - last_m);
    mistaken_J += kStiffness_N_per_m * x_m * (x_m - last_m);
    last_m = x_m;
  }
  Spring spring;
  spring.tick(Vec3::Zero());
  for (int n = 1; n <= 40; ++n) spring.tick({1e-4 * (n <= 20 ? n : 40 - n), 0, 0});
  EXPECT_NEAR(spring.energy.energy_J, paired_J, 1e-15);
  EXPECT_NEAR(mistaken_J, -paired_J, 1e-15);
}

TEST(Observer, WhatTheRampPutsInAndTakesOutIsNotTheHands) {
  Spring spring;
  spring.level = 0.0;
  spring.tick({0.002, 0, 0});
  for (int n = 1; n <= 300; ++n) {
    spring.level = n / 300.0;
    spring.tick({0.002, 0, 0});
  }
  const double held_J = 0.5 * kStiffness_N_per_m * 4e-6;
  EXPECT_NEAR(spring.energy.energy_J, held_J, 1e-15);
  EXPECT_NEAR(spring.energy.balance_J, 0.0, 1e-15);
  for (int n = 299; n >= 0; --n) {
    spring.level = n / 300.0;
    spring.tick({0.002, 0, 0});
  }
  EXPECT_NEAR(spring.energy.energy_J, 0.0, 1e-15) << "no credit is left over for the next start";
}

TEST(Observer, AnEditIsCreditedWithWhatItPutsIn) {
  Spring spring;
  spring.tick(Vec3::Zero());
  for (int n = 1; n <= 1000; ++n) spring.tick({2e-6 * n, 0, 0});
  const double before_J = spring.energy.energy_J, balance_J = spring.energy.balance_J;
  spring.stiffness_N_per_m *= 3.0;
  spring.edited = true;
  spring.tick({0.002, 0, 0});
  EXPECT_NEAR(spring.energy.energy_J - before_J, 2.0 * 0.5 * kStiffness_N_per_m * 4e-6, 1e-15);
  EXPECT_NEAR(spring.energy.balance_J, balance_J, 1e-15);
}

TEST(Observer, AClampedSpringHoldsLessAndLosesNothing) {
  EXPECT_EQ(clampedEnergy(1e-3, 0.5, 0.88), 1e-3);
  // 500 N/m, clamped at 0.88 N from 1.76 mm on, at 10 mm: 0.88^2 / 1000 + 0.88 * 8.24 mm.
  EXPECT_NEAR(clampedEnergy(0.5 * 500.0 * 1e-4, 5.0, 0.88), 0.7744e-3 + 0.88 * 8.24e-3, 1e-15);
  EXPECT_EQ(clampedEnergy(kInfinity, kInfinity, 0.88), 0.0);
  EXPECT_EQ(clampedEnergy(kNotANumber, 1.0, 0.88), 0.0);
  Spring spring;
  spring.max_force_N = 0.88;
  spring.tick(Vec3::Zero());
  for (int n = 1; n <= 10000; ++n) spring.tick({1e-6 * n, 0, 0});
  for (int n = 9999; n >= 0; --n) spring.tick({1e-6 * n, 0, 0});
  // Beyond the clamp the force is the same in and out; below it K dx^2 / 2 of 1760 steps each way.
  EXPECT_NEAR(spring.energy.energy_J, -2.0 * 1760.0 * 0.5 * 500.0 * 1e-12, 1e-11);
}

TEST(Observer, AWayThatShowsInStepsIsPairedWithTheMeanForceSinceTheStepBefore) {
  Spring spring;
  spring.tick(Vec3::Zero());
  for (const double sent_N : {0.1, -0.3, -0.7}) {  // in effect in the three ticks until a step of 0.055 mm shows
    spring.sent_T_W = {sent_N, 0, 0};
    spring.tick({sent_N == -0.7 ? 55e-6 : 0.0, 0, 0});
  }
  EXPECT_NEAR(spring.energy.energy_J, 0.3 * 55e-6, 1e-18);
}

TEST(Controller, AddsNothingWhereNothingIsMissing) {
  Spring spring;
  spring.passivity = Passivity::Control;
  spring.tick({0.002, 0, 0});
  for (int n = 0; n < 100; ++n) {
    spring.energy.balance_J = 1e-6;
    spring.tick({0.002 + 1e-6 * n, 0, 0});
    ASSERT_EQ(spring.damper_T_W, Vec3(Vec3::Zero()));
  }
}

TEST(Controller, WhatWasDissipatedLongAgoPaysForHalfAMillijoule) {
  EnergyState energy;
  PassivityInput passage;
  passage.pulls = true;
  passage.dt_s = kTick_s;
  passage.level = 1.0;
  passage.f_T_W = {-1.0, 0, 0};
  passage.displacement_T_W = {0.001, 0, 0};  // 1 mJ a tick is taken
  for (int n = 0; n < 100; ++n) {
    observe(energy, passage);
    remember(energy, passage, passage.f_T_W);
  }
  EXPECT_NEAR(energy.balance_J, 5e-4, 1e-12);
}

TEST(Controller, ByHand) {  // 10 N/m, 1 mm a tick: K dx^2 / 2 = 5e-6 J is missing, over 1 mm: 5 mN against the way
  Spring spring;
  spring.stiffness_N_per_m = 10.0;
  spring.passivity = Passivity::Control;
  spring.tick(Vec3::Zero());
  spring.tick({0.001, 0, 0});
  EXPECT_NEAR(spring.damper_T_W.x(), -5e-3, 1e-17);
  spring.tick({0.002, 0, 0});  // that force took the 5e-6 J, the spring lost another
  EXPECT_NEAR(spring.damper_T_W.x(), -5e-3, 1e-15);
}

TEST(Controller, IsADamperOfHalfKTimesTheTick) {
  Spring spring;
  spring.passivity = Passivity::Control;
  spring.tick(Vec3::Zero());
  for (int n = 1; n <= 100; ++n) {
    spring.tick({2e-5 * n, 0, 0});
    ASSERT_NEAR(spring.damper_T_W.x(), -0.5 * kStiffness_N_per_m * kTick_s * 0.02, 1e-12) << n;
  }
}

TEST(Controller, ABearableTickTakesTheSpeedOfTheArmAloneAndOwesTheRest) {
  Spring spring;
  spring.passivity = Passivity::Control;
  spring.tick(Vec3::Zero());
  spring.energy.balance_J = -1.0;
  spring.tick({1e-5, 0, 0});
  // Of 0.01 m/s, smoothed over 2 ms, a third is seen in the first tick.
  EXPECT_NEAR(spring.damper_T_W.x(), -0.045 * 0.01 / kTick_s / 3.0, 1e-12);
  EXPECT_LT(spring.energy.balance_J, -0.99);
}

TEST(Controller, AlongTheConstraintTheStylusStaysFree) {  // a plane's error does not change along it
  EnergyState energy;
  PassivityInput passage;
  passage.e_W = {0, 1e-3, 0};
  passage.dt_s = kTick_s;
  passage.pulls = true;
  observe(energy, passage);
  remember(energy, passage, Vec3::Zero());
  passage.displacement_T_W = {1e-4, 0, 2e-4};
  observe(energy, passage);
  energy.balance_J = -1e-3;
  EXPECT_EQ(damper(energy, passage), Vec3(Vec3::Zero()));
  remember(energy, passage, Vec3::Zero());
  passage.displacement_T_W.y() = -1e-5;
  passage.e_W.y() += 1e-5;
  observe(energy, passage);
  energy.balance_J = -1e-3;
  const Vec3 f_T_W = damper(energy, passage);
  EXPECT_GT(f_T_W.y(), 0.0);
  EXPECT_EQ(f_T_W.x(), 0.0);
  EXPECT_EQ(f_T_W.z(), 0.0);
}

TEST(Controller, AnEditIsNoMotionToDamp) {
  Spring spring;
  spring.passivity = Passivity::Control;
  spring.tick({0.002, 0, 0});
  spring.tick({0.0021, 0, 0});
  spring.energy.balance_J = -1.0;
  spring.edited = true;
  spring.tick({0.0022, 0, 0});
  EXPECT_EQ(spring.damper_T_W, Vec3(Vec3::Zero()));
}

TEST(Passivity, WithTheControllerAnyMotionPutsInMoreThanItGetsBack) {
  test::Random random(test::Seed{6101});
  for (int draw = 0; draw < test::sweep(50, 5000); ++draw) {
    Spring spring, watched;
    spring.passivity = Passivity::Control;
    spring.stiffness_N_per_m = watched.stiffness_N_per_m = std::pow(10.0, random.between(2.0, 4.0));
    const double amplitude_m = random.between(1e-4, 5e-3), w1 = random.between(5.0, 60.0),
                 w2 = random.between(5.0, 60.0);
    double peak_power_J = 0.0;
    for (int n = 0; n <= 5000; ++n) {
      const double t_s = kTick_s * n;
      const Vec3 p_W = amplitude_m * Vec3(std::sin(w1 * t_s), std::sin(w2 * t_s), 0.3 * std::sin(w1 * t_s));
      spring.tick(p_W), watched.tick(p_W);
      peak_power_J = std::max(peak_power_J, 0.5 * spring.stiffness_N_per_m * amplitude_m * amplitude_m);
    }
    EXPECT_LT(watched.energy.energy_J - watched.energy.stored_J, 0.0) << "the case did not come up";
    // What a tick leaks is paid in the next one: a tenth of what the spring can hold is more than is ever owed.
    EXPECT_GT(spring.energy.energy_J, -0.1 * peak_power_J) << draw;
  }
}

TEST(Passivity, FiniteInFiniteOut) {
  test::Random random(test::Seed{6102});
  EnergyState energy;
  for (int n = 0; n < test::sweep(20000, 1000000); ++n) {
    const auto any = [&] { return std::pow(10.0, random.between(-150.0, 150.0)); };
    PassivityInput passage;
    passage.displacement_T_W = any() * random.direction();
    passage.f_T_W = any() * random.direction();
    passage.e_W = any() * random.direction();
    passage.stored_J = clampedEnergy(any(), any(), 0.88);
    passage.level = random.between(0.0, 1.0);
    passage.dt_s = random.below(10) == 0 ? 0.0 : random.between(1e-9, 0.1);
    passage.pulls = random.below(4) != 0;
    passage.untouched = random.below(4) == 0;
    passage.edited = random.below(10) == 0;
    observe(energy, passage);
    const Vec3 f_T_W = damper(energy, passage);
    remember(energy, passage, f_T_W);
    ASSERT_TRUE(std::isfinite(energy.energy_J) && std::isfinite(energy.balance_J)) << n;
  }
}

}  // namespace
}  // namespace underact::control
