#include <cmath>
#include <set>

#include "core/arm/mechanism.h"
#include "core/base/units.h"
#include "tests/core/lesson/lesson_support.h"
#include "tests/support/property.h"
#include "tests/support/random.h"

namespace underact::lesson {
namespace {

using test::Moment;

double numberOf(const char* key, const Moment& moment, std::size_t part = 1) {
  const Quantity* const quantity = findQuantity(key);
  EXPECT_NE(quantity, nullptr) << key;
  return quantity->of(moment.seen())[part - 1];
}

TEST(Quantities, EachHasAKeyOfItsOwnASentenceAndAsManyNumbersAsItSays) {
  std::set<std::string> keys;
  Moment moment;
  for (const Quantity& quantity : quantities()) {
    EXPECT_TRUE(keys.insert(quantity.key).second) << quantity.key;
    EXPECT_EQ(std::string(quantity.what).back(), '.') << quantity.key;
    EXPECT_EQ(findQuantity(quantity.key), &quantity);
    ASSERT_LE(quantity.parts, kMaxParts) << quantity.key;
    const Values values = quantity.of(moment.seen());
    for (std::size_t part = quantity.parts; part < kMaxParts; ++part) EXPECT_TRUE(std::isnan(values[part]));
  }
  EXPECT_EQ(findQuantity("force"), nullptr);
}

// By the numbers that underact-cli gives for these joints: fk, jacobian.
TEST(Quantities, OfAKnownPoseAreThoseOfTheCommandLine) {
  const Moment moment;  // q = 0.1 0.6 0.3 0.2 1.2 0.3
  EXPECT_NEAR(numberOf("tip_mm", moment, 1), 22.185813878179122, 1e-9);
  EXPECT_NEAR(numberOf("tip_mm", moment, 2), 9.157740516493886, 1e-9);
  EXPECT_NEAR(numberOf("tip_mm", moment, 3), 45.118118164421375, 1e-9);
  EXPECT_NEAR(numberOf("stylus", moment, 1), -0.09921832295953613, 1e-12);
  EXPECT_NEAR(numberOf("stylus", moment, 2), 0.4902928865650571, 1e-12);
  EXPECT_NEAR(numberOf("stylus", moment, 3), 0.8658918002688333, 1e-12);
  EXPECT_EQ(numberOf("branch", moment), 1.0);
  EXPECT_EQ(numberOf("solutions", moment), 8.0);
}

// The oracle writes eq. 3.1 and 3.5, and det J_p, out once more; it shares no line with core/arm.
TEST(Quantities, FollowTheFormulasOfTheThesis) {
  underact::test::Random random(underact::test::Seed{20070702});
  const double L1 = 127.508, L2 = 149.352;
  for (int count = 0; count < 200; ++count) {
    const arm::JointAngles q{
        random.between(-0.9, 0.9), random.between(0.0, 1.7), random.between(-0.8, 1.3), 0.1, 1.3, -0.2};
    const Moment moment(q);
    const double r = L1 * std::cos(q[1]) + L2 * std::sin(q[1] + q[2]);
    const double up = L1 * std::sin(q[1]) - L2 * std::cos(q[1] + q[2]);
    EXPECT_NEAR(numberOf("tip_in_base_mm", moment, 1), std::cos(q[0]) * r, 1e-9);
    EXPECT_NEAR(numberOf("tip_in_base_mm", moment, 2), std::sin(q[0]) * r, 1e-9);
    EXPECT_NEAR(numberOf("tip_in_base_mm", moment, 3), up, 1e-9);
    EXPECT_NEAR(numberOf("tip_mm", moment, 2), up + 30.0, 1e-9);
    const double det_cm3 = 1e-3 * L1 * L2 * std::cos(q[2]) * r;
    EXPECT_NEAR(numberOf("det_Jp_cm3", moment), det_cm3, 1e-9);
    EXPECT_NEAR(numberOf("manipulability_cm3", moment), std::abs(det_cm3), 1e-9);
    const double gains =
        numberOf("gains_mm", moment, 1) * numberOf("gains_mm", moment, 2) * numberOf("gains_mm", moment, 3);
    EXPECT_NEAR(1e-3 * gains, std::abs(det_cm3), 1e-6);
    EXPECT_NEAR(numberOf("shoulder_mm", moment), std::abs(r), 1e-9);
    EXPECT_NEAR(numberOf("elbow_deg", moment), 90.0 - std::abs(q[2]) / kRadPerDegree, 1e-9);
    EXPECT_NEAR(numberOf("device_deg", moment, 1), -q[0] / kRadPerDegree, 1e-9);
    EXPECT_NEAR(numberOf("device_deg", moment, 3), (q[1] + q[2]) / kRadPerDegree, 1e-9);
  }
}

TEST(Quantities, OfForcesAreThoseOfTheTick) {
  Moment moment({0.0, 0.5, 0.5, 0.0, 1.5, 0.0});
  moment.tick.p_WP = moment.tick.p_WT + Vec3(0.004, 0, 0);
  moment.tick.error_m = 0.004;
  moment.tick.f_asked_T_W = Vec3(2.0, 0, 0);
  EXPECT_NEAR(numberOf("stiffness_N_per_mm", moment), 0.5, 1e-12);
  EXPECT_NEAR(numberOf("lean_deg", moment), 0.0, 1e-9);
  EXPECT_NEAR(numberOf("offset_mm", moment, 1), -4.0, 1e-9);
  moment.tick.f_asked_T_W = Vec3(1.0, 1.0, 0);
  EXPECT_NEAR(numberOf("lean_deg", moment), 45.0, 1e-9);
  moment.tick.error_m = 0.0001;
  EXPECT_TRUE(std::isnan(numberOf("stiffness_N_per_mm", moment)));
  moment.tick.energy_J = -0.002;
  EXPECT_NEAR(numberOf("energy_mJ", moment), -2.0, 1e-12);
}

TEST(Quantities, OfGainsAreThoseOfTheScene) {
  Moment moment;
  moment.scene.control.law = scene::LawType::P;
  moment.scene.control.gains.kd_N_s_per_mm = Vec3::Constant(0.002);
  EXPECT_EQ(numberOf("kp_N_per_mm", moment, 2), 0.5);
  EXPECT_EQ(numberOf("kd_N_s_per_mm", moment), 0.0);  // P takes no damping
  moment.scene.control.law = scene::LawType::PD;
  EXPECT_EQ(numberOf("kd_N_s_per_mm", moment), 0.002);
}

TEST(Quantities, OfARobotAreKnownWhereTheSceneHasIt) {
  Moment moment;
  EXPECT_TRUE(std::isnan(numberOf("robot", moment)));
  scene::VirtualManipulator robot;
  robot.joints = {{chain::JointType::Revolute}, {chain::JointType::Prismatic}};
  moment.scene.constraints.push_back({"robot", robot, {}, {}});
  moment.robot.joints = 2;
  moment.robot.theta[0] = 0.5 * kPi;
  moment.robot.theta[1] = 0.025;
  EXPECT_NEAR(numberOf("robot", moment, 1), 90.0, 1e-9);
  EXPECT_NEAR(numberOf("robot", moment, 2), 25.0, 1e-9);
  moment.robot.joints = 1;  // a joint was just added, and the servo has not taken it up
  EXPECT_TRUE(std::isnan(numberOf("robot", moment)));
}

}  // namespace
TEST(Quantities, JointsBeyondTheSixthAreKnownOfAnArmThatHasThem) {
  const arm::Preset& panda = *arm::findPreset("panda");
  servo::TickRecord tick;
  tick.q_rad = panda.geometry.mechanism->rest;
  const scene::Description scene;
  const target::Robot robot;
  const Quantity& quantity = *findQuantity("q_deg");
  const Values of_seven = quantity.of({tick, scene, panda, robot});
  EXPECT_NEAR(of_seven[6], 45.0, 1e-12);
  EXPECT_TRUE(std::isnan(of_seven[7]));
  const Values of_omni = quantity.of(test::Moment().seen());
  EXPECT_FALSE(std::isnan(of_omni[5]));
  EXPECT_TRUE(std::isnan(of_omni[6]));
}

}  // namespace underact::lesson
