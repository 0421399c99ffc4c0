#include "core/chain/steps.h"

#include <array>

#include "tests/core/chain/arms.h"

namespace underact::chain {
namespace {

constexpr double kStepsRounding = 1e-14;

Step drawn(test::property::Random& random) {
  const auto kind = static_cast<StepKind>(static_cast<int>(random.between(0.0, 5.999)));
  return {kind, isRotationStep(kind) ? random.between(-4, 4) : random.between(-1, 1)};
}

/// By Eigen's own rotations and translations; shares no line with the code.
Eigen::Isometry3d independent(const Step& step) {
  const Vec3 axis = Vec3::Unit(static_cast<int>(step.kind) % 3);
  return isRotationStep(step.kind) ? Eigen::Isometry3d(Eigen::AngleAxisd(step.amount, axis))
                                   : Eigen::Isometry3d(Eigen::Translation3d(step.amount * axis));
}

TEST(Steps, AboutMovingAxesMultiplyFromTheRightAndAboutFixedOnesFromTheLeft) {
  test::property::Random random({11});
  for (int draw = 0; draw < 300; ++draw) {
    std::vector<Step> steps;
    Eigen::Isometry3d moving = Eigen::Isometry3d::Identity(), fixed = moving;
    for (int count = 0; count < 5; ++count) {
      steps.push_back(drawn(random));
      moving = moving * independent(steps.back());
      fixed = independent(steps.back()) * fixed;
    }
    EXPECT_LE((composed(steps, Axes::Moving).back().matrix() - moving.matrix()).norm(), kStepsRounding);
    EXPECT_LE((composed(steps, Axes::Fixed).back().matrix() - fixed.matrix()).norm(), kStepsRounding);
  }
}

TEST(Steps, InTheOtherOrderAboutTheOtherAxesEndInTheSamePlace) {  // Craig, section 2.8
  test::property::Random random({12});
  for (int draw = 0; draw < 100; ++draw) {
    std::vector<Step> steps{drawn(random), drawn(random), drawn(random)};
    const Pose X = composed(steps, Axes::Moving).back();
    std::reverse(steps.begin(), steps.end());
    EXPECT_LE((composed(steps, Axes::Fixed).back().matrix() - X.matrix()).norm(), kStepsRounding);
  }
}

TEST(Steps, AQuarterTurnAboutZAndAShiftAlongXEndByHandWhereTheyShould) {
  const std::array<Step, 2> steps{Step{StepKind::TurnZ, kPi / 2}, Step{StepKind::ShiftX, 0.04}};
  EXPECT_LE((composed(steps, Axes::Moving).back().translation() - Vec3(0, 0.04, 0)).norm(), kStepsRounding);
  EXPECT_LE((composed(steps, Axes::Fixed).back().translation() - Vec3(0.04, 0, 0)).norm(), kStepsRounding);
}

}  // namespace
}  // namespace underact::chain
