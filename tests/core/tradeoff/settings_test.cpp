#include "core/tradeoff/settings.h"

#include <gtest/gtest.h>

#include "core/scene/compile.h"
#include "tests/core/tradeoff/shipped.h"

namespace underact::tradeoff {
namespace {

Settings others() {
  Settings settings;
  settings.rate_hz = 4000;
  settings.search = Search::Global;
  settings.solver = {scene::SolverMethod::Iterative, 3, 1e-8};
  settings.velocity = scene::LowPassFilter{5.0};
  settings.simulation = {Integrator::MeanVelocity, 25.0};
  return settings;
}

TEST(Settings, WhatASceneHasUseForIsPutIntoItAndReadBack) {
  for (const char* name : {"12_line_pid", "18_sphere_of_two_joints", "19_four_bar", "28_trefoil_path", "02_sphere"}) {
    const scene::Description scene = test::shipped(name), changed = withSettings(scene, others());
    const Settings read = settingsOf(changed, 4000);
    EXPECT_EQ(read.simulation, others().simulation) << name;
    EXPECT_TRUE(!hasSearch(scene) || read.search == others().search) << name;
    EXPECT_TRUE(!hasSolver(scene) || read.solver == others().solver) << name;
    EXPECT_TRUE(!hasVelocity(scene) || read.velocity == others().velocity) << name;
    EXPECT_TRUE(differences(scene, read, settingsOf(withSettings(changed, read), 4000)).empty()) << name;
  }
}

TEST(Settings, AScenesOwnAreTheProgramsWhereItSaysNothing) {
  for (const char* name : {"01_point", "16_one_joint_robot", "02_sphere"})
    EXPECT_EQ(settingsOf(test::shipped(name), 1000), Settings{}) << name;
}

TEST(Settings, OnlyWhatTheSceneHasIsToldAsADifference) {
  const auto told = [](const char* name) {
    std::string words;
    for (const Difference& one : differences(test::shipped(name), Settings{}, others()))
      words += one.what + ": " + one.before + " -> " + one.after + "\n";
    return words;
  };
  EXPECT_EQ(told("02_sphere"),
            "servo rate: 1000 Hz -> 4000 Hz\n"
            "simulated arm: trapezoidal, 200 us -> mean_velocity, 25 us\n");
  EXPECT_EQ(told("28_trefoil_path"),
            "servo rate: 1000 Hz -> 4000 Hz\n"
            "search: hybrid -> global\n"
            "velocity filter: kalman, noise_mm 0.016, acceleration_mm_per_s2 8000 -> low_pass, time_constant_ms 5\n"
            "simulated arm: trapezoidal, 200 us -> mean_velocity, 25 us\n");
  EXPECT_NE(told("18_sphere_of_two_joints").find("solver: closed form where there is one, else 20 steps -> 3 steps\n"),
            std::string::npos);
}

TEST(Settings, AWallOfAMeshIsNotSought) {
  EXPECT_FALSE(hasSearch(test::shipped("27_bracket")));
  EXPECT_TRUE(hasSearch(test::shipped("28_trefoil_path")));
  EXPECT_FALSE(hasSearch(test::shipped("02_sphere")));
}

TEST(Settings, TheThesissForceLawHasNoSolver) {
  EXPECT_FALSE(hasSolver(test::shipped("17_thesis_force_law")));
  EXPECT_TRUE(hasSolver(test::shipped("16_one_joint_robot")));
}

}  // namespace
}  // namespace underact::tradeoff
