#include <gtest/gtest.h>

#include "tests/cli/session.h"

namespace underact::test {
namespace {

using cli::Exit;

constexpr const char* kSphereScene = UNDERACT_SOURCE "/scenes/02_sphere.json";

TEST(LabExtremes, PrintsTheLimitsOfASceneAsATableOrAnObject) {
  const Outcome table = runCli({"lab", "extremes", kSphereScene, "--poses", "50"});
  ASSERT_EQ(table.exit, Exit::Success) << table.err;
  for (const char* line :
       {"greatest force that the scene asks for", "by an encoder step", "by the last bit of an angle", " of 50\n",
        "a tick on this machine: median ", " % of a period at 1000 Hz"})
    EXPECT_NE(table.out.find(line), std::string::npos) << line << table.out;
  const Outcome object = runCli({"lab", "extremes", kSphereScene, "--poses", "50", "--json"});
  ASSERT_EQ(object.exit, Exit::Success) << object.err;
  const json::Value limits = lines(object.out).at(0);
  EXPECT_EQ(numberAt(limits, "poses"), 50);
  EXPECT_GT(numberAt(limits, "force_N"), numberAt(limits, "per_encoder_step_N"));
  EXPECT_GT(numberAt(limits, "per_encoder_step_N"), numberAt(limits, "per_ulp_N"));
  EXPECT_GT(numberAt(limits, "tick_p99_us"), 0.0);
  EXPECT_LT(vectorAt(limits, "force_N_at_mm").norm(), 400.0);
}

TEST(LabExtremes, NeedsASceneThatCanBeRead) {
  EXPECT_EQ(runCli({"lab", "extremes"}).exit, Exit::Usage);
  EXPECT_EQ(runCli({"lab", "extremes", "nowhere.json"}).exit, Exit::File);
}

}  // namespace
}  // namespace underact::test
