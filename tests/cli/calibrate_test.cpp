#include <gtest/gtest.h>

#include "tests/cli/session.h"

namespace underact::test {
namespace {

using cli::Exit;
using json::Value;

Outcome calibrate(const std::string& scene, std::vector<std::string> more = {}) {
  std::vector<std::string> arguments{"calibrate", shipped(scene)};
  arguments.insert(arguments.end(), more.begin(), more.end());
  return runCli(arguments);
}

TEST(Calibrate, ASimulatedHandEndsWithAThresholdAndEveryTrial) {
  const Outcome outcome = calibrate("23_two_beams.json", {"--seed", "3", "--weber", "0.15"});
  ASSERT_EQ(outcome.exit, Exit::Success) << outcome.err;
  const Value result = lines(outcome.out).at(0);
  const double threshold = result.find("threshold")->number;
  EXPECT_GT(threshold, 0.03);  // 0.123 expected of many runs; one run scatters by a factor of 1.5
  EXPECT_LT(threshold, 0.5);
  EXPECT_LT(result.find("low")->number, threshold);
  EXPECT_GT(result.find("high")->number, threshold);
  EXPECT_NEAR(result.find("reference_N_per_mm")->number, 0.03, 1e-6);
  EXPECT_EQ(result.find("reversals")->items.size(), 10U);
  EXPECT_GT(result.find("trials")->items.size(), 15U);
  for (const Value& trial : result.find("trials")->items) {
    EXPECT_EQ(trial.find("right")->boolean, textAt(trial, "answer") == textAt(trial, "stiffer"));
  }
  EXPECT_EQ(calibrate("23_two_beams.json", {"--seed", "3", "--weber", "0.15"}).out, outcome.out);
}

TEST(Calibrate, AHandWithoutNoiseMeetsNothingThatItCannotTell) {
  const Outcome outcome = calibrate("23_two_beams.json", {"--weber", "0"});
  ASSERT_EQ(outcome.exit, Exit::Success) << outcome.err;
  EXPECT_TRUE(isNullAt(lines(outcome.out).at(0), "threshold"));
}

TEST(Calibrate, ASceneWithoutBeamsIsRefused) {
  const Outcome outcome = calibrate("02_sphere.json");
  EXPECT_EQ(outcome.exit, Exit::BadInput);
  EXPECT_TRUE(outcome.out.empty());
  EXPECT_NE(outcome.err.find("two beams"), std::string::npos) << outcome.err;
  EXPECT_EQ(runCli({"calibrate", "nowhere.json"}).exit, Exit::File);
}

}  // namespace
}  // namespace underact::test
