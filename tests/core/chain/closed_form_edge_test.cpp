#include <algorithm>
#include <map>

#include "core/chain/closed_form.h"
#include "tests/core/arm/golden.h"
#include "tests/core/chain/arms.h"

namespace underact::chain {
namespace {

using test::Angles;

const Chain& omni() {
  static const Chain kChain = test::omni().chain();
  return kChain;
}
const SphericalWristArm& omniArm() {
  static const SphericalWristArm kArm = recognise(omni()).value();
  return kArm;
}

bool finite(const Solutions& found) {
  return std::all_of(found.all.begin(), found.all.end(), [](const Solution& one) {
    return std::all_of(one.q.begin(), one.q.end(), [](double angle_rad) { return std::isfinite(angle_rad); });
  });
}

/// The largest miss of all exact solutions, m and rad alike.
double worst(const Chain& chain, const Solutions& found, const Pose& X_WT) {
  double max = 0.0;
  for (std::size_t i = 0; i < found.exact; ++i) {
    const Pose X = forward(chain, found.all[i].q);
    max = std::max({max, test::wayBetween(X, X_WT), test::turnBetween(X, X_WT)});
  }
  return max;
}

double maxApart(const Angles& a, const Angles& b) {
  double max_rad = 0.0;
  for (std::size_t i = 0; i < 6; ++i) {
    max_rad = std::max(max_rad, std::abs(std::remainder(a[i] - b[i], 2 * kPi)));
  }
  return max_rad;
}

/// How far the answers, taken as a set, are from those of a golden case; rad.
double setDistance(const Solutions& found, const underact::test::Value& solutions) {
  double max_rad = 0.0;
  for (const underact::test::Value& expected : solutions.items) {
    const arm::JointAngles q_rad = underact::test::anglesOf(*expected.find("q"));
    const Angles six{q_rad[0], q_rad[1], q_rad[2], q_rad[3], q_rad[4], q_rad[5]};
    double min_rad = kInfinity;
    for (std::size_t i = 0; i < found.exact; ++i) {
      min_rad = std::min(min_rad, maxApart(found.all[i].q, six));
    }
    max_rad = std::max(max_rad, min_rad);
  }
  return max_rad;
}

TEST(ClosedFormGolden, HasTheSolutionsOfEveryCaseAndNoOthers) {
  const underact::test::Value file = underact::test::golden("ik.json");
  const underact::test::Value* const cases = file.find("cases");
  ASSERT_NE(cases, nullptr);
  // On an edge the pose's rounding moves an angle by the root of it. Regular cases lose digits to sin q5, cos q3 and
  // the distance from axis 1.
  const std::map<std::string, double> within_rad{{"regular", 1e-9},
                                                 {"wrist_singular", 1e-9},
                                                 {"elbow_boundary", 2e-6},
                                                 {"elbow_boundary+wrist_singular", 2e-6},
                                                 {"shoulder_singular", 1e-9}};
  std::map<std::string, int> met;
  for (const underact::test::Value& one : cases->items) {
    const std::string status = one.find("status")->text;
    const Pose X_WT = underact::test::poseOf(*one.find("T"));
    const Solutions found = solveAll(omniArm(), X_WT);
    ++met[status];
    ASSERT_TRUE(finite(found)) << "line " << one.line;
    ASSERT_EQ(found.exact, one.find("solutions")->items.size()) << one.find("name")->text << ", line " << one.line;
    if (found.exact == 0) continue;
    ASSERT_LE(worst(omni(), found, X_WT), 1e-12) << one.find("name")->text << ", line " << one.line;
    ASSERT_LE(setDistance(found, *one.find("solutions")), within_rad.at(status)) << one.find("name")->text;
  }
  EXPECT_EQ(met["regular"], 65);
  EXPECT_EQ(met["unreachable"], 7);
}

TEST(ClosedFormEdge, StraightWristKeepsJointFourAtZero) {
  for (const double q5 : {0.0, kPi}) {
    const Pose X_WT = forward(omni(), Angles{0.3, 0.6, 0.2, 0.7, q5, 0.4});
    const Solutions found = solveAll(omniArm(), X_WT);
    ASSERT_EQ(found.exact, 6U);
    EXPECT_EQ(std::count_if(found.all.begin(), found.all.begin() + 6,
                            [](const Solution& one) { return one.q[3] == 0.0 && one.wrist == 1; }),
              2);
    EXPECT_LE(worst(omni(), found, X_WT), 1e-12);
  }
}

TEST(ClosedFormEdge, NearlyStraightWristStillHasBothAnswers) {
  for (double bend_rad = 1e-3; bend_rad > 1e-11; bend_rad /= 10) {
    const Angles q{0.3, 0.6, 0.2, 0.7, bend_rad, 0.4};
    const Pose X_WT = forward(omni(), q);
    const Solutions found = solveAll(omniArm(), X_WT);
    EXPECT_EQ(found.exact, 8U) << bend_rad;
    EXPECT_LE(worst(omni(), found, X_WT), 1e-14) << bend_rad;
  }
}

TEST(ClosedFormEdge, StretchedArmHasFour) {
  for (const double q3 : {kPi / 2, -kPi / 2}) {
    const Pose X_WT = forward(omni(), Angles{0.3, 0.6, q3, 0.7, 0.8, 0.4});
    const Solutions found = solveAll(omniArm(), X_WT);
    EXPECT_EQ(found.count, 4U);
    EXPECT_EQ(found.exact, 4U);
    EXPECT_LE(worst(omni(), found, X_WT), 1e-12);
  }
}

/// A pose whose tip lies `beyond` (of the reach) outside the full stretch.
Pose stretchedBy(double beyond) {
  Pose X_WT = forward(omni(), Angles{0.3, 0.6, kPi / 2, 0.7, 0.8, 0.4});
  const Vec3 p_WB(0, 0.030, -0.176);
  X_WT.translation() += beyond * (X_WT.translation() - p_WB);
  return X_WT;
}

TEST(ClosedFormEdge, IsABillionthOfTheReachWide) {
  EXPECT_EQ(solveAll(omniArm(), stretchedBy(-1e-11)).exact, 8U);
  EXPECT_EQ(solveAll(omniArm(), stretchedBy(0.9e-9)).exact, 4U);
  const Solutions beyond = solveAll(omniArm(), stretchedBy(1.1e-9));
  EXPECT_EQ(beyond.exact, 0U);
  EXPECT_EQ(beyond.count, 4U);
}

TEST(ClosedFormEdge, BeyondItTheArmPointsThere) {  // no solution, but the nearest one could ask for
  const Pose X_WT = stretchedBy(0.5);
  const Solutions found = solveAll(omniArm(), X_WT);
  ASSERT_EQ(found.count, 4U);
  for (std::size_t i = 0; i < 4; ++i) {
    EXPECT_FALSE(found.all[i].exact);
    const Pose X = forward(omni(), found.all[i].q);
    EXPECT_LE(test::wayBetween(X, stretchedBy(0.0)), 1e-12);
    EXPECT_LE(test::turnBetween(X, X_WT), 1e-12);
  }
}

TEST(ClosedFormEdge, OnAxisOneJointOneIsZero) {
  // sin q3 such that the tip is above the shoulder.
  const double q2 = 1.0, q3 = std::asin(-0.127508 * std::cos(q2) / 0.149352) - q2;
  const Pose X_WT = forward(omni(), Angles{0.3, q2, q3, 0.7, 0.8, 0.4});
  const Solutions found = solveAll(omniArm(), X_WT);
  ASSERT_EQ(found.exact, 4U);
  for (std::size_t i = 0; i < 4; ++i) EXPECT_EQ(found.all[i].q[0], 0.0);
  EXPECT_LE(worst(omni(), found, X_WT), 1e-12);
}

TEST(ClosedFormEdge, OfThePumaLiesWhereItsShoulderOffsetIs) {
  const Chain chain = test::puma().chain();
  const SphericalWristArm puma = recognise(chain).value();
  // Upper arm and forearm chosen so that the wrist is straight above the offset: joint 1's two answers are one.
  const auto wristAt = [&](double off_axis_m) { return test::poseOf(Mat3::Identity(), Vec3(off_axis_m, 0, 0.6)); };
  EXPECT_EQ(solveAll(puma, wristAt(0.1502)).exact, 8U);
  EXPECT_EQ(solveAll(puma, wristAt(0.1501)).exact, 4U);
  EXPECT_LE(worst(chain, solveAll(puma, wristAt(0.1501)), wristAt(0.1501)), 1e-12);
  const Solutions inside = solveAll(puma, wristAt(0.1500));
  EXPECT_EQ(inside.exact, 0U);
  EXPECT_EQ(inside.count, 4U);
  EXPECT_EQ(solveAll(puma, wristAt(0.0)).exact, 0U);
  EXPECT_TRUE(finite(solveAll(puma, wristAt(0.0))));
}

TEST(ClosedFormEdge, WithEqualBonesTheTipMayLieInTheShoulder) {
  test::Arm arm = test::omni();
  arm.rows[2].a_m = arm.rows[3].d_m = 0.13335;
  const Chain chain = arm.chain();
  const Pose X_WT = forward(chain, Angles{0.3, 0.6, -kPi / 2, 0.7, 0.8, 0.4});
  const Solutions found = solveAll(recognise(chain).value(), X_WT);
  ASSERT_EQ(found.exact, 2U);
  EXPECT_EQ(found.all[0].q[1], 0.0);
  EXPECT_LE(worst(chain, found, X_WT), 1e-12);
}

TEST(ClosedFormEdge, WristOfLeaningAxesMayBeInLineToo) {  // axes 4 and 6 at 40 degrees to axis 5
  test::Arm arm = test::omni();
  arm.rows[4].alpha_rad = -40 * kRadPerDegree;
  arm.rows[5].alpha_rad = 40 * kRadPerDegree;
  const Chain chain = arm.chain();
  const SphericalWristArm leaning = recognise(chain).value();
  for (const double q5 : {0.0, 1e-9, 1e-6, 1e-3, 1.0, kPi}) {
    const Pose X_WT = forward(chain, Angles{0.3, 0.6, 0.2, 0.7, q5, 0.4});
    const Solutions found = solveAll(leaning, X_WT);
    EXPECT_GE(found.exact, q5 == 0.0 || q5 == kPi ? 1U : 2U) << q5;
    EXPECT_LE(worst(chain, found, X_WT), 1e-12) << q5;
  }
  const Mat3 aside = forward(chain, Angles{0.3, 0.6, 0.2}).linear() * test::about(Vec3::UnitX(), 2.0);
  const Pose beyond = test::poseOf(aside, forward(chain, Angles{0.3, 0.6, 0.2}).translation());
  const Solutions found = solveAll(leaning, beyond);
  EXPECT_TRUE(finite(found));
  EXPECT_GT(found.count, found.exact);  // more than 80 degrees from axis 4 axis 6 cannot lean
}

TEST(ClosedFormEdge, WristOfLeaningAxesHasAnEdgeOfItsOwn) {  // axis 6 as near to axis 4 as 60 and 40 degrees let it
  test::Arm arm = test::omni();
  arm.rows[4].alpha_rad = -40 * kRadPerDegree;
  arm.rows[5].alpha_rad = 60 * kRadPerDegree;
  const Chain chain = arm.chain();
  const SphericalWristArm leaning = recognise(chain).value();
  test::property::Random random({31});
  for (int draw = 0; draw < 200; ++draw) {
    Angles q{};
    for (double& angle_rad : q) angle_rad = random.between(-1.4, 1.4);
    q[4] = leaning.wrist.middle_rad;
    const Pose X_WT = forward(chain, q);
    const Solutions found = solveAll(leaning, X_WT);
    int same_arm = 0;
    for (std::size_t i = 0; i < found.exact; ++i) {
      const Angles& other = found.all[i].q;
      if (maxApart({other[0], other[1], other[2]}, {q[0], q[1], q[2]}) < 1e-6) ++same_arm;
    }
    ASSERT_EQ(same_arm, 1) << "draw " << draw;
    ASSERT_LE(worst(chain, found, X_WT), 1e-12);
  }
}

TEST(ClosedFormEdge, WhatIsNoPoseHasNoAnswers) {
  Pose X_WT = Pose::Identity();
  X_WT.translation().y() = kNotANumber;
  EXPECT_EQ(solveAll(omniArm(), X_WT).count, 0U);
  X_WT.translation().y() = 1e200;
  EXPECT_EQ(solveAll(omniArm(), X_WT).count, 0U);
  X_WT = Pose::Identity();
  X_WT.linear()(1, 1) = kNotANumber;
  EXPECT_EQ(solveAll(omniArm(), X_WT).count, 0U);
  X_WT.linear()(1, 1) = kInfinity;
  EXPECT_EQ(solveAll(omniArm(), X_WT).count, 0U);
}

TEST(ClosedFormEdge, IsNeverNaN) {
  test::property::Random random({30});
  for (const test::Arm& arm : test::arms()) {
    const SphericalWristArm known = recognise(arm.chain()).value();
    for (int draw = 0; draw < test::property::sweep(2000, 200000); ++draw) {
      const double scale = std::pow(10.0, random.between(-12, 3));
      ASSERT_TRUE(finite(solveAll(known, test::anyPose(random, scale)))) << arm.name << " draw " << draw;
    }
  }
}

}  // namespace
}  // namespace underact::chain
