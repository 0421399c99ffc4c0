#include <algorithm>
#include <cmath>

#include "core/sim/hand_script.h"
#include "core/sim/plant.h"
#include "core/tick/step.h"
#include "tests/support/sampled_wall.h"
#include "tests/support/tick_hand.h"

namespace underact::sim {
namespace {

using control::Passivity;

constexpr std::int64_t kPeriod_ns = 1'000'000;
constexpr double kPeriod_s = 1e-3;
constexpr int kTicks = 20'000;
constexpr int kBegin = 400;  // the ramp takes 300
constexpr double kRadius_m = 0.04;

/// What a run in a hand came to.
struct Course {
  double excess_J =
      0.0;  // that the arm gave beyond what it had got and what its spring held at first, at the worst moment
  double halfway_J = 0.0;    // the same of the first half
  double rms_m_per_s = 0.0;  // speed beside the one that the hand wants, over the last second
};

/// What a spring to the sphere that is clamped to max_N holds with the tip in p_WT.
double storedAt(const Vec3& p_WT, double stiffness_N_per_m, double max_N, target::Side side) {
  const double off_m = p_WT.norm() - kRadius_m;
  if (side == target::Side::Outside && off_m > 0.0) return 0.0;
  const double clamped_m = std::min(std::abs(off_m), max_N / stiffness_N_per_m);
  return 0.5 * stiffness_N_per_m * clamped_m * clamped_m + max_N * (std::abs(off_m) - clamped_m);
}

/// 20 s of a hand at a sphere, through the real tick with the real limits. Energy by the true places of the tip, with
/// which no line of the observer is shared, counted from when the ramp is complete.
Course run(const char* hand_name, const ArmModel& model, double stiffness_N_per_m, Passivity passivity,
           target::Side side) {
  const HandScript script = builtInHand(hand_name, 7).value();
  const Plant plant{*arm::findPreset("omni-thesis"), model, script.hand};
  const double max_N = plant.arm.continuous_force_N;
  tick::Entry entry = test::hold(shape::makeSphere(Vec3::Zero(), kRadius_m, {}).value(),
                                 control::P{Vec3::Constant(stiffness_N_per_m)}, side);
  entry.passivity = passivity;
  test::Hand hand(makeProgram(plant.arm.geometry, {entry}, tick::Combine::Sum,
                              safety::limitsForHands(max_N, Vec3::Zero()), plant.arm.limits));
  PlantState state = restingState(plant, setpointAt(script, 0).p_WT);
  Vec3 f_T_W = Vec3::Zero();
  Course course;
  double given_J = 0.0, begin_J = 0.0, sum = 0.0;
  for (int tick = 1; tick <= kTicks; ++tick) {
    const Vec3 before_WT = state.p_WT;
    const HandSetpoint setpoint = setpointAt(script, tick * kPeriod_ns);
    state = advance(plant, state, f_T_W, setpoint, kPeriod_ns);
    const double stored_J = storedAt(state.p_WT, stiffness_N_per_m, max_N, side);
    if (tick == kBegin) begin_J = stored_J;
    if (tick > kBegin) {
      given_J += f_T_W.dot(state.p_WT - before_WT);
      course.excess_J = std::max(course.excess_J, given_J + stored_J - begin_J);
    }
    if (tick == kTicks / 2) course.halfway_J = course.excess_J;
    if (tick > kTicks - 1000) sum += (state.v_WT - setpoint.v_WT).squaredNorm() / 1000.0;
    const arm::JointAngles shown_rad = plant.model.encoders ? quantized(plant.arm, state.q_rad) : state.q_rad;
    f_T_W = hand.feed(shown_rad, kPeriod_s).force.f_T_W();
  }
  course.rms_m_per_s = std::sqrt(sum);
  return course;
}

/// Ten times the greatest stiffness at which this hand calms a sampled wall without friction.
double tenfold(const ArmModel& model) {
  const HandModel hand;
  return 10.0 * test::exactLimit(
                    {hand.mass_kg + model.mass_kg, hand.damping_N_s_per_m, hand.stiffness_N_per_m, 0.0, kPeriod_s, 0});
}

// Bounded: whatever the hand does, in 20 s it gets no more than 2 mJ that it did not put in (0.88 N over 2.3 mm). What
// is left comes of strokes at 1 m/s, where two ticks are 2 mm.
constexpr double kBounded_J = 2e-3;

TEST(PassiveWall, TenTimesBeyondTheLimitItStaysBoundedInEveryHand) {
  for (const ArmModel& model : armModels()) {
    const double stiffness_N_per_m = tenfold(model);
    for (const target::Side side : {target::Side::Both, target::Side::Outside}) {
      for (const BuiltInHand& hand : builtInHands()) {
        const Course course = run(hand.name, model, stiffness_N_per_m, Passivity::Control, side);
        EXPECT_LT(course.excess_J, kBounded_J) << model.name << ", " << hand.name;
        EXPECT_LT(course.excess_J, course.halfway_J + 0.5e-3) << "it grows: " << model.name << ", " << hand.name;
      }
    }
  }
}

TEST(PassiveWall, WithoutTheControllerItDoesNot) {
  for (const ArmModel& model : armModels()) {
    const double stiffness_N_per_m = tenfold(model);
    for (const char* const hand : {"sweep", "probe", "stab"}) {
      const Course course = run(hand, model, stiffness_N_per_m, Passivity::Observe, target::Side::Both);
      EXPECT_GT(course.excess_J, 2.0 * kBounded_J) << model.name << ", " << hand;
      EXPECT_GT(course.excess_J, 1.5 * course.halfway_J) << "and it goes on growing: " << model.name << ", " << hand;
    }
  }
}

TEST(PassiveWall, TheControllerTakesTheBuzzOutOfASlowHand) {
  for (const ArmModel& model : armModels()) {
    const double stiffness_N_per_m = tenfold(model);
    const Course buzzing = run("sweep", model, stiffness_N_per_m, Passivity::Observe, target::Side::Both);
    const Course held = run("sweep", model, stiffness_N_per_m, Passivity::Control, target::Side::Both);
    EXPECT_LT(held.rms_m_per_s, 0.75 * buzzing.rms_m_per_s) << model.name;
  }
}

TEST(PassiveWall, ToObserveChangesNoBitOfTheForce) {
  const ArmModel& model = *findArmModel(kDefaultArmModel);
  const Course off = run("probe", model, 2000.0, Passivity::Off, target::Side::Both);
  const Course observed = run("probe", model, 2000.0, Passivity::Observe, target::Side::Both);
  EXPECT_EQ(off.excess_J, observed.excess_J);
  EXPECT_EQ(off.rms_m_per_s, observed.rms_m_per_s);
}

}  // namespace
}  // namespace underact::sim
