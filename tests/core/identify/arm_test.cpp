// The whole measurement on simulated arms: it must find what the simulation was given within 5 %.
#include <gtest/gtest.h>

#include <cmath>
#include <set>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "core/arm/forward.h"
#include "core/arm/jacobian.h"
#include "core/arm/preset.h"
#include "core/base/units.h"
#include "core/identify/report.h"
#include "tests/core/identify/rig.h"
#include "tests/support/property.h"

namespace underact::identify::test {
namespace {

constexpr double kShare = 0.05;
// What encoders hide. A force dF that acts on a mass over a window of 0.25 s moves it by dF W^2 / (2 m), and a damping
// b over a travel L by about b L W / (6 m). Below one step (0.055 mm) of that, a window cannot tell it. A swing by 10
// mm under k = 100 N/m travels 20 mm without friction, and ends 2 F / k earlier with it.
constexpr double kStep_m = 0.055e-3, kWindow_s = 0.25, kTravel_m = 0.02, kSpring_N_per_m = 100.0;
double minForce_N(double mass_kg) {
  return 2.0 * mass_kg * kStep_m / (kWindow_s * kWindow_s);
}
double minDamping(double mass_kg, double friction_N) {
  const double travel_m = kTravel_m - 2.0 * friction_N / kSpring_N_per_m;
  return 6.0 * mass_kg * kStep_m / (travel_m * kWindow_s);
}

struct Case {
  const char* preset;
  int rate_hz;
  double mass_kg, friction_N, damping_N_s_per_m;
};

std::string wordsOf(const Case& one) {
  return std::string(one.preset) + " " + std::to_string(one.rate_hz) + " Hz, " + std::to_string(one.mass_kg) + " kg, " +
         std::to_string(one.friction_N) + " N, " + std::to_string(one.damping_N_s_per_m) + " N s/m";
}

Identified identified(const Case& one, bool encoders = true) {
  sim::ArmModel model = armOf(one.mass_kg, one.friction_N, one.damping_N_s_per_m);
  model.encoders = encoders;
  const Measured done = measured(model, one.preset, one.rate_hz);
  const Result<Identified> found = evaluate(done.plan, done.recorded, one.rate_hz);
  EXPECT_TRUE(static_cast<bool>(found)) << (found ? "" : found.problems().front().sentence);
  return found ? found.value() : Identified{};
}

void expectGiven(const Case& one) {
  SCOPED_TRACE(wordsOf(one));
  const Identified found = identified(one);
  const double damping = std::max(kShare * one.damping_N_s_per_m, minDamping(one.mass_kg, one.friction_N));
  EXPECT_NEAR(found.mean_mass_kg.value, one.mass_kg, kShare * one.mass_kg);
  EXPECT_NEAR(found.mean_friction_N.value, one.friction_N, std::max(kShare * one.friction_N, minForce_N(one.mass_kg)));
  EXPECT_NEAR(found.mean_damping_N_s_per_m.value, one.damping_N_s_per_m, damping);
  const arm::EncoderCounts& counts = arm::findPreset(one.preset)->counts_per_turn;
  for (std::size_t joint = 0; joint < 6; ++joint) {
    ASSERT_TRUE(found.counts_per_turn[joint]) << joint;
    EXPECT_NEAR(found.counts_per_turn[joint]->value, counts[joint], 1e-6 * counts[joint]) << joint;
  }
  ASSERT_TRUE(found.press);
  EXPECT_NEAR(found.press->stiffness_N_per_m.value, 500.0, kShare * 500.0);
  EXPECT_NEAR(found.press->clamped_at_m.value(), 0.88 / 500.0, 0.1e-3);  // two encoder steps
}

TEST(SimulatedArm, GivesBackTheVendorsFigures) {
  for (const char* preset : {"omni-thesis", "touch-measured"}) expectGiven({preset, 1000, 0.045, 0.26, 0.0});
}

/// A grid of arms; all of them in a soak, else every `stride`-th. A stride without a factor of the grid's sides meets
/// each value of each, which is looked at.
void expectGrid(int rate_hz, const std::vector<double>& masses_kg, const std::vector<double>& frictions_N,
                const std::vector<double>& dampings_N_s_per_m, int stride) {
  std::set<std::pair<int, double>> seen;
  int index = 0;
  for (const char* preset : {"omni-thesis", "touch-measured"}) {
    for (const double mass_kg : masses_kg) {
      for (const double friction_N : frictions_N) {
        for (const double damping : dampings_N_s_per_m) {
          if (index++ % (underact::test::isSoak() ? 1 : stride) != 0) continue;
          expectGiven({preset, rate_hz, mass_kg, friction_N, damping});
          seen.insert({{0, std::string_view(preset) == "omni-thesis"}, {1, mass_kg}, {2, friction_N}, {3, damping}});
        }
      }
    }
  }
  EXPECT_EQ(seen.size(), 2 + masses_kg.size() + frictions_N.size() + dampings_N_s_per_m.size());
}

TEST(SimulatedArm, GivesBackLightAndHeavyOnesWithFrictionAndDampingSmallAndLargeAt1kHz) {
  expectGrid(1000, {0.02, 0.1, 0.3}, {0.05, 0.25, 0.6}, {0.0, 0.3, 1.0, 3.0}, underact::test::kIsWatched ? 11 : 5);
}

TEST(SimulatedArm, GivesThemBackAt4kHz) {
  expectGrid(4000, {0.02, 0.3}, {0.05, 0.6}, {0.0, 0.5, 3.0}, 5);
}

TEST(SimulatedArm, TheStiffnessOfItsFreeSwingsIsTheOneOfTheLaw) {
  for (const double mass_kg : {0.045, 0.1, 0.3}) {
    const Identified found = identified({"omni-thesis", 1000, mass_kg, 0.1, 0.2});
    int told = 0;
    for (const AxisSwings& one : found.swings) {
      if (!one.stiffness) continue;
      ++told;
      EXPECT_NEAR(one.stiffness->value_N_per_m, 100.0, 0.01 * 100.0) << mass_kg << " kg, axis " << one.axis;
    }
    EXPECT_EQ(told, 3) << mass_kg << " kg";
  }
}

TEST(SimulatedArm, ItsNoiseIsThatOfItsEncoders) {
  const Identified found = identified({"omni-thesis", 1000, 0.045, 0.26, 0.0});
  EXPECT_EQ(found.rest_noise_m.norm(), 0.0);  // friction holds it, and a step is a step
  // The tip's share of each joint's even spread, step / sqrt(12), at the place where it is pressed: along y and z both
  // joints of the arm's plane count. 30 %: a few steps only in each tenth of a second.
  const arm::Preset& preset = *arm::findPreset("omni-thesis");
  const Measured done = measured(armOf(0.045, 0.26, 0.0), "omni-thesis", 1000);
  const arm::Tip tip = arm::tip(preset.geometry, done.recorded.front().rows.front().q_rad);
  const double thigh_m = tip.J_p.col(1).y() - tip.J_p.col(2).y(), shin_m = tip.J_p.col(2).y();  // of device angles
  const double expected_m =
      2.0 * kPi / std::sqrt(12.0) * std::hypot(thigh_m / preset.counts_per_turn[1], shin_m / preset.counts_per_turn[2]);
  EXPECT_NEAR(found.slow_noise_m.y(), expected_m, 0.3 * expected_m);
}

TEST(SimulatedArm, OwnEncodersAreSeen) {
  sim::ArmModel model = armOf(0.045, 0.26, 0.1);
  model.counts_per_turn = arm::EncoderCounts{20000.0, 8192.0, 12000.0, 4000.0, 5000.0, 6000.0};
  const Measured done = measured(model, "omni-thesis", 1000);
  const Result<Identified> found = evaluate(done.plan, done.recorded, 1000);
  ASSERT_TRUE(static_cast<bool>(found));
  for (std::size_t joint = 0; joint < 6; ++joint) {
    ASSERT_TRUE(found.value().counts_per_turn[joint]);
    EXPECT_NEAR(found.value().counts_per_turn[joint]->value, (*model.counts_per_turn)[joint], 0.01);
  }
}

TEST(SimulatedArm, WithoutEncodersItHasNoneAndTheFitIsNearerStill) {
  const Identified found = identified({"omni-thesis", 1000, 0.045, 0.26, 0.5}, false);
  for (const auto& count : found.counts_per_turn) EXPECT_FALSE(count);
  // What is left is the simulation's own substep of 10 us, which a reversal ends early; with 200 us it is 0.15 %.
  EXPECT_NEAR(found.mean_mass_kg.value, 0.045, 2e-4 * 0.045);
  EXPECT_NEAR(found.mean_friction_N.value, 0.26, 2e-4 * 0.26);
  EXPECT_NEAR(found.mean_damping_N_s_per_m.value, 0.5, 1e-3 * 0.5);
  EXPECT_FALSE(modelFileOf(found, "x", "X", {}).arm.encoders);
}

TEST(SimulatedArm, ADampingThatIsNotThereIsSaidToBeBelowSomething) {
  const Identified found = identified({"omni-thesis", 1000, 0.045, 0.26, 0.0});
  const Estimate& damping = found.mean_damping_N_s_per_m;
  EXPECT_LT(std::abs(damping.value), minDamping(0.045, 0.26));
  EXPECT_FALSE(damping.isSignificant()) << damping.value << " +- " << damping.uncertainty;
  EXPECT_EQ(valueText({"", "", damping}).substr(0, 6), "below ");
  EXPECT_EQ(modelFileOf(found, "x", "X", {}).arm.damping_N_s_per_m, 0.0);
}

TEST(SimulatedArm, AtOtherPlacesItIsTheSameArm) {
  Wanted wanted;
  wanted.places_W = {{0.0, 0.0, 0.06}, {0.03, 0.02, 0.05}, {-0.03, -0.02, 0.05}};
  const Measured done = measured(armOf(0.06, 0.2, 0.3), "omni-thesis", 1000, wanted);
  const Result<Identified> found = evaluate(done.plan, done.recorded, 1000);
  ASSERT_TRUE(static_cast<bool>(found));
  EXPECT_EQ(found.value().swings.size(), 9U);
  for (const AxisSwings& one : found.value().swings)
    EXPECT_NEAR(one.fit.body.mass_kg, 0.06, kShare * 0.06) << one.place << " " << one.axis;
}

TEST(SimulatedArm, AnArmWithoutMassIsRefusedInWords) {
  const Measured done = measured(*sim::findArmModel("ideal"), "omni-thesis", 1000);
  const Result<Identified> found = evaluate(done.plan, done.recorded, 1000);
  ASSERT_FALSE(static_cast<bool>(found));
  EXPECT_NE(found.problems().front().sentence.find("hardly moved"), std::string::npos);
}

TEST(SimulatedArm, AnEvaluationEndsWhereverItIsTold) {
  const Measured done = measured(armOf(0.045, 0.26, 0.1), "omni-thesis", 1000);
  int asked = 0;
  ASSERT_TRUE(evaluate(done.plan, done.recorded, 1000, [&] { return ++asked < 0; }));
  const int all = asked;
  EXPECT_GT(all, 1000) << "some 5000 in 0.15 s are as it should be";
  for (const int when : {1, all / 3, all / 2, all - 8, all - 3, all}) {  // in the fits, the counts, and after them
    asked = 0;
    const Result<Identified> found = evaluate(done.plan, done.recorded, 1000, [&] { return ++asked >= when; });
    ASSERT_FALSE(static_cast<bool>(found)) << when;
    EXPECT_EQ(found.problems().size(), 1U) << when;
    EXPECT_EQ(asked, when) << "it went on";
  }
}

TEST(SimulatedArm, TheSameSeedGivesTheSameBits) {
  const Identified a = identified({"omni-thesis", 1000, 0.045, 0.26, 0.1});
  const Identified b = identified({"omni-thesis", 1000, 0.045, 0.26, 0.1});
  EXPECT_EQ(a.mean_mass_kg.value, b.mean_mass_kg.value);
  EXPECT_EQ(a.mean_friction_N.uncertainty, b.mean_friction_N.uncertainty);
}

}  // namespace
}  // namespace underact::identify::test
