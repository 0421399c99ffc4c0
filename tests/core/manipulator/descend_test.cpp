#include "core/manipulator/descend.h"

#include <algorithm>
#include <cmath>

#include "core/base/axis_geometry.h"
#include "core/manipulator/global.h"
#include "tests/core/manipulator/chains.h"

namespace underact::manipulator {
namespace {

using test::energyAt;

Manipulator iterative(chain::Chain chain, Orientation orientation, double ko_N_m_per_rad = 0.25) {
  Wanted wanted;
  wanted.chain = std::move(chain);
  wanted.orientation = orientation;
  wanted.ko_N_m_per_rad = ko_N_m_per_rad;
  wanted.method = Method::Iterative;
  return test::made(wanted);
}

Vec3 onCircle(double radius_m, double angle_rad) {
  return radius_m * Vec3(std::cos(angle_rad), std::sin(angle_rad), 0.0);
}

/// Whether no joint can lower the energy by itself: at a limit it is pushed outwards, elsewhere by nothing.
void expectSettled(const Manipulator& m, const Energy& at) {
  double lever_m = 0.1;  // longer where slides have gone far
  for (const double theta : at.theta) lever_m += std::abs(theta);
  const double scale = m.kp_N_per_m.maxCoeff() * lever_m * lever_m + 10.0 * m.ko_N_m_per_rad + 1.0;
  for (std::size_t i = 0; i < m.chain.joints.size(); ++i) {
    const chain::Joint& joint = m.chain.joints[i];
    ASSERT_GE(at.theta[i], joint.min);
    ASSERT_LE(at.theta[i], joint.max);
    ASSERT_LE(at.slope[i], at.theta[i] > joint.min ? 1e-7 * scale : kInfinity) << i;
    ASSERT_GE(at.slope[i], at.theta[i] < joint.max ? -1e-7 * scale : -kInfinity) << i;
  }
}

}  // namespace

TEST(Descend, NearACirclesCentreNewtonIsThereInAFewStepsWhereGaussNewtonCrawls) {
  // Gauss and Newton's step leaves 1 - rho / R of the error: at rho = R / 20 a hundred steps leave 0.006 of it.
  Manipulator m = iterative(test::ring(), Orientation::None);
  const Pose X_WT = test::tipAt(onCircle(0.0025, 0.4));
  Energy at = energyAt(m, X_WT, {});
  const Descent newton = descend(m, X_WT, 100, at);
  EXPECT_TRUE(newton.converged);
  EXPECT_LE(newton.steps, 5);
  EXPECT_NEAR(at.theta[0], 0.4, 1e-10);
  m.options.second_order = false;
  at = energyAt(m, X_WT, {});
  const Descent crawling = descend(m, X_WT, 100, at);
  EXPECT_FALSE(crawling.converged);
  EXPECT_EQ(crawling.steps, 100);
  EXPECT_NEAR(0.4 - at.theta[0], 0.4 * std::pow(0.95, 100), 5e-4);
}

TEST(Descend, FarOutsideACircleGaussNewtonOvershootsAndIsHeldByItsDamping) {
  // Undamped it leaves 1 - rho / R: beyond 2 R it would grow. Where the energy no longer tells a loss from a gain, at
  // the root of its rounding, damping is over.
  Manipulator m = iterative(test::ring(), Orientation::None);
  const Pose X_WT = test::tipAt(onCircle(0.150, 0.3));
  for (const bool second_order : {true, false}) {
    m.options.second_order = second_order;
    Energy at = energyAt(m, X_WT, {});
    const Descent descent = descend(m, X_WT, 100, at);
    EXPECT_NEAR(at.theta[0], 0.3, second_order ? 1e-10 : 1e-6);
    EXPECT_LE(descent.steps, second_order ? 5 : 100);
  }
}

TEST(Descend, TheSecondOrderIsWorthItWhereverTheResidualIsLarge) {
  test::property::Random random(test::property::Seed{20070621});
  int newton = 0, gauss = 0;
  for (int i = 0; i < test::property::sweep(300, 10'000); ++i) {
    Manipulator m = iterative(test::planarArm({0.05, 0.04, 0.03}), Orientation::Axis, 0.5);
    const Pose X_WT = test::anyPose(random, 0.15);
    for (const bool second_order : {true, false}) {
      m.options.second_order = second_order;
      Energy at = energyAt(m, X_WT, {0.3, 0.4, 0.5});
      (second_order ? newton : gauss) += descend(m, X_WT, 200, at).steps;
    }
  }
  EXPECT_LT(2 * newton, gauss);
}

TEST(Descend, FromAnywhereItEndsInAMinimumWithinTheLimits) {
  test::property::Random random(test::property::Seed{20070622});
  int ends = 0, count = 0;
  for (int i = 0; i < test::property::sweep(1'000, 50'000); ++i) {
    const Manipulator m = iterative(test::anyChain(random, 1 + random.below(8)), test::kOrientations[random.below(3)]);
    const Pose X_WT = test::anyPose(random, 0.2);
    Energy at = energyAt(m, X_WT, test::anyPlace(random, m));
    const Descent descent = descend(m, X_WT, 300, at);
    ASSERT_LE(descent.steps, 300);
    ++count;
    if (descent.left > 1e-7) continue;
    ++ends;
    expectSettled(m, at);
    if (HasFatalFailure()) FAIL() << i;
  }
  EXPECT_GE(ends, 0.97 * count);  // the others are on their way along nearly parallel slides
}

TEST(Descend, NoStepGoesUpOrBeyondALimit) {
  test::property::Random random(test::property::Seed{20070623});
  for (int i = 0; i < test::property::sweep(200, 10'000); ++i) {
    const Manipulator m = iterative(test::anyChain(random, 1 + random.below(8)), test::kOrientations[random.below(3)]);
    const Pose X_WT = test::anyPose(random, 0.2);
    Energy at = energyAt(m, X_WT, test::anyPlace(random, m));
    for (int step = 0; step < 30; ++step) {
      const double before_J = at.energy_J;
      const Values from = at.theta;
      const Descent descent = descend(m, X_WT, 1, at);
      // But for rounding: 4e-15 of the energy, and of forces of 100 N over 0.5 m.
      ASSERT_LE(at.energy_J, before_J + 4e-15 * (before_J + 50.0)) << i;
      ASSERT_LE(descent.steps, 1);
      for (std::size_t j = 0; j < m.chain.joints.size(); ++j) {
        const bool turns = m.chain.joints[j].type == chain::JointType::Revolute;
        ASSERT_LE(std::abs(at.theta[j] - from[j]), (turns ? 0.5 : 0.25 * m.reach_m) * (1.0 + 1e-12)) << i;
        ASSERT_GE(at.theta[j], m.chain.joints[j].min) << i;
        ASSERT_LE(at.theta[j], m.chain.joints[j].max) << i;
      }
    }
  }
}

TEST(Descend, OfAThousandTimesTheSizeTakesTheSameStepsInIt) {  // by a power of two, so that every bit is the same
  constexpr double kTimes = 1024.0;
  test::property::Random random(test::property::Seed{20070624});
  int mixed = 0;
  for (int i = 0; i < test::property::sweep(100, 10'000); ++i) {
    chain::Chain chain = test::anyChain(random, 2 + random.below(7));
    const Orientation orientation = test::kOrientations[random.below(3)];
    const Manipulator m = iterative(chain, orientation);
    const Pose X_WT = test::anyPose(random, 0.2);
    Energy at = energyAt(m, X_WT, test::anyPlace(random, m));
    Values start = at.theta;
    std::size_t slides = 0;
    for (std::size_t j = 0; j < chain.joints.size(); ++j) {
      chain::Joint& joint = chain.joints[j];
      joint.p_WJ *= kTimes;
      if (joint.type != chain::JointType::Prismatic) continue;
      joint.min *= kTimes, joint.max *= kTimes, start[j] *= kTimes;
      ++slides;
    }
    if (slides > 0 && slides < chain.joints.size()) ++mixed;
    chain.X_WT_home.translation() *= kTimes;
    Pose X_WT_large = X_WT;
    X_WT_large.translation() *= kTimes;
    Manipulator large = iterative(chain, orientation);
    large.kp_N_per_m = m.kp_N_per_m / (kTimes * kTimes);  // the same energy
    Energy there = energyAt(large, X_WT_large, start);
    EXPECT_EQ(descend(large, X_WT_large, 20, there).steps, descend(m, X_WT, 20, at).steps) << i;
    for (std::size_t j = 0; j < chain.joints.size(); ++j) {
      const bool slid = chain.joints[j].type == chain::JointType::Prismatic;
      ASSERT_EQ(there.theta[j], slid ? kTimes * at.theta[j] : at.theta[j]) << i << ", joint " << j;
    }
  }
  EXPECT_GT(mixed, 30);
}

TEST(Descend, AtItsMinimumItTakesNoStep) {
  const Manipulator m = iterative(test::planarArm({0.05, 0.04}), Orientation::None);
  const Pose X_WT = test::tipAt({0.12, 0, 0.01});
  Energy at = energyAt(m, X_WT, {});
  const Descent descent = descend(m, X_WT, 20, at);
  EXPECT_EQ(descent.steps, 0);
  EXPECT_TRUE(descent.converged);
  EXPECT_EQ(descent.left, 0.0);
}

TEST(Descend, FromTheSpheresPolesAndToThem) {
  // There joint 1 moves nothing: the Jacobian's column is 0 and the curvature has a row without anything of its own.
  const Manipulator m = iterative(test::ball(), Orientation::None);
  for (const double pole : {-1.0, 1.0}) {
    const Vec3 p_WT = onCircle(0.06, 0.7) + Vec3(0, 0, pole * 0.03);
    for (const double first_rad : {0.0, 0.7, 2.0}) {
      Energy at = energyAt(m, test::tipAt(p_WT), {first_rad, pole * kPi / 2});
      descend(m, test::tipAt(p_WT), 100, at);
      EXPECT_LE((at.tip.X_WT.translation() - 0.05 * p_WT.normalized()).norm(), 1e-9) << pole << " " << first_rad;
    }
    const Pose X_WT = test::tipAt({0, 0, pole * 0.07});
    Energy at = energyAt(m, X_WT, {0.3, 0.2 * pole});
    const Descent to = descend(m, X_WT, 100, at);
    EXPECT_LE((at.tip.X_WT.translation() - Vec3(0, 0, pole * 0.05)).norm(), 1e-9);
    EXPECT_LE(to.steps, 12);
  }
}

TEST(Descend, WithoutATurnToMeetSixJointsStillMeetThePlace) {  // three joints' worth of freedom is left over
  test::property::Random random(test::property::Seed{20070624});
  const Manipulator m = iterative(
      test::chainOf(chain::test::omni().chain().joints, chain::test::omni().chain().X_WT_home), Orientation::None);
  const Vec3 p_WB = chain::test::omni().X_WB.translation();
  for (int i = 0; i < test::property::sweep(200, 5'000); ++i) {
    const Pose X_WT = test::poseOf(Mat3::Identity(), p_WB + random.between(0.05, 0.25) * random.direction());
    Energy at = energyAt(m, X_WT, {0.1, 0.2, -0.6, 0.1, 0.2, 0.3});
    const Descent descent = descend(m, X_WT, 60, at);
    ASSERT_LE(at.e_p_W.norm(), 1e-9) << i << " after " << descent.steps;
  }
}

TEST(Descend, AnArmThatCannotReachStretchesAndPullsAlongItsRadius) {
  // 340 mm from the shoulder with links of 127.508 and 149.352 mm: what is left points along the arm.
  const chain::test::Arm omni = chain::test::omni();
  const Manipulator m = iterative(omni.chain(), Orientation::Full, 2.5);
  const Vec3 p_WB = omni.X_WB.translation(), out_W = Vec3(1, 2, 3).normalized();
  const Pose X_WT = test::poseOf(test::about(Vec3(3, 1, -1).normalized(), 0.8), p_WB + 0.340 * out_W);
  const Global found = minEnergy(m, X_WT);
  const double beyond_m = 0.340 - 0.127508 - 0.149352;
  EXPECT_NEAR(found.at.e_p_W.norm(), beyond_m, 1e-12);
  EXPECT_LE((found.at.f_W + 500.0 * beyond_m * out_W).norm(), 1e-7);
  EXPECT_LE(found.at.e_o_W.norm(), 1e-8);
  Energy at = energyAt(m, X_WT, {0.2, 0.5, -0.9, 0.1, 0.4, 0.2});  // and warm, from somewhere bent
  descend(m, X_WT, 100, at);
  EXPECT_NEAR(at.e_p_W.norm(), beyond_m, 1e-12);
}

TEST(Descend, ANumberThatIsNoneOrHugeEndsItAtOnce) {
  for (const double strange : {kNotANumber, kInfinity, -kInfinity, 1e200}) {
    for (const Orientation orientation : test::kOrientations) {
      const Manipulator m = iterative(test::scara(), orientation);
      Pose X_WT = test::tipAt({0.1, strange, 0});
      Energy at = energyAt(m, X_WT, {0.1, 0.2, 0.03, 0.4});
      EXPECT_LE(descend(m, X_WT, 20, at).steps, 20);
      for (const double value : at.theta) EXPECT_TRUE(std::isfinite(value));
      X_WT = test::tipAt({0.1, 0, 0});
      X_WT.linear()(1, 2) = strange;
      at = energyAt(m, X_WT, {0.1, 0.2, 0.03, 0.4});
      EXPECT_LE(descend(m, X_WT, 20, at).steps, 20);
      for (const double value : at.theta) EXPECT_TRUE(std::isfinite(value));
    }
  }
}

TEST(Allowed, TurnsWithoutLimitsAreWrappedOthersAreClamped) {
  Wanted wanted;
  wanted.chain =
      test::chainOf({test::turning(Vec3::UnitZ(), Vec3::Zero()), test::turning(Vec3::UnitY(), Vec3::Zero(), -1.0, 7.0),
                     test::sliding(Vec3::UnitX(), -0.1, 0.2), test::turning(Vec3::UnitZ(), Vec3::Zero())},
                    test::tipAt(Vec3::Zero()));
  wanted.spring[3] = 1.0;
  const Values theta = clampedToLimits(test::made(wanted), {7.0, 6.5, 0.3, 7.0});
  EXPECT_NEAR(theta[0], 7.0 - 2.0 * kPi, 1e-15);
  EXPECT_EQ(theta[1], 6.5);
  EXPECT_EQ(theta[2], 0.2);
  EXPECT_EQ(theta[3], 7.0);  // its spring counts the turns
}

}  // namespace underact::manipulator
