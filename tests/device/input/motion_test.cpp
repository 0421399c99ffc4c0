#include "device/input/motion.h"

#include <cmath>

#include "core/base/units.h"
#include "device/input/default_maps.h"
#include "tests/support/property.h"

namespace underact::device::input {
namespace {

Readings axes(std::initializer_list<double> values) {
  Readings readings;
  for (const double value : values) readings.axis[static_cast<std::size_t>(readings.axes++)] = value;
  readings.buttons = kMaxButtons;
  return readings;
}

Readings pressed(std::initializer_list<int> buttons) {
  Readings readings = axes({0, 0, 0, 0, -1, -1});
  for (const int button : buttons) readings.pressed |= std::uint64_t{1} << static_cast<unsigned>(button);
  return readings;
}

constexpr ReadyAxes kAwake{{true, true, true, true, true, true}};

DeviceState controller() {
  DeviceState seen;
  describeController(seen);
  return seen;
}

Pose at(const Vec3& p_WT) {
  Pose X_WT = Pose::Identity();
  X_WT.translation() = p_WT;
  return X_WT;
}

}  // namespace

TEST(HandMotion, TheDeadZoneBeginsAtZeroAndEndsAtOne) {
  for (const double exponent : {1.0, 2.0, 3.3}) {
    for (const double zone : {0.0, 0.1, 0.5, 0.9}) {
      EXPECT_EQ(shaped(0.0, zone, exponent), 0.0);
      EXPECT_EQ(shaped(zone, zone, exponent), 0.0);
      EXPECT_EQ(shaped(1.0, zone, exponent), 1.0);
      EXPECT_EQ(shaped(-1.0, zone, exponent), -1.0);
      EXPECT_EQ(shaped(7.0, zone, exponent), 1.0);
      EXPECT_LT(shaped(zone + 1e-9, zone, exponent), 1e-7);  // no jump at the border
    }
  }
  EXPECT_EQ(shaped(kNotANumber, 0.1, 2.0), 0.0);
  EXPECT_NEAR(shaped(0.55, 0.1, 2.0), 0.25, 1e-15);  // by hand: half of what is left, squared
}

TEST(HandMotion, AWayIsOddAndNeverFalls) {
  test::Random random(test::Seed{20071107});
  for (int i = 0; i < test::sweep(2000, 200'000); ++i) {
    const double zone = random.between(0.0, kFurthestDeadZone), exponent = random.between(1.0, kFinest);
    const double a = random.between(-1.2, 1.2), b = random.between(-1.2, 1.2);
    ASSERT_EQ(shaped(-a, zone, exponent), -shaped(a, zone, exponent));
    if (a <= b) {
      ASSERT_LE(shaped(a, zone, exponent), shaped(b, zone, exponent)) << a << " " << b;
    }
    ASSERT_LE(std::abs(shaped(a, zone, exponent)), 1.0);
    // Continuous: over a thousandth of the way never more than its steepest slope.
    ASSERT_LE(std::abs(shaped(a + 1e-3, zone, exponent) - shaped(a, zone, exponent)),
              1.001e-3 * exponent / (1.0 - zone));
  }
}

TEST(HandMotion, IgnoresAbsentAxesAndNaNs) {
  const Readings readings = axes({kNotANumber, kInfinity, 0.5});
  const auto of = [&](SourceKind kind, int plus, int minus) { return deflection({kind, plus, minus}, readings); };
  EXPECT_EQ(of(SourceKind::Axis, 0, -1), 0.0);
  EXPECT_EQ(of(SourceKind::Axis, 1, -1), 0.0);
  EXPECT_EQ(of(SourceKind::Axis, 2, -1), 0.5);
  for (const int axis : {-1, 3, 15, 16, 1 << 30}) EXPECT_EQ(of(SourceKind::Axis, axis, -1), 0.0) << axis;
  for (const int button : {-1, 64, 1 << 30}) EXPECT_EQ(of(SourceKind::Buttons, button, button), 0.0) << button;
  EXPECT_EQ(of(SourceKind::Triggers, 0, 7), 0.0);
  EXPECT_EQ(of(SourceKind::None, 2, 2), 0.0);
}

TEST(HandMotion, TheUsualControllerMovesAsItIsPushed) {  // each stick to its end, by hand
  const DeviceState seen = controller();
  const auto motion = [&](const Readings& readings) { return motionOf(seen.default_value, readings, kAwake); };
  const double top = seen.default_value.motions[0].top;
  EXPECT_TRUE(motion(axes({0, 0, 0, 0, -1, -1})).isAtRest());
  EXPECT_EQ(motion(axes({1, 0, 0, 0, -1, -1})).v_WT, Vec3(top, 0, 0));
  EXPECT_EQ(motion(axes({0, 1, 0, 0, -1, -1})).v_WT, Vec3(0, 0, top));  // the stick drawn: towards the person
  EXPECT_EQ(motion(axes({0, 0, 0, 0, -1, 1})).v_WT, Vec3(0, top, 0));   // right trigger: up
  EXPECT_EQ(motion(axes({0, 0, 0, 0, 1, -1})).v_WT, Vec3(0, -top, 0));
  EXPECT_TRUE(motion(axes({0, 0, 0, 0, 1, 1})).isAtRest());
  EXPECT_GT(motion(axes({0, 0, 1, 0, -1, -1})).w_WT_W.y(), 1.0);
  EXPECT_GT(motion(pressed({4})).w_WT_W.z(), 1.0);
  EXPECT_EQ(motion(pressed({4, 5})).w_WT_W.z(), 0.0);
  EXPECT_EQ(motion(pressed({0, 2})).stylus_buttons, 3U);
  EXPECT_TRUE(motion(pressed({1})).stop);
  EXPECT_FALSE(motion(pressed({7})).stop);  // nothing starts the servo from here
}

TEST(HandMotion, AJoystickMovesByItsHatAndItsThrottleMovesNothing) {
  DeviceState seen;
  seen.readings = axes({0, 0, 0, -1});
  seen.readings.buttons = 16;  // the last four are the hat
  describeJoystick(seen, 1);
  Readings held = seen.readings;
  held.pressed = std::uint64_t{1} << 12U;
  EXPECT_GT(motionOf(seen.default_value, held, kAwake).v_WT.y(), 0.1);
  held.pressed = std::uint64_t{1} << 14U;
  EXPECT_LT(motionOf(seen.default_value, held, kAwake).v_WT.y(), -0.1);
  EXPECT_TRUE(motionOf(seen.default_value, seen.readings, kAwake).isAtRest());
}

TEST(HandMotion, WhatIsHeldFromTheBeginningMovesNothingUntilItWasLetGo) {
  const DeviceState seen = controller();
  const Readings held = axes({1, 0, 0, 0, -1, -1}), rests = axes({0, 0, 0, 0, -1, -1});
  ReadyAxes awake = updatedReadyAxes({}, seen.default_value, held);
  EXPECT_TRUE(motionOf(seen.default_value, held, awake).isAtRest());
  awake = updatedReadyAxes(awake, seen.default_value, rests);
  EXPECT_FALSE(motionOf(seen.default_value, held, awake).isAtRest());
}

TEST(HandMotion, AHandMovesAsFarAsItsSpeedSays) {
  sim::HandSetpoint setpoint;
  setpoint.p_WT = {0.01, 0.02, 0.03};
  Motion motion;
  motion.v_WT = {0.1, -0.05, 0.0};
  const sim::HandSetpoint next = movedSetpoint(setpoint, motion, 0.05, at(setpoint.p_WT));
  EXPECT_LT((next.p_WT - Vec3(0.015, 0.0175, 0.03)).norm(), 1e-15);
  EXPECT_FALSE(next.turns);
  EXPECT_EQ(movedSetpoint(setpoint, {}, 1.0, at(setpoint.p_WT)).p_WT, setpoint.p_WT);
}

TEST(HandMotion, APauseOfTheProgramIsNoLongStep) {
  sim::HandSetpoint setpoint;
  Motion motion;
  motion.v_WT = {0.01, 0.0, 0.0};
  motion.w_WT_W = {0.0, 1.0, 0.0};
  const sim::HandSetpoint next = movedSetpoint(setpoint, motion, 2.0, at(setpoint.p_WT));
  EXPECT_NEAR(next.p_WT.x(), 0.01 * kLongestStep_s, 1e-15);
  EXPECT_LT((next.R_WT - Eigen::AngleAxisd(kLongestStep_s, Vec3::UnitY()).toRotationMatrix()).norm(), 1e-12);
}

TEST(HandMotion, ItGoesNoFurtherBeforeTheTipThanTheLeashAndNeverOutOfReach) {
  test::Random random(test::Seed{20071108});
  for (int i = 0; i < test::sweep(2000, 100'000); ++i) {
    sim::HandSetpoint setpoint;
    setpoint.p_WT = random.inBox(0.08);
    const Vec3 tip = random.inBox(0.08);
    Motion motion;
    motion.v_WT = random.inBox(5.0);
    const sim::HandSetpoint next = movedSetpoint(setpoint, motion, random.between(0.0, 1.0), at(tip));
    ASSERT_LE((next.p_WT - tip).norm(), std::max(kLeash_m, (setpoint.p_WT - tip).norm()) + 1e-12);
    ASSERT_LE(next.p_WT.norm(), kReach_m + 1e-12);
  }
  sim::HandSetpoint setpoint;
  Motion away;
  away.v_WT = {1, 0, 0};
  for (int i = 0; i < 1000; ++i) setpoint = movedSetpoint(setpoint, away, 0.1, at(setpoint.p_WT));
  EXPECT_NEAR(setpoint.p_WT.x(), kReach_m, 1e-12);
}

TEST(HandMotion, ManyTurnsStayARotationAndBeginWhereTheStylusIs) {
  const Pose X_WT = Pose(Eigen::AngleAxisd(0.5, Vec3::UnitY()));
  sim::HandSetpoint setpoint;
  Motion motion;
  motion.w_WT_W = {0, 1.0, 0};
  setpoint = movedSetpoint(setpoint, motion, 0.25, X_WT);
  EXPECT_TRUE(setpoint.turns);
  EXPECT_LT((setpoint.R_WT - Eigen::AngleAxisd(0.75, Vec3::UnitY()).toRotationMatrix()).norm(), 1e-12);
  motion.w_WT_W = {0.3, -0.7, 1.1};
  for (int i = 0; i < 100'000; ++i) setpoint = movedSetpoint(setpoint, motion, 0.01, X_WT);
  EXPECT_LT((setpoint.R_WT * setpoint.R_WT.transpose() - Mat3::Identity()).norm(), 1e-12);
}

TEST(HandMotion, IgnoresReadingsThatAreNotFinite) {
  sim::HandSetpoint setpoint;
  Motion motion;
  motion.v_WT = {0.1, 0, 0};
  EXPECT_EQ(movedSetpoint(setpoint, motion, kNotANumber, at({0, 0, 0})).p_WT, setpoint.p_WT);
  EXPECT_EQ(movedSetpoint(setpoint, motion, -1.0, at({0, 0, 0})).p_WT, setpoint.p_WT);
  EXPECT_EQ(movedSetpoint(setpoint, motion, 0.1, at({0, kNotANumber, 0})).p_WT, setpoint.p_WT);
  motion.v_WT.x() = kInfinity;
  EXPECT_EQ(movedSetpoint(setpoint, motion, 0.1, at({0, 0, 0})).p_WT, setpoint.p_WT);
}

}  // namespace underact::device::input
