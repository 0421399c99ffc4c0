#include "core/chain/dh.h"

#include "tests/core/chain/arms.h"

namespace underact::chain {
namespace {

constexpr double kRounding = 1e-15;

TEST(DhRow, IsTheFourElementaryMotionsInTheirOrder) {  // oracle: the definition, by Eigen's own rotations
  test::property::Random random({1});
  for (int draw = 0; draw < 200; ++draw) {
    const double alpha = random.between(-4, 4), a = random.between(-1, 1), theta = random.between(-4, 4);
    const double d = random.between(-1, 1), q = random.between(-2, 2);
    const Pose twist =
        test::poseOf(test::about(Vec3::UnitX(), alpha), Vec3::Zero()) * test::poseOf(Mat3::Identity(), Vec3(a, 0, 0));
    const Pose turned = twist * test::poseOf(test::about(Vec3::UnitZ(), theta + q), Vec3(0, 0, 0)) *
                        test::poseOf(Mat3::Identity(), Vec3(0, 0, d));
    const Pose pushed = twist * test::poseOf(test::about(Vec3::UnitZ(), theta), Vec3(0, 0, 0)) *
                        test::poseOf(Mat3::Identity(), Vec3(0, 0, d + q));
    EXPECT_LE((rowPose({JointType::Revolute, alpha, a, theta, d}, q).matrix() - turned.matrix()).norm(), kRounding);
    EXPECT_LE((rowPose({JointType::Prismatic, alpha, a, theta, d}, q).matrix() - pushed.matrix()).norm(), kRounding);
  }
}

TEST(DhFrames, OfThePumaStandWhereItsLengthsSay) {  // by hand: zero angles, upper arm along x, forearm up
  const test::Arm arm = test::puma();
  const std::array<double, 6> q{};
  std::array<Pose, 6> X_WFrames;
  framesOf(arm.rows, arm.X_WB, q, X_WFrames);
  EXPECT_LE((X_WFrames[1].translation() - Vec3(0, 0.2435, 0)).norm(), kRounding);
  EXPECT_LE((X_WFrames[2].translation() - Vec3(0.4318, 0.1501, 0)).norm(), kRounding);
  EXPECT_LE((X_WFrames[5].translation() - Vec3(0.4115, 0.1501, 0.4331)).norm(), kRounding);
}

TEST(DhFrames, OfTheIrb120StandWhereItsDataSheetDrawsThem) {  // upper arm up, forearm and flange along x
  const test::Arm arm = test::irb120();
  const std::array<double, 6> q{};
  std::array<Pose, 6> X_WFrames;
  framesOf(arm.rows, arm.X_WB, q, X_WFrames);
  EXPECT_LE((X_WFrames[2].translation() - Vec3(0, 0, 0.560)).norm(), kRounding);
  EXPECT_LE((X_WFrames[3].translation() - Vec3(0.302, 0, 0.630)).norm(), kRounding);
  const Pose X_WT = X_WFrames[5] * arm.X_NT;
  EXPECT_LE((X_WT.translation() - Vec3(0.374, 0, 0.630)).norm(), kRounding);
  Mat3 R_WT;
  R_WT << 0, 0, 1, 0, 1, 0, -1, 0, 0;  // the flange looks along x, its x axis down
  EXPECT_LE((X_WT.linear() - R_WT).norm(), kRounding);
}

TEST(DhFrames, AreAsManyAsTheShortestSpan) {
  const test::Arm arm = test::puma();
  const std::array<double, 6> q{};
  std::array<Pose, 6> X_WFrames;
  X_WFrames.fill(test::poseOf(Mat3::Identity(), Vec3(7, 7, 7)));
  framesOf(arm.rows, arm.X_WB, std::span(q).first(2), X_WFrames);
  EXPECT_NE(X_WFrames[1].translation(), Vec3(7, 7, 7));
  EXPECT_EQ(X_WFrames[2].translation(), Vec3(7, 7, 7));
}

}  // namespace
}  // namespace underact::chain
