#include "core/stability/scene_trial.h"

#include <gtest/gtest.h>

#include "core/scene/load_meshes.h"
#include "core/scene/read.h"
#include "core/stability/exact.h"
#include "tests/support/property.h"

namespace underact::stability {
namespace {

SceneWall wallOf(const char* file) {
  SceneWall wall;
  wall.scene = scene::readSceneFile(std::string(UNDERACT_SOURCE) + "/scenes/" + file).value();
  return wall;
}

/// The same mass on a plain wall.
SampledWall plainWall(const SceneWall& scene) {
  SampledWall wall;
  wall.mass_kg = scene.mass_kg;
  wall.damping_N_s_per_m = scene.damping_N_s_per_m;
  wall.period_ns = 1'000'000'000 / scene.rate_hz;
  return wall;
}

TEST(SceneTrialResult, APlaneInTheWholeTickHasTheEigenvaluesLimit) {
  SceneWall wall = wallOf("04_plane.json");
  for (const int rate_hz : {500, 1000, 4000}) {
    if (rate_hz > 1000 && test::kIsWatched && !test::isSoak()) continue;  // eight times as many ticks as the first
    wall.rate_hz = rate_hz;
    const double exact = exactLimit(plainWall(wall)).value();
    EXPECT_NEAR(simulatedLimit(wall).value(), exact, 0.03 * exact) << rate_hz;  // 1 % of it is how far it halves
  }
}

TEST(SceneTrialResult, ARobotOfOneJointHoldsLikeAWallInItsPlane) {
  const SceneWall wall = wallOf("16_one_joint_robot.json");
  const double exact = exactLimit(plainWall(wall)).value();
  EXPECT_NEAR(simulatedLimit(wall).value(), exact, 0.15 * exact);  // its circle bends, and its turn is stiff, too
}

TEST(SceneTrialResult, DampingOfTheWallLetsItBeStiffer) {
  SceneWall wall = wallOf("23_two_beams.json");
  wall.constraint = "left beam";
  const double without = simulatedLimit(wall).value();
  wall.kd_N_s_per_m = 0.5;
  EXPECT_GT(simulatedLimit(wall).value(), 4.0 * without);
}

TEST(SceneTrialResult, ByItsJointsTheStylusBuzzesSooner) {
  SceneWall joints = wallOf("13_joint_space.json"), straight = joints;
  straight.scene.control.space = tick::Space::Cartesian;
  EXPECT_LT(simulatedLimit(joints).value(), 0.6 * simulatedLimit(straight).value());
}

TEST(SceneTrialResult, BeyondTheLimitItGrowsAndIsGivenEnergy) {
  const SceneWall wall = wallOf("16_one_joint_robot.json");
  const SceneTrialResult wild = tryScene(wall, 500.0).value();
  EXPECT_EQ(wild.trial.behaviour, Behaviour::Grows);
  EXPECT_FALSE(wild.is_passive);
  SceneWall damped = wall;
  damped.kd_N_s_per_m = 1.0;
  const SceneTrialResult calm = tryScene(damped, 500.0).value();
  EXPECT_EQ(calm.trial.behaviour, Behaviour::Rest);
  EXPECT_TRUE(calm.is_passive);
}

TEST(SceneTrialResult, WhereNothingHoldsThereIsNoLimit) {
  for (const char* file : {"20_scara.json", "22_out_of_reach.json"}) {
    const Result<double> limit = simulatedLimit(wallOf(file));
    ASSERT_FALSE(limit) << file;
    EXPECT_NE(limit.problems()[0].sentence.find("Nothing holds the tip there"), std::string::npos);
  }
}

TEST(SceneTrialResult, RefusesAWallAndAnUnnamedOneOfTwo) {
  EXPECT_FALSE(tryScene(wallOf("09_wall.json"), 100.0));      // a wall never pulls
  EXPECT_FALSE(tryScene(wallOf("19_four_bar.json"), 100.0));  // two, and none named
}

}  // namespace
}  // namespace underact::stability
