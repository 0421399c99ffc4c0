#include "core/tradeoff/choices.h"

#include <gtest/gtest.h>

#include <map>
#include <set>

#include "core/scene/read.h"

namespace underact::tradeoff {
namespace {

Bench benchOf(const char* scene, const char* hand, double seconds = 1.0) {
  return {scene::readSceneFile(std::string(UNDERACT_SOURCE) + "/scenes/" + scene + ".json").value(),
          sim::builtInHand(hand, 1).value(), seconds};
}

const Choice& choice(const char* key) {
  for (const Choice& one : choices()) {
    if (std::string(one.key) == key) return one;
  }
  ADD_FAILURE() << key;
  return choices()[0];
}

/// Error by option.
std::map<std::string, double> errorsOf(const char* key, const Bench& bench) {
  std::map<std::string, double> errors;
  const Settings base = settingsOf(bench.scene, 1000);
  const Measure measure = choice(key).measureOn(bench, base);
  for (const Option& option : choice(key).options) {
    Settings settings = base;
    option.choose(settings);
    const Result<Figures> figures = measure(settings);
    if (figures) errors[option.name] = figures.value().error;
  }
  return errors;
}

TEST(Choices, EachHasTheProgramsDefaultAmongItsOptionsAndNamesEachOnce) {
  std::set<std::string> keys;
  for (const Choice& one : choices()) {
    EXPECT_TRUE(keys.insert(one.key).second);
    EXPECT_TRUE(optionOf(one, Settings{}).has_value()) << one.key;
    std::set<std::string> names;
    for (const Option& option : one.options) EXPECT_TRUE(names.insert(option.name).second) << one.key;
    EXPECT_GE(names.size(), 2U);
  }
}

TEST(Choices, AnOptionIsFoundBySettings) {
  for (const Choice& one : choices()) {
    for (std::size_t index = 0; index < one.options.size(); ++index) {
      Settings settings;
      one.options[index].choose(settings);
      EXPECT_EQ(optionOf(one, settings), index) << one.key;
    }
  }
  Settings odd;
  odd.rate_hz = 1234;
  EXPECT_FALSE(optionOf(choice("rate"), odd).has_value());
}

TEST(Choices, TheSameErrorsComeOutEachTime) {
  const Bench bench = benchOf("12_line_pid", "tremor");
  for (const char* key : {"rate", "simulation", "velocity", "inverse"})
    EXPECT_EQ(errorsOf(key, bench), errorsOf(key, bench)) << key;
}

TEST(Choices, TwiceTheRateHalvesTheError) {
  std::map<std::string, double> errors = errorsOf("rate", benchOf("01_point", "sweep", 2.0));
  // A force that is held is late by half a period: first order. The oracle's own error takes a sixteenth at 1 kHz.
  EXPECT_NEAR(errors["500 Hz"] / errors["1000 Hz"], 2.0, 0.3);
  EXPECT_NEAR(errors["1000 Hz"] / errors["2000 Hz"], 2.0, 0.4);
  EXPECT_GT(errors["250 Hz"], 0.0);
}

TEST(Choices, TheIntegratorsAreOfTheirOrders) {
  std::map<std::string, double> errors = errorsOf("simulation", benchOf("05_circle", "stab"));
  EXPECT_NEAR(errors["mean velocity, 200 us"] / errors["mean velocity, 50 us"], 4.0, 0.6);  // first order
  EXPECT_NEAR(errors["end velocity, 200 us"] / errors["end velocity, 50 us"], 4.0, 0.6);
  EXPECT_LT(errors["trapezoidal, 200 us"], 0.3 * errors["mean velocity, 50 us"]);
  EXPECT_LT(errors["trapezoidal, 50 us"], errors["trapezoidal, 500 us"]);
}

TEST(Choices, MoreStepsFindTheJointsBetterAndTheClosedFormBest) {
  std::map<std::string, double> steps = errorsOf("steps", benchOf("19_four_bar", "stab", 2.0));
  EXPECT_GT(steps["1"], steps["3"]);
  EXPECT_GT(steps["3"], steps["20"]);
  EXPECT_EQ(steps["20"], steps["50"]);
  std::map<std::string, double> methods = errorsOf("solver", benchOf("18_sphere_of_two_joints", "sweep"));
  ASSERT_EQ(methods.size(), 2U);
  EXPECT_LT(methods["closed form"], 1e-11);
  EXPECT_LT(methods["iterative"], 1e-6);
  EXPECT_EQ(errorsOf("solver", benchOf("20_scara", "sweep")).count("closed form"), 0U);  // it has none
}

TEST(Choices, AFilterThatIsCalmIsLate) {
  std::map<std::string, double> calm = errorsOf("velocity", benchOf("12_line_pid", "still")),
                                quick = errorsOf("velocity", benchOf("12_line_pid", "stab"));
  EXPECT_LT(calm["low-pass, 5 ms"], 0.5 * calm["low-pass, 1.6 ms"]);
  EXPECT_GT(quick["low-pass, 5 ms"], 1.5 * quick["low-pass, 1.6 ms"]);
  EXPECT_GT(calm["raw"], 3.0 * calm["Kalman, 8 m/s^2"]);
}

TEST(Choices, TheArmsInverseIsExactInClosedFormAndConvergesByIteration) {
  std::map<std::string, double> errors = errorsOf("inverse", benchOf("02_sphere", "sweep"));
  EXPECT_LT(errors["closed form"], 1e-12);
  EXPECT_GT(errors["iterative, 1"], errors["iterative, 3"]);
  EXPECT_LT(errors["iterative, 60"], 1e-5);
}

TEST(Choices, WhatAHandNeverTouchesIsNotJudged) {
  const Bench bench = benchOf("09_wall", "still", 0.2);  // it is still on its way there
  const Settings own = settingsOf(bench.scene, 1000);
  EXPECT_FALSE(choice("velocity").measureOn(bench, own)(own));
}

TEST(Choices, ABlockOfARecordingIsWhatAKillLoses) {
  std::map<std::string, double> errors = errorsOf("blocks", benchOf("01_point", "still", 0.2));
  EXPECT_EQ(errors["100 ms"], 0.1);
  EXPECT_EQ(errors["10 ms"], 0.01);
}

}  // namespace
}  // namespace underact::tradeoff
