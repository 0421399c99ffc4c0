#include "core/kinematics/solved_arm.h"

#include <gtest/gtest.h>

#include "core/kinematics/forward.h"
#include "core/kinematics/inverse.h"
#include "core/kinematics/statics.h"
#include "core/kinematics/units.h"

namespace underact::kinematics {

TEST(SolvedArm, EveryShippedArmIsSolvedByTheMethodThatItHas) {
  for (const arm::Model& model : arm::models()) {
    const Result<SolvedArm> arm = chooseArm(model.name);
    ASSERT_TRUE(arm) << model.name;
    const Result<Method> method = methodFor(arm.value(), "auto");
    ASSERT_TRUE(method);
    EXPECT_EQ(method.value() == Method::StraightLine, arm.value().omni.has_value()) << model.name;
    EXPECT_EQ(methodFor(arm.value(), "iterative").value(), Method::Iteration);
  }
  EXPECT_FALSE(chooseArm("nobody"));
  EXPECT_FALSE(chooseArm("omni-thesis", {"base", "tip"}));
}

TEST(SolvedArm, ASlidingJointIsInMillimetresOutside) {
  const SolvedArm arm = chooseArm("stanford").value();
  std::vector<double> q{0.1, 0.2, 300.0, 0.4, 0.5, 0.6};
  const chain::JointValues inside = jointsOf(arm.chain(), q);
  EXPECT_EQ(inside[2], 300.0 * 1e-3);
  EXPECT_EQ(inside[3], 0.4);
  std::vector<double> back(6);
  writeJoints(arm.chain(), inside, back);
  EXPECT_DOUBLE_EQ(back[2], 300.0);
  EXPECT_FALSE(sixTurn(arm));
  const Eigen::MatrixXd J = jacobianOf(arm, inside);
  EXPECT_NEAR(J.col(2).head<3>().norm(), 1.0, 1e-12);  // mm of the tip for each mm of the slide
}

TEST(SolvedArm, ThePoseOfEachSolutionIsThePoseAsked) {
  const SolvedArm arm = chooseArm("puma-560").value();
  const chain::JointValues q{0.3, -0.4, 0.5, 0.6, 0.7, 0.8};
  Pose X_WT;
  ASSERT_EQ(readPose(poseOf(arm, q), X_WT), "");
  const Answer answer = solve(arm, X_WT, methodFor(arm, "auto").value(), {});
  EXPECT_EQ(answer.found.size(), 8U);
  for (const Found& one : answer.found) EXPECT_LT((poseOf(arm, one.q) - matrixOf(X_WT)).cwiseAbs().maxCoeff(), 1e-8);
}

TEST(ReadPose, RefusesWhatIsNoPoseWithTheReason) {
  Pose X;
  Eigen::Matrix4d matrix = Eigen::Matrix4d::Identity();
  EXPECT_EQ(readPose(matrix, X), "");
  matrix(0, 0) = 1.01;
  EXPECT_NE(readPose(matrix, X), "");
  matrix(0, 0) = kNotANumber;
  EXPECT_NE(readPose(matrix, X), "");
  matrix(0, 0) = -1.0;  // a mirror
  EXPECT_NE(readPose(matrix, X), "");
  matrix = Eigen::Matrix4d::Identity();
  matrix(3, 0) = 1e-9;
  EXPECT_NE(readPose(matrix, X), "");
}

}  // namespace underact::kinematics
