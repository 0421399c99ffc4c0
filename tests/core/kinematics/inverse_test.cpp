#include "core/kinematics/inverse.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "core/chain/kinematics.h"
#include "tests/support/arm_tables.h"
#include "tests/support/random.h"

namespace underact::kinematics {
namespace {

/// Three joints of which each turns from 0 to a full turn: two links above a turntable.
SolvedArm turntable(double min = 0.0, double max = 2.0 * kPi) {
  const chain::Joint base{chain::JointType::Revolute, Vec3::UnitZ(), Vec3(0, 0, 0.1), min, max};
  const chain::Joint shoulder{chain::JointType::Revolute, Vec3::UnitY(), Vec3(0, 0, 0.4), min, max};
  const chain::Joint elbow{chain::JointType::Revolute, Vec3::UnitY(), Vec3(0, 0, 0.7), min, max};
  arm::Model model;
  model.chain = {{base, shoulder, elbow}, chain::test::omni().X_NT};
  model.chain.X_WT_home.translation() = Vec3(0, 0, 0.9);
  model.joints.resize(3);
  model.rows.resize(3);
  for (chain::DhRow& row : model.rows) row.min = min, row.max = max;
  return solvedArm(model);
}

SolvedArm ofTable(const chain::test::Arm& table) {
  arm::Model model;
  model.name = table.name;
  model.rows = table.rows;
  model.chain = table.chain();
  model.joints.resize(table.rows.size());
  return solvedArm(model);
}

Pose poseAt(const SolvedArm& arm, const std::vector<double>& q) {
  return chain::forward(arm.chain(), q);
}

std::vector<double> jointsOfFound(const SolvedArm& arm, const Found& found) {
  return {found.q.begin(), found.q.begin() + static_cast<std::ptrdiff_t>(arm.joints())};
}

/// What is said of limits is so of the joints as they stand, and each solution reaches the pose.
void expectTrue(const SolvedArm& arm, const Pose& X_WT, const Answer& answer) {
  for (const Found& one : answer.found) {
    bool within = true;
    for (std::size_t i = 0; i < arm.joints(); ++i) {
      const chain::Joint& joint = arm.chain().joints[i];
      within &= one.q[i] >= joint.min && one.q[i] <= joint.max;
    }
    EXPECT_EQ(one.within_limits, within) << arm.model.name;
    const Pose X = poseAt(arm, jointsOfFound(arm, one));
    EXPECT_LE((X.translation() - X_WT.translation()).norm(), 1e-8) << arm.model.name;
  }
}

}  // namespace

TEST(InverseWithinLimits, TheAngleGivenIsTheOneWithinThem) {
  const SolvedArm arm = turntable();
  const std::vector<double> q{4.7, 5.9, 0.6};
  const Pose X_WT = poseAt(arm, q);
  for (const char* method : {"closed_form", "iterative"}) {
    const Answer answer = solve(arm, X_WT, methodFor(arm, method).value(), {method, 1, 0, q});
    ASSERT_FALSE(answer.found.empty());
    expectTrue(arm, X_WT, answer);
    EXPECT_TRUE(answer.found[0].within_limits) << method;
    for (std::size_t i = 0; i < 3; ++i) EXPECT_NEAR(answer.found[0].q[i], q[i], 1e-8) << method;
  }
}

TEST(InverseWithinLimits, TheTurnIsTheNearestToThePostureAndEachSolutionIsThereOnce) {
  const SolvedArm arm = turntable(-4.0 * kPi, 4.0 * kPi);
  const std::vector<double> q{0.4, 0.5, 0.6}, near{0.4 - 2.0 * kPi, 0.5 + 2.0 * kPi, 0.6};
  const Pose X_WT = poseAt(arm, q);
  const Answer plain = solve(arm, X_WT, Method::Geometry, {}),
               preferred = solve(arm, X_WT, Method::Geometry, {"auto", 1, 0, near});
  ASSERT_EQ(plain.found.size(), preferred.found.size());
  expectTrue(arm, X_WT, preferred);
  for (const Found& one : plain.found) {
    for (std::size_t i = 0; i < 3; ++i) EXPECT_LE(std::abs(one.q[i]), kPi);
  }
  for (std::size_t i = 0; i < 3; ++i) EXPECT_NEAR(preferred.found[0].q[i], near[i], 1e-9);
  EXPECT_TRUE(std::is_sorted(preferred.found.begin(), preferred.found.end(),
                             [](const Found& a, const Found& b) { return a.within_limits && !b.within_limits; }));
}

TEST(InverseWithinLimits, ATurnBeyondTheLimitsIsNotTaken) {  // by hand
  const SolvedArm arm = turntable(-4.0 * kPi, 4.0 * kPi);
  std::array<double, 3> q{0.5, -0.5, 20.0};
  arm::turnIntoLimits(arm.model, q, std::array<double, 3>{0.5 + 4.0 * kPi, 100.0, -100.0});
  EXPECT_DOUBLE_EQ(q[0], 0.5 + 2.0 * kPi);
  EXPECT_DOUBLE_EQ(q[1], -0.5 + 4.0 * kPi);
  EXPECT_DOUBLE_EQ(q[2], 20.0 - 10.0 * kPi);
}

TEST(InverseWithinLimits, AJointAtItsLimitIsWithin) {
  const SolvedArm arm = turntable(0.3, 0.3 + kPi);
  const std::vector<double> q{0.3 + kPi, 0.3, 0.3 + kPi};
  const Answer answer = solve(arm, poseAt(arm, q), Method::Geometry, {"auto", 1, 0, q});
  ASSERT_FALSE(answer.found.empty());
  EXPECT_TRUE(answer.found[0].within_limits);
  EXPECT_NEAR(answer.found[0].q[2], 0.3 + kPi, 1e-12);
}

TEST(InverseWithinLimits, EveryShippedArmSaysOfItsLimitsWhatIsSo) {
  test::Random random({20260601});
  for (const arm::Model& model : arm::models()) {
    const SolvedArm arm = solvedArm(model);
    for (int draw = 0; draw < 20; ++draw) {
      std::vector<double> q;
      for (const chain::Joint& joint : model.chain.joints)
        q.push_back(random.between(std::max(joint.min, -3.0), std::min(joint.max, 3.0)));
      const Pose X_WT = poseAt(arm, q);
      for (const char* method : {"auto", "iterative"}) {
        for (const std::vector<double>& posture : {std::vector<double>{}, q}) {
          const Answer answer = solve(arm, X_WT, methodFor(arm, method).value(), {method, 1, 0, posture});
          ASSERT_FALSE(answer.found.empty()) << model.name;
          if (!model.limits_wrist_size) expectTrue(arm, X_WT, answer);
          if (!posture.empty()) EXPECT_TRUE(answer.found[0].within_limits) << model.name << " " << method;
        }
      }
    }
  }
}

TEST(InverseWithinLimits, APoseFromJointsWithinThemIsAnsweredWithinThem) {
  for (const SolvedArm& arm : {chooseArm("panda").value(), chooseArm("iiwa7").value(), ofTable(chain::test::gen3())}) {
    test::Random random({20260602});
    for (int draw = 0; draw < 300; ++draw) {
      std::vector<double> q;
      for (const chain::Joint& joint : arm.chain().joints)
        q.push_back(random.between(std::max(joint.min, -kPi), std::min(joint.max, kPi)));
      const Pose X_WT = poseAt(arm, q);
      const Answer answer = solve(arm, X_WT, methodFor(arm, "auto").value(), {});
      ASSERT_EQ(answer.found.size(), 1U) << arm.model.name << " " << draw;
      EXPECT_TRUE(answer.found[0].within_limits) << arm.model.name << " " << draw;
      expectTrue(arm, X_WT, answer);
    }
  }
}

TEST(InverseWithinLimits, APoseBeyondThemIsAnsweredAndSaidToBe) {
  const SolvedArm arm = turntable(0.0, 0.3);
  const Pose X_WT = poseAt(arm, {0.2, 1.0, 0.2});
  for (const char* method : {"closed_form", "iterative"}) {
    const Answer answer = solve(arm, X_WT, methodFor(arm, method).value(), {});
    EXPECT_TRUE(answer.reachable) << method;
    ASSERT_FALSE(answer.found.empty()) << method;
    for (const Found& one : answer.found) EXPECT_FALSE(one.within_limits) << method;
  }
}

}  // namespace underact::kinematics
