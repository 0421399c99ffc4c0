#include "device/wooden_haptics/kinematics.h"

#include <gtest/gtest.h>

#include <cmath>

#include "core/arm/forward.h"
#include "core/arm/inverse.h"
#include "core/base/units.h"
#include "tests/support/property.h"
#include "tests/support/wooden_firmware.h"

namespace underact::device {
namespace {

using Counts = std::array<int, 3>;

/// The source's formulas as the facts have them, in its own frame and then in W; nothing of core/arm.
struct Source {
  const WoodenModel& model;
  const WoodenWiring& wiring;
  double angle(std::size_t body, double count) const {
    return wiring.angle_rad[body] + wiring.count_sign[body] * 2.0 * kPi * count / model.counts_per_turn[body] *
                                        model.capstan_m[body] / model.body_m[body];
  }
  Vec3 tip_W(const std::array<double, 3>& counts) const {
    const double a = angle(0, counts[0]), b = angle(1, counts[1]), c = angle(2, counts[2]);
    const auto& [Ln, Lb, Lc] = model.length_m;
    const double x = std::cos(a) * (Lb * std::sin(b) + Lc * std::sin(c)) - model.origin_m[0];
    const double y = std::sin(a) * (Lb * std::sin(b) + Lc * std::sin(c)) - model.origin_m[1];
    const double z = Ln + Lb * std::cos(b) - Lc * std::cos(c) - model.origin_m[2];
    return {y, z, x};
  }
};

Counts somewhere(test::Random& random, const WoodenWiring& wiring) {
  Counts counts{};
  for (std::size_t body = 0; body < 3; ++body)
    counts[body] =
        static_cast<int>(random.between(-4000.0, 4000.0)) + (wiring.home_counts[2] != 0 && body == 2 ? 4000 : 0);
  return counts;
}

std::array<double, 3> wide(const Counts& counts) {
  return {static_cast<double>(counts[0]), static_cast<double>(counts[1]), static_cast<double>(counts[2])};
}

template <class Check>
void forEachArm(const Check& check) {
  for (const WoodenModel& model : woodenModels()) {
    for (const WoodenProtocol protocol : {WoodenProtocol::V1, WoodenProtocol::V2}) check(model, woodenWiring(protocol));
  }
}

}  // namespace

TEST(WoodenJoints, PutTheTipWhereTheSourcesFormulaDoes) {
  forEachArm([](const WoodenModel& model, const WoodenWiring& wiring) {
    test::Random random(test::Seed{2015});
    const Source source{model, wiring};
    for (int round = 0; round < 1000; ++round) {
      const Counts counts = somewhere(random, wiring);
      const Vec3 p_WT = arm::tipPosition(woodenGeometry(model), woodenJoints(model, wiring, counts));
      // Lengths of half a metre and angles of a few radians: 64 ulp of 1.
      ASSERT_LE((p_WT - source.tip_W(wide(counts))).norm(), 64 * 2.2e-16) << model.key;
    }
  });
}

TEST(WoodenJoints, InTheHomePostureUpperArmIsUprightAndForearmLevel) {
  const WoodenModel& model = *findWoodenModel("woody");
  const Vec3 home_W(0.0, 0.080 + 0.205 - 0.080, 0.245 - 0.220);
  const WoodenWiring& v1 = woodenWiring(WoodenProtocol::V1);
  EXPECT_LE((arm::tipPosition(woodenGeometry(model), woodenJoints(model, v1, {0, 0, 0})) - home_W).norm(), 1e-15);
  const WoodenWiring& v2 = woodenWiring(WoodenProtocol::V2);
  const Counts told{v2.home_counts[0], v2.home_counts[1], v2.home_counts[2]};
  EXPECT_LE((arm::tipPosition(woodenGeometry(model), woodenJoints(model, v2, told)) - home_W).norm(), 1e-15);
  EXPECT_TRUE(isWoodenPosture(woodenJoints(model, v1, {0, 0, 0})));
  EXPECT_TRUE(isWoodenPosture(woodenJoints(model, v2, told)));
  EXPECT_FALSE(isWoodenPosture(woodenJoints(model, v2, {0, 0, 0}))) << "a board that was not calibrated";
}

TEST(WoodenGeometry, IsThatOfThePreset) {
  const arm::Preset& preset = *arm::findPreset("woodenhaptics");
  for (const char* key : {"woody", "woody-2019"}) {
    const WoodenModel& model = *findWoodenModel(key);
    const arm::Geometry geometry = woodenGeometry(model);
    EXPECT_DOUBLE_EQ(geometry.upper_m, preset.geometry.upper_m);
    EXPECT_DOUBLE_EQ(geometry.fore_m, preset.geometry.fore_m);
    EXPECT_LE((geometry.p_WB - preset.geometry.p_WB).norm(), 1e-16);
    for (std::size_t body = 0; body < 3; ++body)
      EXPECT_DOUBLE_EQ(preset.counts_per_turn[body],
                       model.counts_per_turn[body] * model.body_m[body] / model.capstan_m[body]);
  }
}

TEST(WoodenGeometry, EveryPlaceOfTheWorkspaceIsAPosture) {  // a ball of 0.1 m, as the source says
  const arm::Geometry geometry = woodenGeometry(*findWoodenModel("woody"));
  for (const Vec3& p_WT : test::pointsInBox(0.057, 1000, test::Seed{100})) {
    const arm::PositionSolution reach = arm::solvePosition(geometry, p_WT);
    ASSERT_TRUE(reach.reachable);
    ASSERT_TRUE(isWoodenPosture(reach.q_rad)) << p_WT.transpose();
  }
}

TEST(WoodenCurrents, DoTheWorkAtTheMotorsThatTheForceDoesAtTheTip) {
  forEachArm([](const WoodenModel& model, const WoodenWiring& wiring) {
    test::Random random(test::Seed{77});
    const Source source{model, wiring};
    for (int round = 0; round < 1000; ++round) {
      const Counts counts = somewhere(random, wiring);
      const Vec3 f_T_W = random.between(0.1, 1.0) * random.direction();
      const Currents_mA mA = woodenCurrents(model, wiring, woodenJoints(model, wiring, counts), f_T_W);
      // A small motion of one motor after the other, in counts; the tip's by differences of the source's formula.
      for (std::size_t motor = 0; motor < 3; ++motor) {
        std::array<double, 3> before = wide(counts), after = before;
        before[motor] -= 0.5, after[motor] += 0.5;
        const double at_tip_J = f_T_W.dot(source.tip_W(after) - source.tip_W(before));
        const double turned_rad = 2.0 * kPi / model.counts_per_turn[motor];
        const double torque_N_m = 1e-3 * mA[motor] * model.torque_N_m_per_A[motor];
        // A current turns its motor the way that the body's angle rises, times current_sign.
        const double at_motor_J = torque_N_m * turned_rad * wiring.current_sign[motor] * wiring.count_sign[motor];
        // To the nearest mA; the difference's error is the third derivative, L (1 count)^3 / 24 < 1e-12 m.
        const double step_J = 0.5e-3 * model.torque_N_m_per_A[motor] * turned_rad;
        ASSERT_NEAR(at_motor_J, at_tip_J, step_J + 1e-12) << model.key << " motor " << motor;
      }
    }
  });
}

TEST(WoodenCurrents, BeyondTheCapAllAreMadeSmallerAlike) {
  const WoodenModel& model = *findWoodenModel("woody");
  const WoodenWiring& wiring = woodenWiring(WoodenProtocol::V1);
  test::Random random(test::Seed{2000});
  for (int round = 0; round < 1000; ++round) {
    const arm::JointAngles q_rad = arm::solvePosition(woodenGeometry(model), random.inBox(0.05)).q_rad;
    const Vec3 one_N = random.direction();
    const Currents_mA small = woodenCurrents(model, wiring, q_rad, one_N);
    const Currents_mA capped = woodenCurrents(model, wiring, q_rad, 50.0 * one_N);
    const double largest = std::max({std::abs(small[0]), std::abs(small[1]), std::abs(small[2])});
    double max = 0.0;
    for (std::size_t motor = 0; motor < 3; ++motor) {
      max = std::max(max, static_cast<double>(std::abs(capped[motor])));
      // Both are rounded to half a mA, the small ones before they are scaled up.
      ASSERT_NEAR(capped[motor], small[motor] * kMaxCurrent_mA / largest, 0.5 + kMaxCurrent_mA / largest);
    }
    ASSERT_EQ(max, kMaxCurrent_mA);
  }
}

TEST(WoodenCurrents, AreZeroForAForceThatIsNoNumber) {
  const WoodenModel& model = *findWoodenModel("woody");
  const arm::JointAngles q_rad = arm::solvePosition(woodenGeometry(model), Vec3::Zero()).q_rad;
  for (const double bad : {kNotANumber, kInfinity, 1e308}) {
    EXPECT_EQ(woodenCurrents(model, woodenWiring(WoodenProtocol::V2), q_rad, Vec3(bad, 0.1, 0.1)), Currents_mA{})
        << bad;
  }
}

TEST(WoodenModels, TheOneThatIsGuessedPushesNoHarderThanAnother) {
  for (const WoodenProtocol protocol : {WoodenProtocol::V1, WoodenProtocol::V2}) {
    const WoodenModel& guessed = defaultWoodenModel(protocol);
    EXPECT_TRUE(guessed.is_open);
    if (protocol == WoodenProtocol::V1) continue;  // all arms of that time are alike
    for (const WoodenModel& model : woodenModels()) {
      for (std::size_t motor = 0; motor < 3; ++motor)
        EXPECT_GE(guessed.torque_N_m_per_A[motor], model.torque_N_m_per_A[motor]) << model.key;
    }
  }
}

}  // namespace underact::device
