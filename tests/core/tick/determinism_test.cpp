#include <cmath>
#include <cstring>

#include "tests/support/robots.h"
#include "tests/support/tick_hand.h"

namespace underact::tick {
namespace {

using test::Hand;
using test::hold;
using test::Random;

/// Every shape under every law, both metrics, walls among them.
TickProgram everything(Combine combine) {
  std::vector<Entry> entries;
  for (const shape::Shape& shape : test::middleShapes()) {
    for (const control::Law& law : test::everyLaw()) {
      entries.push_back(hold(
          shape, law, shape::hasSides(shape) && entries.size() % 3 == 1 ? target::Side::Outside : target::Side::Both));
    }
  }
  return makeProgram(test::thesisGeometry(), entries, combine, test::kTestLimits);
}

void add(test::Checksum& sum, const TickReport& report) {
  sum.add(report.p_WT), sum.add(report.f_T_W), sum.add(report.force.f_T_W());
  sum.add(report.level), sum.add(report.cut_N), sum.add(report.fault.seen);
  for (const ConstraintReport& held : report.held) {
    sum.add(held.p_WP), sum.add(held.f_T_W), sum.add(held.distance_m);
    sum.add(static_cast<double>(held.status));
  }
}

void addRobots(test::Checksum& sum, const TickReport& report) {
  for (const ConstraintReport& held : report.held) {
    for (const double value : held.robot.theta) sum.add(value);
    sum.add(held.robot.moment_W), sum.add(held.robot.energy_J), sum.add(held.robot.better_J);
    sum.add(static_cast<double>(held.robot.steps));
  }
}

/// Every sort of virtual manipulator, their watches going on beside them.
std::uint64_t scriptedRobots(int ticks) {
  test::Checksum sum;
  std::vector<Entry> entries;
  for (const manipulator::Manipulator& robot : test::everyRobot())
    entries.push_back(test::holdTo(robot, test::everyLaw()[2]));
  Hand hand(makeProgram(test::thesisGeometry(), entries, Combine::Sum, test::kTestLimits));
  for (int tick = 0; tick < ticks; ++tick) {
    hand.input.has_sample = tick % 997 != 0;
    const TickReport& report = hand.feed(test::scriptedAngles(tick));
    add(sum, report), addRobots(sum, report);
  }
  return sum.value();
}

std::uint64_t scripted(Combine combine, int ticks) {
  test::Checksum sum;
  Hand hand(everything(combine));
  for (int tick = 0; tick < ticks; ++tick) {
    hand.input.engage = tick % 20000 < 15000;
    hand.input.has_sample = tick % 997 != 0;
    add(sum, hand.feed(test::scriptedAngles(tick)));
  }
  return sum.value();
}

/// Every velocity filter, each under the passivity controller.
std::uint64_t scriptedFilters(int ticks) {
  test::Checksum sum;
  const Vec3 kp = Vec3::Constant(5000.0), kd = Vec3::Constant(2.0);
  std::vector<Entry> entries;
  for (const control::Velocity& velocity :
       {control::Velocity(control::LowPass{}), control::Velocity(control::RawDifference{}),
        control::Velocity(control::AdaptiveWindow{16, Vec3::Constant(1e-4)}),
        control::Velocity(control::Kalman{16e-6, 8.0})}) {
    entries.push_back(hold(test::middleShapes()[entries.size()], control::PD{kp, kd, velocity}));
    entries.back().passivity = control::Passivity::Control;
  }
  Hand hand(makeProgram(test::thesisGeometry(), entries, Combine::Sum, test::kTestLimits));
  for (int tick = 0; tick < ticks; ++tick) {
    hand.input.engage = tick % 20000 < 15000;
    hand.input.has_sample = tick % 997 != 0;
    const TickReport& report = hand.feed(test::scriptedAngles(tick));
    add(sum, report);
    for (const ConstraintReport& held : report.held) sum.add(held.energy_J), sum.add(held.f_passive_T_W);
  }
  return sum.value();
}

TEST(Determinism, EqualArgumentsGiveEqualBits) {
  for (const Combine combine : {Combine::Sum, Combine::Nearest})
    EXPECT_EQ(scripted(combine, 5000), scripted(combine, 5000));
  EXPECT_EQ(scriptedRobots(3000), scriptedRobots(3000));
  EXPECT_EQ(scriptedFilters(3000), scriptedFilters(3000));
}

TEST(Determinism, WhatStandsInTheReportBeforeDoesNotMatter) {
  Hand hand(everything(Combine::Sum)), other(everything(Combine::Nearest));
  for (int tick = 0; tick < 100; ++tick) {
    hand.feed(test::scriptedAngles(tick)), other.feed(test::scriptedAngles(7 * tick));
  }
  for (const bool has_sample : {true, false}) {
    for (const bool is_number : {true, false}) {
      TickInput input = hand.input;
      input.sample.time_ns += 1000000;
      input.has_sample = has_sample;
      if (!is_number) input.sample.q_rad[1] = kNotANumber;
      TickState one = hand.state(), two = hand.state();
      TickReport fresh, used = other.report();
      step(hand.program(), input, one, fresh);
      step(hand.program(), input, two, used);
      test::Checksum first, second;
      add(first, fresh), add(second, used);
      EXPECT_EQ(first.value(), second.value());
      EXPECT_EQ(fresh.held.size(), used.held.size());
    }
  }
}

// The bits that GCC 12 gave at -O2 on x86-64. Every compiler and every level of optimisation must give them: a session
// recorded with one is replayed with another. They change only with the arithmetic of the tick; then say so in the
// commit.
TEST(Determinism, TheBitsAreTheseWithEveryCompiler) {
  EXPECT_EQ(scripted(Combine::Sum, 100000), 3419118755521318700U);
  EXPECT_EQ(scripted(Combine::Nearest, 100000), 9443127627009765879U);
  EXPECT_EQ(scriptedRobots(20000), 8605149340115063271U);
  EXPECT_EQ(scriptedFilters(50000), 1937892153440626195U);
}

TEST(Determinism, FiniteInFiniteOutWhateverTheProgram) {
  Random random(test::Seed{20071101});
  for (int draw = 0; draw < test::sweep(300, 20000); ++draw) {
    std::vector<Entry> entries;
    const std::size_t count = 1 + random.below(6);
    for (std::size_t i = 0; i < count; ++i) {
      const auto gain = [&](double exponent) {
        return random.below(2) == 0 ? Vec3(Vec3::Constant(std::pow(10.0, exponent)))
                                    : Vec3(std::pow(10.0, exponent), std::pow(10.0, random.between(0, exponent)), 1.0);
      };
      const Vec3 c = random.below(4) == 0 ? random.inBox(1000.0) : random.inBox(0.1), n = random.direction();
      const double r = std::pow(10.0, random.between(-6.0, 3.0));
      const shape::Shape shapes[] = {shape::Point{c},
                                     shape::Sphere{c, r},
                                     shape::Line{c, n},
                                     shape::Plane{c, n},
                                     shape::Circle{c, n, r},
                                     shape::Cylinder{c, n, r},
                                     shape::makeBox(c, Vec3::Constant(r), Mat3::Identity(), {}).value()};
      const control::Law laws[] = {control::P{gain(4.0)}, control::PD{gain(3.0), gain(1.0)},
                                   control::PID{gain(3.0), gain(1.0), gain(5.0), 0.5}};
      const shape::Shape& shape = shapes[random.below(7)];
      entries.push_back(hold(shape, laws[random.below(3)],
                             shape::hasSides(shape) ? static_cast<target::Side>(random.below(3)) : target::Side::Both));
    }
    Hand hand(makeProgram(test::thesisGeometry(), entries, random.below(2) == 0 ? Combine::Sum : Combine::Nearest,
                          test::kTestLimits));
    for (int tick = 0; tick < 100; ++tick) {
      const auto angle = [&] {
        return random.below(50) == 0 ? std::pow(10.0, random.between(-300.0, 300.0)) : random.between(-3.2, 3.2);
      };
      hand.input.engage = random.below(10) != 0;
      hand.input.restart = random.below(30) == 0;
      hand.input.has_sample = random.below(20) != 0;
      const TickReport& report =
          hand.feed({angle(), angle(), angle(), angle(), angle(), angle()}, std::pow(10.0, random.between(-6.0, 0.0)));
      ASSERT_TRUE(report.p_WT.allFinite() && report.f_T_W.allFinite() && report.force.f_T_W().allFinite()) << draw;
      ASSERT_NE(report.fault.kind, FaultKind::NotFinite) << draw;
      ASSERT_LE(report.force.f_T_W().norm(), 0.88 * (1 + 4 * 0x1p-52));
      if (report.fault.kind != FaultKind::None) {
        ASSERT_EQ(report.force.f_T_W(), Vec3(Vec3::Zero()));
      }
      for (const ConstraintReport& held : report.held)
        ASSERT_TRUE(held.p_WP.allFinite() && std::isfinite(held.distance_m));
    }
  }
}

TEST(Determinism, FiniteInFiniteOutWithRobotsToo) {
  Random random(test::Seed{20071102});
  const std::vector<manipulator::Manipulator> robots = test::everyRobot();
  for (int draw = 0; draw < test::sweep(100, 5000); ++draw) {
    const control::Law law = test::everyLaw()[random.below(6)];
    Hand hand({test::holdTo(robots[random.below(robots.size())], law),
               test::holdTo(robots[random.below(robots.size())], law)},
              random.below(2) == 0 ? Combine::Sum : Combine::Nearest);
    for (int tick = 0; tick < 60; ++tick) {
      const auto angle = [&] {
        return random.below(50) == 0 ? std::pow(10.0, random.between(-300.0, 300.0)) : random.between(-3.2, 3.2);
      };
      hand.input.restart = random.below(30) == 0;
      hand.input.has_sample = random.below(20) != 0;
      const TickReport& report =
          hand.feed({angle(), angle(), angle(), angle(), angle(), angle()}, std::pow(10.0, random.between(-6.0, 0.0)));
      ASSERT_TRUE(report.p_WT.allFinite() && report.f_T_W.allFinite() && report.force.f_T_W().allFinite()) << draw;
      for (const ConstraintReport& held : report.held) {
        ASSERT_TRUE(held.p_WP.allFinite() && held.robot.moment_W.allFinite() && std::isfinite(held.robot.energy_J));
        for (const double value : held.robot.theta) ASSERT_TRUE(std::isfinite(value)) << draw;
      }
    }
  }
}

}  // namespace
}  // namespace underact::tick
