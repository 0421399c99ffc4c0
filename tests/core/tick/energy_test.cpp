#include <cmath>

#include "tests/support/robots.h"
#include "tests/support/tick_hand.h"

namespace underact::tick {
namespace {

using control::P;
using control::Passivity;
using test::Hand;

const shape::Shape kEnergyPoint = shape::makePoint({0.01, 0.02, 0.03}, {}).value();
const shape::Shape kEnergyFloor = shape::makePlane({0, 0, 0}, {0, 1, 0}, {}).value();
const Vec3 kThere{0.01, 0.02, 0.03};
constexpr double kStiffness_N_per_m = 100.0;

Entry watched(const shape::Shape& shape, double stiffness_N_per_m = kStiffness_N_per_m,
              Passivity passivity = Passivity::Observe, target::Side side = target::Side::Both) {
  Entry entry = test::hold(shape, P{Vec3::Constant(stiffness_N_per_m)}, side);
  entry.passivity = passivity;
  return entry;
}

double energyOf(const Hand& hand, std::size_t index = 0) {
  return hand.report().held[index].energy_J;
}

TEST(Energy, IsLookedAtWhereTheSceneAsksAndCostsNothingElsewhere) {
  EXPECT_FALSE(Hand({test::hold(kEnergyPoint, P{})}, Combine::Sum).program().needs.energy);
  EXPECT_EQ(bytesOf(Hand({test::hold(kEnergyPoint, P{})}, Combine::Sum).state()), sizeof(TickState));
  Hand hand({watched(kEnergyPoint), watched(kEnergyFloor, 100.0, Passivity::Off)}, Combine::Sum);
  EXPECT_EQ(bytesOf(hand.state()), sizeof(TickState) + 2 * sizeof(control::EnergyState));
  hand.settle(kThere + Vec3(0.004, 0, 0));
  EXPECT_GT(energyOf(hand), 0.0);
  EXPECT_EQ(energyOf(hand, 1), 0.0) << "of another one nobody asked";
}

TEST(Energy, WhatTheRampPutIntoASpringComesOutAgainWithTheRamp) {
  Hand hand({watched(kEnergyPoint)}, Combine::Sum);
  hand.settle(kThere + Vec3(0.004, 0, 0));
  EXPECT_NEAR(energyOf(hand), 0.5 * kStiffness_N_per_m * 16e-6, 1e-12);
  hand.input.engage = false;
  for (int tick = 0; tick < 50; ++tick) hand.at(kThere + Vec3(0.004, 0, 0));
  // The account knows the gate of the tick before: one step of the 50 is still to come.
  EXPECT_NEAR(energyOf(hand), 0.02 * 0.5 * kStiffness_N_per_m * 16e-6, 1e-12);
}

TEST(Energy, OfAPushIsTheSpringsAndComesBackButForTheLeakOfItsSampling) {
  Hand hand({watched(kEnergyPoint)}, Combine::Sum);
  hand.settle(kThere);
  const double step_m = 1e-5;
  for (int n = 1; n <= 400; ++n) hand.at(kThere + Vec3(step_m * n, 0, 0));
  const double leak_J = 0.5 * kStiffness_N_per_m * step_m * step_m * 400.0;
  EXPECT_NEAR(energyOf(hand), 0.5 * kStiffness_N_per_m * 16e-6 - leak_J, 1e-11);
  for (int n = 399; n >= 0; --n) hand.at(kThere + Vec3(step_m * n, 0, 0));
  EXPECT_NEAR(energyOf(hand), -2.0 * leak_J, 1e-11);
}

TEST(Energy, OfAClampedSpringStaysThatOfWhatTheGateLetThrough) {
  Hand hand({watched(kEnergyPoint, 2000.0)}, Combine::Sum);  // 0.88 N at 0.44 mm
  hand.settle(kThere);
  for (int n = 1; n <= 4000; ++n) hand.at(kThere + Vec3(1e-6 * n, 0, 0));
  const double held_J = 0.5 * 0.88 * 0.44e-3 + 0.88 * 3.56e-3;
  EXPECT_NEAR(energyOf(hand), held_J, 1e-3 * held_J);
  for (int n = 3999; n >= 0; --n) hand.at(kThere + Vec3(1e-6 * n, 0, 0));
  EXPECT_NEAR(energyOf(hand), 0.0, 1e-3 * held_J);
}

TEST(Energy, SeveralShareTheForceAsTheyAskedForIt) {
  // Both pull the same way; together they are clamped from 0.44 mm on.
  Hand hand({watched(kEnergyPoint, 500.0), watched(kEnergyPoint, 1500.0)}, Combine::Sum);
  hand.settle(kThere);
  for (int n = 1; n <= 400; ++n) hand.at(kThere + Vec3(1e-6 * n, 0, 0));
  EXPECT_NEAR(energyOf(hand, 0), 0.5 * 500.0 * 0.16e-6, 0.01 * 0.5 * 500.0 * 0.16e-6);
  EXPECT_NEAR(energyOf(hand, 1) / energyOf(hand, 0), 3.0, 1e-6);
}

TEST(Energy, ANearestOneThatTakesOverIsCreditedWithWhatItHolds) {
  const shape::Shape left = shape::makePoint({-0.01, 0.02, 0.03}, {}).value();
  const shape::Shape right = shape::makePoint({0.01, 0.02, 0.03}, {}).value();
  Hand hand({watched(left), watched(right)}, Combine::Nearest);
  hand.settle({-0.01, 0.02, 0.03});
  for (int n = 1; n <= 2000; ++n) hand.at({-0.01 + 1e-5 * n, 0.02, 0.03});
  EXPECT_NEAR(energyOf(hand, 0), 0.0, 1e-5) << "handed over with its 5 mJ";
  EXPECT_NEAR(energyOf(hand, 1), 0.0, 1e-5) << "which came back from the other";
  EXPECT_TRUE(hand.report().held[1].acts);
}

TEST(Energy, AnEditOfTheGainIsCredited) {
  const auto program = [](double stiffness_N_per_m) {
    return makeProgram(test::thesisGeometry(), {watched(kEnergyPoint, stiffness_N_per_m)}, Combine::Sum,
                       test::kTestLimits);
  };
  const Vec3 there = kThere + Vec3(0.004, 0, 0);
  Hand hand(program(50.0)), edited(program(100.0));
  hand.settle(there);
  carryOver(hand.state(), edited.state());
  edited.input.sample = hand.input.sample;
  edited.at(there);
  EXPECT_NEAR(energyOf(edited), 0.5 * 100.0 * 16e-6, 1e-12);
}

TEST(Energy, WhileTheServoIsIdleTheAccountIsEmpty) {
  Hand hand({watched(kEnergyPoint)}, Combine::Sum);
  hand.settle(kThere + Vec3(0.004, 0, 0));
  hand.input.engage = false;
  hand.settle(kThere);
  EXPECT_EQ(energyOf(hand), 0.0);
  EXPECT_EQ(hand.state().entries[0].energy.balance_J, 0.0);
}

TEST(Energy, TheControllersForceIsAPartOfTheConstraintsAndNeverTurnsItRound) {
  for (const target::Side side : {target::Side::Both, target::Side::Outside}) {
    Hand hand({watched(kEnergyFloor, 50'000.0, Passivity::Control, side)}, Combine::Sum);
    hand.settle({0.01, 0.001, 0.03});
    bool acted = false;
    for (int tick = 0; tick < 3000; ++tick) {
      const TickReport& report = hand.at({0.01, 0.0005 * std::sin(0.2 * tick), 0.03});
      const ConstraintReport& held = report.held[0];
      ASSERT_GE(held.f_T_W.dot(held.p_WP - report.p_WT), 0.0) << tick;
      acted = acted || held.f_passive_T_W.norm() > 0.01;
    }
    EXPECT_TRUE(acted) << "the case did not come up";
  }
}

TEST(Energy, FiniteInFiniteOutUnderTheController) {
  test::Random random(test::Seed{6201});
  for (int draw = 0; draw < test::sweep(60, 3000); ++draw) {
    std::vector<Entry> entries;
    for (std::size_t count = 1 + random.below(3); count > 0; --count) {
      const std::vector<shape::Shape> shapes = test::middleShapes();
      Entry entry = test::hold(shapes[random.below(shapes.size())], test::everyLaw()[random.below(6)]);
      entry.passivity = Passivity::Control;
      if (random.below(3) == 0) entry.space = Space::Joint;
      entries.push_back(entry);
    }
    const std::vector<manipulator::Manipulator> robots = test::everyRobot();
    entries.push_back(test::holdTo(robots[random.below(robots.size())], test::everyLaw()[random.below(6)]));
    entries.back().passivity = Passivity::Control;
    Hand hand(entries, random.below(2) == 0 ? Combine::Sum : Combine::Nearest);
    for (int tick = 0; tick < 60; ++tick) {
      const auto angle = [&] {
        return random.below(50) == 0 ? std::pow(10.0, random.between(-300.0, 300.0)) : random.between(-3.2, 3.2);
      };
      hand.input.restart = random.below(30) == 0;
      hand.input.has_sample = random.below(20) != 0;
      const TickReport& report =
          hand.feed({angle(), angle(), angle(), angle(), angle(), angle()}, std::pow(10.0, random.between(-6.0, 0.0)));
      ASSERT_TRUE(report.f_T_W.allFinite() && report.force.f_T_W().allFinite()) << draw;
      for (const ConstraintReport& held : report.held) {
        ASSERT_TRUE(std::isfinite(held.energy_J) && held.f_passive_T_W.allFinite()) << draw;
      }
    }
  }
}

}  // namespace
}  // namespace underact::tick
