#include "core/chain/table_check.h"

#include "core/chain/chain.h"
#include "tests/core/chain/arms.h"

namespace underact::chain {
namespace {

constexpr double kRight = kPi / 2;

DhRow turning(double alpha_rad, double a_m, double d_m = 0.0) {
  return {JointType::Revolute, alpha_rad, a_m, 0.0, d_m};
}

TEST(TableCheck, EveryShippedArmIsPossibleAndOnlyThePumasLengthBelowZeroIsOdd) {
  for (const test::Arm& arm : {test::puma(), test::irb120()}) EXPECT_TRUE(tableErrors(arm.rows).empty());
  const Problems odd = tableWarnings(test::puma().rows);
  ASSERT_EQ(odd.size(), 1U);
  EXPECT_EQ(odd.front().place.line, 4);
  EXPECT_EQ(odd.front().place.key, "a_mm");
  EXPECT_TRUE(tableWarnings(test::irb120().rows).empty());
}

TEST(TableCheck, WhatIsSaidOfALengthBelowZeroIsTrue) {  // the same arm, with x the other way round
  std::vector<DhRow> rows{turning(0.3, 0.1, 0.05), turning(kRight, -0.02, 0.1), turning(-0.7, 0.2, -0.03)};
  rows[0].theta_rad = 0.4;
  const Pose X = chainFromDh(rows, Pose::Identity(), Pose::Identity()).X_WT_home;
  rows[0].theta_rad += kPi;
  rows[1].theta_rad += kPi;
  rows[1].a_m = -rows[1].a_m;
  rows[1].alpha_rad = -rows[1].alpha_rad;
  EXPECT_LE((chainFromDh(rows, Pose::Identity(), Pose::Identity()).X_WT_home.matrix() - X.matrix()).norm(), 1e-15);
}

TEST(TableCheck, EachImpossibleNumberIsSaidWithItsRow) {
  std::vector<DhRow> rows{turning(0.0, 0.1), turning(7.0, 0.1), turning(0.0, kInfinity, 2.0)};
  rows[2].min = 1.0;
  rows[2].max = 0.0;
  const Problems problems = tableErrors(rows);
  ASSERT_EQ(problems.size(), 4U);
  EXPECT_EQ(problems[0].place.key, "alpha_deg");
  EXPECT_EQ(problems[0].place.line, 2);
  EXPECT_EQ(problems[1].place.key, "a_mm");
  EXPECT_EQ(problems[2].place.key, "d_mm");
  EXPECT_EQ(problems[3].place.key, "min");
  EXPECT_EQ(problems[3].place.line, 3);
  EXPECT_EQ(tableErrors({}).size(), 1U);
  EXPECT_EQ(tableErrors(std::vector<DhRow>(kMaxJoints + 1)).size(), 1U);
  rows = {turning(std::nan(""), 0.1)};
  EXPECT_EQ(tableErrors(rows).size(), 1U);
}

TEST(TableCheck, JointsThatShareAnAxisAreSaid) {
  std::vector<DhRow> rows{turning(0.0, 0.0), turning(0.0, 0.0), turning(0.0, 0.1)};
  EXPECT_EQ(tableWarnings(rows).size(), 1U);
  EXPECT_EQ(tableWarnings(rows).front().place.line, 2);
  rows[1].alpha_rad = kPi;  // the axis the other way round is the same axis
  EXPECT_EQ(tableWarnings(rows).size(), 1U);
  rows[1].alpha_rad = kRight;
  EXPECT_TRUE(tableWarnings(rows).empty());
}

TEST(TableCheck, JointsThatSlideAlongOneDirectionAreSaidWhereverTheyStand) {
  std::vector<DhRow> rows{{JointType::Prismatic}, {JointType::Prismatic, 0.0, 0.2}};
  EXPECT_EQ(tableWarnings(rows).size(), 1U);
  rows[1].alpha_rad = kRight;
  EXPECT_TRUE(tableWarnings(rows).empty());
}

TEST(TableCheck, ATipThatNoJointMovesIsSaid) {
  EXPECT_EQ(tableWarnings(std::vector<DhRow>{turning(0.0, 0.0), turning(kRight, 0.0), turning(-kRight, 0.0)}).size(),
            1U);
  EXPECT_EQ(tableWarnings(std::vector<DhRow>{turning(0.0, 0.1, 0.2)}).size(), 1U);  // about its own axis
  EXPECT_TRUE(tableWarnings(std::vector<DhRow>{turning(0.0, 0.0), turning(kRight, 0.0, 0.1)}).empty());
  EXPECT_TRUE(tableWarnings(std::vector<DhRow>{turning(0.0, 0.0), turning(kRight, 0.0), turning(0.0, 0.1)}).empty());
}

}  // namespace
}  // namespace underact::chain
