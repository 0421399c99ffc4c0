#include "app/gui/model/numbered_solutions.h"

#include <gtest/gtest.h>

#include <cmath>
#include <set>

#include "core/arm/forward.h"
#include "core/base/units.h"
#include "core/chain/kinematics.h"
#include "tests/support/random.h"

namespace underact::gui {
namespace {

using underact::test::Random;
using underact::test::Seed;

/// Joints near those at rest, so that the pose is one in the middle of the workspace.
arm::JointAngles near(const arm::Preset& preset, Random& random) {
  if (arm::solvesInTick(preset.geometry)) return {0.1, 0.6, 0.3, 0.4, 1.1, 0.5};
  arm::JointAngles q = preset.geometry.mechanism->rest;
  const std::vector<chain::Joint>& joints = preset.geometry.mechanism->chain.joints;
  for (std::size_t joint = 0; joint < joints.size(); ++joint)
    q[joint] += random.between(-1.0, 1.0) * (joints[joint].type == chain::JointType::Prismatic ? 0.02 : 0.3);
  return q;
}

std::size_t maxOf(const std::string& arm) {
  Random random(Seed{7});
  const arm::Preset& preset = *arm::findPreset(arm);
  const SolutionFinder finder(*arm::findModel(arm));
  std::size_t max = 0;
  for (int draw = 0; draw < 20; ++draw)
    max = std::max(max, finder.at(arm::tipPose(preset.geometry, near(preset, random))).all.size());
  return max;
}

}  // namespace

TEST(NumberedSolutions, EachReachesThePoseAndHasANumberOfItsOwn) {
  Random random(Seed{20261126});
  for (const arm::Preset& preset : arm::sceneArms()) {
    const arm::Model& model = *arm::findModel(preset.name);
    const SolutionFinder finder(model);
    for (int draw = 0; draw < 20; ++draw) {
      const arm::JointAngles q = near(preset, random);
      const Pose X_WT = arm::tipPose(preset.geometry, q);
      const NumberedSolutions found = finder.at(X_WT);
      ASSERT_FALSE(found.all.empty()) << preset.name;
      std::set<int> numbers;
      bool has_arm = false;
      for (const NumberedSolution& one : found.all) {
        const Pose X_WS = chain::forward(model.chain, one.q);
        ASSERT_LT((X_WS.translation() - X_WT.translation()).norm(), 2e-9) << preset.name;
        ASSERT_TRUE(numbers.insert(one.number).second) << preset.name;
        ASSERT_GE(one.number, 1);
        ASSERT_LE(one.number, kMaxSolutions);
        ASSERT_EQ(found.find(one.number), &one);
        double apart = 0.0;
        for (std::size_t joint = 0; joint < model.rows.size(); ++joint)
          apart = std::max(apart, std::abs(std::remainder(one.q[joint] - q[joint], 2.0 * kPi)));
        has_arm |= apart < 1e-6;
      }
      EXPECT_EQ(found.find(0), nullptr);
      if (!found.is_searched) {
        EXPECT_TRUE(has_arm) << preset.name;
      }
    }
  }
}

TEST(NumberedSolutions, AreAsManyAsTheGeometryHas) {
  EXPECT_EQ(maxOf("ur5e"), 8U);
  EXPECT_EQ(maxOf("ur10e"), 8U);
  EXPECT_EQ(maxOf("puma-560"), 8U);
  EXPECT_EQ(maxOf("abb-irb-120"), 8U);
  EXPECT_EQ(maxOf("cobra-600"), 2U);
  EXPECT_EQ(maxOf("planar-3"), 2U);
  EXPECT_GT(maxOf("panda"), 4U);
}

TEST(NumberedSolutions, OfABranchKeepTheirNumberWhicheverOthersThereAre) {
  Random random(Seed{3});
  const arm::Preset& preset = *arm::findPreset("ur5e");
  const SolutionFinder finder(*arm::findModel("ur5e"));
  for (int draw = 0; draw < 200; ++draw) {
    arm::JointAngles q{};
    for (std::size_t joint = 0; joint < 6; ++joint) q[joint] = random.between(-3.1, 3.1);
    for (const NumberedSolution& one : finder.at(arm::tipPose(preset.geometry, q)).all) {
      const auto sign = [&](std::size_t index) { return static_cast<std::int8_t>(one.branch[index].choice); };
      ASSERT_EQ(one.number, numberOf(arm::Branch{sign(0), sign(1), sign(2)}));
    }
  }
}

TEST(NumberedSolutions, OfAnArmWithJointsToSpareAreSearchedAndEachHasANullSpace) {
  const arm::Preset& preset = *arm::findPreset("panda");
  const SolutionFinder finder(*arm::findModel("panda"));
  const Pose X_WT = arm::tipPose(preset.geometry, preset.geometry.mechanism->rest);
  const NumberedSolutions found = finder.at(X_WT), again = finder.at(X_WT);
  EXPECT_TRUE(found.is_searched);
  EXPECT_TRUE(found.has_surplus);
  ASSERT_EQ(found.all.size(), again.all.size());
  for (std::size_t index = 0; index < found.all.size(); ++index) {
    EXPECT_EQ(found.all[index].q, again.all[index].q) << "the search draws the same";
    ASSERT_EQ(found.all[index].null_space.size(), 1U);
    EXPECT_EQ(found.all[index].null_space[0].size(), 7U);
  }
}

}  // namespace underact::gui
