#include "core/calibration/trial.h"

#include <gtest/gtest.h>

#include "core/scene/compile.h"
#include "core/scene/read.h"

namespace underact::calibration {
namespace {

scene::Description shipped(const char* name) {
  return scene::readSceneFile(std::string(UNDERACT_SOURCE) + "/scenes/" + name).value();
}

double stiffnessOf(const scene::Description& scene, std::size_t index) {
  const auto& beam = std::get<scene::VirtualManipulator>(scene.constraints[index].shape);
  return beam.joints[0].stiffness;
}

}  // namespace

TEST(Trial, TheStifferBeamIsDrawnAndTheOtherIsTheReference) {
  std::uint64_t random = 7;
  int left = 0;
  for (int i = 0; i < 400; ++i) {
    const Trial trial = drawTrial(beginStaircase(), 0.03, random);
    left += trial.stiffer == Beam::Left ? 1 : 0;
    const double stiffer = trial.stiffer == Beam::Left ? trial.left_N_per_mm : trial.right_N_per_mm;
    const double other = trial.stiffer == Beam::Left ? trial.right_N_per_mm : trial.left_N_per_mm;
    ASSERT_DOUBLE_EQ(stiffer, 0.045);
    ASSERT_EQ(other, 0.03);
  }
  EXPECT_NEAR(left, 200, 40);  // 4 standard deviations of a fair coin
}

TEST(Trial, PutsItsStiffnessIntoTheSceneWhicheverBeamComesFirst) {
  const scene::Description scene = shipped("23_two_beams.json");
  EXPECT_NEAR(softerOf(scene).value(), 0.03, 1e-6);
  const scene::Description set = withStiffness(scene, {Beam::Right, 0.5, 0.04, 0.06}).value();
  EXPECT_NEAR(softerOf(set).value(), 0.04, 1e-15);
  EXPECT_NEAR(stiffnessOf(set, 1) / stiffnessOf(set, 0), 1.5, 1e-12);
  EXPECT_TRUE(scene::compile(set));
  scene::Description turned = scene;
  std::swap(turned.constraints[0], turned.constraints[1]);
  const scene::Description other = withStiffness(turned, {Beam::Right, 0.5, 0.04, 0.06}).value();
  EXPECT_EQ(stiffnessOf(other, 0), stiffnessOf(set, 1));
  EXPECT_LT(tipOf(turned, Beam::Left).x(), tipOf(turned, Beam::Right).x());
}

TEST(Trial, ASceneWithoutTwoBeamsIsRefusedInWords) {
  for (const char* name : {"02_sphere.json", "16_one_joint_robot.json", "19_four_bar.json"}) {
    const auto refused = withStiffness(shipped(name), {});
    ASSERT_FALSE(refused) << name;
    EXPECT_NE(refused.problems().at(0).sentence.find("two beams"), std::string::npos);
    EXPECT_FALSE(softerOf(shipped(name)));
  }
}

}  // namespace underact::calibration
