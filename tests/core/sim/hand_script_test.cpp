#include "core/sim/hand_script.h"

#include <cmath>
#include <string>

#include "core/arm/inverse.h"
#include "core/base/units.h"
#include "tests/support/property.h"

namespace underact::sim {
namespace {

constexpr std::int64_t kSecond_ns = 1'000'000'000;
constexpr std::int64_t kMillisecond_ns = 1'000'000;

std::int64_t nsOf(double t_s) {
  return std::llround(1e9 * t_s);
}

HandScript builtIn(const std::string& name, std::uint64_t seed = 1) {
  return builtInHand(name, seed).value();
}

std::vector<HandScript> everyBuiltIn() {
  std::vector<HandScript> scripts;
  for (const BuiltInHand& hand : builtInHands()) scripts.push_back(builtIn(hand.name));
  return scripts;
}

HandScript twoPoints() {  // 40 mm along x, from 1 s to 3 s
  HandScript script;
  script.path = {{1.0, Vec3(0.01, 0.0, 0.02)}, {3.0, Vec3(0.05, 0.0, 0.02)}};
  return script;
}

/// Where the path can have a corner in its third derivative: the points.
bool isNearAPoint(const HandScript& script, std::int64_t time_ns, std::int64_t by_ns) {
  const std::int64_t repeat_ns = nsOf(script.repeat_s);
  const std::int64_t path_ns = repeat_ns > 0 ? time_ns % repeat_ns : time_ns;
  for (const HandPoint& point : script.path) {
    if (std::abs(nsOf(point.t_s) - path_ns) <= by_ns) return true;
  }
  return false;
}

TEST(HandScript, GoesHalfTheWayInHalfTheTimeAtItsFastest) {
  const HandSetpoint setpoint = setpointAt(twoPoints(), 2 * kSecond_ns);
  EXPECT_EQ(setpoint.p_WT, Vec3(0.03, 0.0, 0.02));
  EXPECT_NEAR(setpoint.v_WT.x(), 1.875 * 0.04 / 2.0, 1e-17);  // 15/8 of the mean; 2 ulp of 0.0375
  EXPECT_EQ(setpointAt(twoPoints(), 1 * kSecond_ns + kSecond_ns / 2).p_WT.y(), 0.0);
  // s = 1/4: 10/64 - 15/256 + 6/1024 = 53/512.
  EXPECT_NEAR(setpointAt(twoPoints(), 1'500'000'000).p_WT.x(), 0.01 + 0.04 * 53.0 / 512.0, 1e-17);  // 2 ulp of 0.014
}

TEST(HandScript, WaitsBeforeTheFirstPointAndHoldsTheLast) {
  for (const std::int64_t time_ns : {std::int64_t{-5}, std::int64_t{0}, kSecond_ns - 1}) {
    EXPECT_EQ(setpointAt(twoPoints(), time_ns).p_WT, Vec3(0.01, 0.0, 0.02));
    EXPECT_EQ(setpointAt(twoPoints(), time_ns).v_WT, Vec3::Zero());
  }
  for (const std::int64_t time_ns : {3 * kSecond_ns, 3000 * kSecond_ns}) {
    EXPECT_EQ(setpointAt(twoPoints(), time_ns).p_WT, Vec3(0.05, 0.0, 0.02));
    EXPECT_EQ(setpointAt(twoPoints(), time_ns).v_WT, Vec3::Zero());
  }
  EXPECT_EQ(setpointAt(HandScript{}, 0).p_WT, Vec3::Zero());  // no path: no place to be, but no harm either
}

TEST(HandScript, MeetsEveryPointExactlyAndAtRest) {
  for (HandScript script : everyBuiltIn()) {
    script.tremor_m = 0.0;
    for (const HandPoint& point : script.path) {
      const HandSetpoint setpoint = setpointAt(script, nsOf(point.t_s));
      if (script.repeat_s > 0.0 && point.t_s >= script.repeat_s) continue;  // that is the first point again
      EXPECT_EQ(setpoint.p_WT, point.p_WT) << point.t_s;
      EXPECT_EQ(setpoint.v_WT, Vec3::Zero()) << point.t_s;
    }
  }
}

TEST(HandScript, ItsVelocityIsTheRateOfItsPosition) {
  constexpr std::int64_t kStep_ns = 1000;
  for (const HandScript& script : everyBuiltIn()) {
    for (std::int64_t time_ns = kMillisecond_ns / 3; time_ns < 20 * kSecond_ns; time_ns += 7 * kMillisecond_ns) {
      if (isNearAPoint(script, time_ns, kStep_ns)) continue;
      const Vec3 before = setpointAt(script, time_ns - kStep_ns).p_WT,
                 after = setpointAt(script, time_ns + kStep_ns).p_WT;
      const Vec3 rate = (after - before) / 2e-6;
      // Central difference: h^2 / 6 of the largest jerk (stab: 60 * 0.06 m / (0.1125 s)^3 = 2528 m/s^3) is 4.2e-10 m/s;
      // a position's rounding, 4 ulp of 0.08 m, over 2 us is 2.8e-11 m/s.
      ASSERT_LE((rate - setpointAt(script, time_ns).v_WT).cwiseAbs().maxCoeff(), 5e-10) << time_ns;
    }
  }
}

TEST(HandScript, NeverJumpsNotEvenWhereItStartsAgain) {
  for (const HandScript& script : everyBuiltIn()) {
    const std::int64_t end_ns = 2 * std::max(nsOf(script.repeat_s), nsOf(script.path.back().t_s)) + kSecond_ns;
    HandSetpoint last = setpointAt(script, 0);
    for (std::int64_t time_ns = kMillisecond_ns; time_ns <= end_ns; time_ns += kMillisecond_ns) {
      const HandSetpoint setpoint = setpointAt(script, time_ns);
      // A millisecond at 1 m/s (stab), and its acceleration: 5.77 * 0.06 m / (0.1125 s)^2 = 27.4 m/s^2.
      ASSERT_LE((setpoint.p_WT - last.p_WT).norm(), 1.01e-3) << time_ns;
      ASSERT_LE((setpoint.v_WT - last.v_WT).norm(), 0.0280) << time_ns;
      last = setpoint;
    }
  }
}

TEST(HandScript, StartsAgainWhenItIsToRepeat) {
  HandScript script = twoPoints();
  script.repeat_s = 4.0;
  for (const std::int64_t time_ns : {std::int64_t{0}, 2 * kSecond_ns, 3 * kSecond_ns + 1}) {
    EXPECT_EQ(setpointAt(script, 3 * 4 * kSecond_ns + time_ns).p_WT, setpointAt(script, time_ns).p_WT);
  }
}

TEST(HandScript, BuiltInIsAroundTheRestOfAnArmOfAnotherFormAndAFileIsNot) {
  const arm::Preset& arm = *arm::findPreset("ur5e");
  const HandScript script = builtIn("still");
  const Vec3 p_WRest = restingState(makePlant(arm, {}, {})).p_WT;
  const HandScript moved = madeFor(arm, script);
  EXPECT_EQ(moved.path[1].p_WT, Vec3(script.path[1].p_WT + p_WRest));
  EXPECT_EQ(madeFor(arm, moved).path[1].p_WT, moved.path[1].p_WT) << "twice is once";
  EXPECT_EQ(madeFor(*arm::findPreset("touch-measured"), script).path[1].p_WT, script.path[1].p_WT);
  HandScript own = script;
  own.about_middle = false;
  EXPECT_EQ(madeFor(arm, own).path[1].p_WT, script.path[1].p_WT);
}

TEST(HandScript, EveryBuiltInHandStaysInReachAndLimitsOfEveryArm) {
  for (const BuiltInHand& hand : builtInHands()) {
    const HandScript script = builtIn(hand.name);
    for (const arm::Preset& preset : arm::presets()) {
      for (std::int64_t time_ns = 0; time_ns < 40 * kSecond_ns; time_ns += kMillisecond_ns) {
        const arm::PositionSolution reach = arm::solvePosition(preset.geometry, setpointAt(script, time_ns).p_WT);
        arm::JointAngles q_rad = reach.q_rad;
        q_rad[4] = 1.0;  // joints 4 to 6 are not the script's
        ASSERT_TRUE(reach.reachable) << hand.name << " at " << time_ns;
        ASSERT_EQ(arm::withinLimits(preset.limits, q_rad), q_rad)
            << hand.name << ", " << preset.name << " at " << time_ns;
      }
    }
  }
}

TEST(HandScript, BuiltInHandsDoWhatTheySay) {
  EXPECT_EQ(builtInHands().size(), 5U);
  EXPECT_EQ(setpointAt(builtIn("still"), 0).p_WT, Vec3(0.0, 0.0, 0.06));
  EXPECT_LE((setpointAt(builtIn("still"), kSecond_ns).p_WT - Vec3(0.035, 0.025, 0.020)).norm(), 1e-17);
  double sweep_nearest_m = 1.0, probe_nearest_m = 1.0, stab_fastest = 0.0, stab_nearest_m = 1.0, stab_furthest_m = 0.0;
  for (std::int64_t time_ns = 0; time_ns < 20 * kSecond_ns; time_ns += kMillisecond_ns / 4) {
    sweep_nearest_m = std::min(sweep_nearest_m, setpointAt(builtIn("sweep"), time_ns).p_WT.norm());
    probe_nearest_m = std::min(probe_nearest_m, setpointAt(builtIn("probe"), time_ns).p_WT.norm());
    const HandSetpoint stab = setpointAt(builtIn("stab"), time_ns);
    stab_fastest = std::max(stab_fastest, stab.v_WT.norm());
    stab_nearest_m = std::min(stab_nearest_m, stab.p_WT.norm());
    stab_furthest_m = std::max(stab_furthest_m, stab.p_WT.norm());
  }
  EXPECT_LT(sweep_nearest_m, 0.010);
  EXPECT_GT(sweep_nearest_m, 0.001);
  EXPECT_NEAR(probe_nearest_m, 0.012, 1e-12);  // met at a point, so exactly
  EXPECT_NEAR(stab_fastest, 1.0, 1e-12);       // met at mid-way of a leg, on the grid of 0.25 ms
  EXPECT_NEAR(stab_nearest_m, 0.020, 1e-12);
  EXPECT_NEAR(stab_furthest_m, 0.080, 1e-12);
}

TEST(HandScript, TremorIsThreeSinusoidsWithinItsAmplitude) {
  const HandScript script = builtIn("tremor");
  HandScript calm = script;
  calm.tremor_m = 0.0;
  Vec3 sum_squares = Vec3::Zero(), sum = Vec3::Zero();
  const std::int64_t start_ns = 7 * kSecond_ns;
  for (int step = 0; step < 2000; ++step) {  // 2 s: a whole number of periods of each
    const std::int64_t time_ns = start_ns + step * kMillisecond_ns;
    const Vec3 tremor = setpointAt(script, time_ns).p_WT - setpointAt(calm, time_ns).p_WT;
    ASSERT_LE(tremor.cwiseAbs().maxCoeff(), 0.5e-3);
    sum += tremor;
    sum_squares += tremor.cwiseAbs2();
  }
  // Of sampled sinusoids of different whole frequencies the means are exact: 0, and half of each amplitude's square.
  const double mean_square = 3.0 * 0.5 * (0.5e-3 / 3.0) * (0.5e-3 / 3.0);
  for (int axis = 0; axis < 3; ++axis) {
    EXPECT_NEAR(sum[axis] / 2000.0, 0.0, 1e-17);  // rounding of 0.035 m, each of 2000 differently
    EXPECT_NEAR(sum_squares[axis] / 2000.0, mean_square, 1e-12 * 0.5e-3);
  }
}

TEST(HandScript, TheSeedDecidesTheTremorAndNothingElseDoes) {
  const std::int64_t time_ns = 1234 * kMillisecond_ns;
  EXPECT_EQ(setpointAt(builtIn("tremor", 7), time_ns).p_WT, setpointAt(builtIn("tremor", 7), time_ns).p_WT);
  EXPECT_NE(setpointAt(builtIn("tremor", 7), time_ns).p_WT, setpointAt(builtIn("tremor", 8), time_ns).p_WT);
  EXPECT_EQ(setpointAt(builtIn("probe", 7), time_ns).p_WT, setpointAt(builtIn("probe", 8), time_ns).p_WT);
  // After an hour as after none: the tremor's time is taken modulo its period.
  EXPECT_EQ(setpointAt(builtIn("tremor"), 3600 * kSecond_ns + time_ns).p_WT,
            setpointAt(builtIn("tremor"), 3602 * kSecond_ns + time_ns).p_WT);
}

TEST(HandScript, TurnsAboutOneAxisByTheSameProfile) {
  HandScript script = twoPoints();
  const Vec3 axis = Vec3(2.0, -1.0, 2.0) / 3.0;
  const Mat3 start = Eigen::AngleAxisd(0.4, Vec3::UnitY()).toRotationMatrix();
  for (const double angle_rad : {1e-9, 0.5, 1.5, 3.0, -3.0}) {
    script.path[0].R_WT = start;
    script.path[1].R_WT = start * Eigen::AngleAxisd(angle_rad, axis).toRotationMatrix();
    script.path[0].turns = script.path[1].turns = true;
    for (int step = 0; step <= 20; ++step) {
      const double s = step / 20.0, share = s * s * s * (10.0 - 15.0 * s + 6.0 * s * s);
      const HandSetpoint setpoint = setpointAt(script, kSecond_ns + step * (kSecond_ns / 10));
      const Mat3 expected = start * Eigen::AngleAxisd(share * angle_rad, axis).toRotationMatrix();
      ASSERT_TRUE(setpoint.turns);
      // Two rotations of three products an entry, a quaternion and an angle up to 3: some 30 roundings of 1.1e-16.
      ASSERT_LE((setpoint.R_WT - expected).cwiseAbs().maxCoeff(), 4e-15) << angle_rad << " at " << s;
    }
  }
  EXPECT_EQ(setpointAt(script, 0).R_WT, start);
  script.path[1].R_WT = start;  // no turn at all
  EXPECT_EQ(setpointAt(script, 2 * kSecond_ns).R_WT, start);
  script.path[1].turns = false;
  EXPECT_FALSE(setpointAt(script, 2 * kSecond_ns).turns);
}

TEST(HandScript, GivesTheSameBitsOnEveryMachine) {  // recorded with GCC 12 and found again with Clang 14
  const HandSetpoint setpoint = setpointAt(builtIn("tremor", 42), 730'000'000);
  EXPECT_EQ(setpoint.p_WT, Vec3(0x1.f8166a12fa088p-6, 0x1.6683a64c8fa99p-6, 0x1.9a53554c51a69p-6));
  EXPECT_EQ(setpoint.v_WT, Vec3(0x1.33cfa7281c977p-5, 0x1.a64f9a4255e34p-5, -0x1.85c026d2d78c3p-5));
}

TEST(HandScript, AnUnknownNameIsAnsweredWithTheNamesThereAre) {
  const Result<HandScript> none = builtInHand("stil", 0);
  ASSERT_FALSE(none);
  EXPECT_EQ(none.problems().front().sentence, "There is no hand \"stil\". Hands: still, sweep, probe, tremor, stab.");
}

}  // namespace
}  // namespace underact::sim
