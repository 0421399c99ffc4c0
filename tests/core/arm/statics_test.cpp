#include "core/arm/statics.h"

#include <algorithm>

#include "core/arm/jacobian.h"
#include "tests/core/arm/golden.h"
#include "tests/core/arm/thesis.h"
#include "tests/support/property.h"

namespace underact::arm {
namespace {

Vec3 threeOf(const test::Value& list) {
  return {list.items.at(0).number, list.items.at(1).number, list.items.at(2).number};
}

}  // namespace

TEST(Statics, MeetsTheGoldenTorquesAndTakesThemBack) {
  const test::Value file = test::golden("jacobian.json");
  int exact = 0;
  for (const test::Value& one : file.find("cases")->items) {
    const JointAngles q_rad = test::anglesOf(*one.find("q"));
    const Vec3 f_T_W = threeOf(*one.find("F_example"));
    const Vec3 wanted_N_m = kMetrePerMillimetre * threeOf(*one.find("tau_example_Nmm"));
    const Vec3 torque_N_m = torqueOf(thesis().geometry, q_rad, f_T_W);
    ASSERT_LE((torque_N_m - wanted_N_m).cwiseAbs().maxCoeff(), 1e-15 * 4) << "line " << one.line;
    const ForceOfTorque back = forceOf(thesis().geometry, q_rad, torque_N_m);
    if (back.damping_m > 0.0) continue;
    ++exact;
    ASSERT_LE((back.f_T_W - f_T_W).norm(), 1e-13) << "line " << one.line;  // 3 N, gains down to 1/15 of the largest
    ASSERT_EQ(back.torque_error_N_m, 0.0);
  }
  EXPECT_GT(exact, 40);
}

TEST(Statics, ForcesAndTorquesDoTheSameWork) {
  test::Random random(test::Seed{20070421});
  for (int i = 0; i < 1000; ++i) {
    JointAngles q_rad{};
    for (double& angle_rad : q_rad) angle_rad = random.between(-kPi, kPi);
    const Mat6 J = kinematics(thesis().geometry, q_rad).J;
    Vec6 wrench, rates;
    for (Eigen::Index k = 0; k < 6; ++k) wrench[k] = random.between(-1, 1), rates[k] = random.between(-1, 1);
    EXPECT_NEAR(torqueOf(J, wrench).dot(rates), wrench.dot(J * rates), 1e-14);
  }
}

TEST(Statics, NearASingularityTheForceStaysBoundedAndTheErrorIsTold) {
  const Vec3 torque_N_m(0.02, -0.03, 0.05);
  double last_N = 0.0;
  for (double off_rad = 0.5; off_rad > 1e-15; off_rad *= 0.9) {
    const JointAngles q_rad{0.2, 0.6, kPi / 2 - off_rad, 0.0, 1.5, 0.0};
    const ForceOfTorque at = forceOf(thesis().geometry, q_rad, torque_N_m);
    const Vec3 left_N_m = positionJacobian(thesis().geometry, q_rad).transpose() * at.f_T_W - torque_N_m;
    ASSERT_NEAR(at.torque_error_N_m, at.damping_m > 0.0 ? left_N_m.norm() : 0.0, 1e-16);
    ASSERT_LE(left_N_m.norm(), torque_N_m.norm() * (1 + 1e-12));
    if (at.damping_m > 0.0) {
      // Along each axis gain / (gain^2 + lambda^2) <= 1 / (2 lambda); three axes, each by its share of the torque.
      ASSERT_LE(at.f_T_W.norm(), torque_N_m.norm() / (2.0 * at.damping_m) * (1 + 1e-12));
    }
    if (last_N > 0.0) {
      ASSERT_LE(std::abs(at.f_T_W.norm() - last_N), 0.2 * last_N + 1e-12) << off_rad;  // no step
    }
    last_N = at.f_T_W.norm();
  }
  EXPECT_EQ(forceOf({0.0, 0.0, Vec3::Zero()}, {}, torque_N_m).f_T_W, Vec3::Zero());
}

}  // namespace underact::arm
