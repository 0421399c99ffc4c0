#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>

#include "tests/cli/scene.h"
#include "tests/cli/session.h"
#include "tests/support/scratch_folder.h"

namespace underact::test {
namespace {

using cli::Exit;

TEST(LabStability, OneWallHasBothLimitsOfTheTable) {
  const Outcome outcome = runCli({"lab", "stability", "--mass_kg", "0.045", "--damping_N_s_per_m", "0.1",
                                  "--kd_N_s_per_m", "2", "--rate_hz", "4000", "--delay_ticks", "1", "--json"});
  ASSERT_EQ(outcome.exit, Exit::Success) << outcome.err;
  const json::Value cell = lines(outcome.out).at(0);
  EXPECT_NEAR(numberAt(cell, "exact_limit_N_per_m"), 5531.7, 0.1);
  EXPECT_NEAR(numberAt(cell, "simulated_limit_N_per_m"), 5531.7, 0.02 * 5531.7);
  EXPECT_NEAR(numberAt(cell, "gil_hulin_N_per_m"), 2.1 / 0.375e-3, 1e-6);
  EXPECT_EQ(numberAt(cell, "colgate_schenkel_N_per_m"), 0.0);
}

TEST(LabStability, OneStiffnessIsLabelled) {
  const auto labelAt = [](const std::string& stiffness, const std::string& friction) {
    const Outcome outcome = runCli({"lab", "stability", "--mass_kg", "0.045", "--damping_N_s_per_m", "0.1",
                                    "--friction_N", friction, "--stiffness_N_per_m", stiffness, "--json"});
    return textAt(lines(outcome.out).at(0), "label");
  };
  EXPECT_EQ(labelAt("500", "0"), "grows");
  EXPECT_EQ(labelAt("150", "0"), "rest");
  EXPECT_EQ(labelAt("500", "0.26"), "rest");  // which is what the arm's nominal stiffness stands on
}

TEST(LabStability, GivesNoExactLimitForANonlinearWall) {
  const Outcome outcome = runCli({"lab", "stability", "--friction_N", "0.26", "--json"});
  ASSERT_EQ(outcome.exit, Exit::Success) << outcome.err;
  EXPECT_TRUE(isNullAt(lines(outcome.out).at(0), "exact_limit_N_per_m"));
}

TEST(LabStability, AMapIsATableWithARowForEachDampingOfEachVariant) {
  const Outcome outcome = runCli({"lab", "stability", "--map", "hand", "--json"});
  ASSERT_EQ(outcome.exit, Exit::Success) << outcome.err;
  const std::vector<json::Value> rows = lines(outcome.out);
  EXPECT_EQ(rows.size(), 3U * 11U);
  for (const json::Value& row : rows) {
    EXPECT_EQ(textAt(row, "map"), "hand");
    const double exact = numberAt(row, "exact_N_per_m");
    EXPECT_NEAR(numberAt(row, "simulated_N_per_m"), exact, 0.02 * exact);
  }
}

TEST(LabStability, AFolderGetsTablesAndPictures) {
  const ScratchFolder scratch;
  const std::filesystem::path folder = scratch.path();
  const ProcessOutcome outcome = shell(program() + " lab stability --map delay --out " + folder.string() + " 2>&1");
  ASSERT_EQ(outcome.exit, 0) << outcome.out;
  for (const char* file : {"stability_limits.csv", "stability_labels.csv", "stability_delay.svg", "stability_delay.png",
                           "stability_delay_labels.svg", "stability_delay_labels.png"})
    EXPECT_GT(std::filesystem::file_size(folder / file), 1000U) << file;
}

TEST(LabStability, AScenesLimitIsFoundAndOneThatHoldsNothingIsLeftOut) {
  const Outcome outcome = runCli({"lab", "stability", "--map", "scenes", "--scenes", scene("04_plane"), "--json"});
  ASSERT_EQ(outcome.exit, Exit::Success) << outcome.err;
  const std::vector<json::Value> rows = lines(outcome.out);
  EXPECT_EQ(rows.size(), 4U * 6U);
  EXPECT_EQ(textAt(rows.at(0), "scene"), "04_plane");
  EXPECT_EQ(numberAt(rows.at(0), "rate_hz"), 500.0);
  EXPECT_NEAR(numberAt(rows.at(0), "simulated_N_per_m"), 100.0, 3.0);
  const Outcome nothing = runCli({"lab", "stability", "--map", "scenes", "--scenes", scene("20_scara")});
  EXPECT_EQ(nothing.exit, Exit::Success);
  EXPECT_TRUE(nothing.out.empty());
  EXPECT_NE(nothing.err.find("Nothing holds the tip there"), std::string::npos);
}

TEST(LabStability, RefusesUnknownWordsAndFiles) {
  EXPECT_EQ(runCli({"lab", "stability", "--map", "rates"}).exit, Exit::Usage);
  EXPECT_EQ(runCli({"lab", "stability", "--delay_ticks", "-1"}).exit, Exit::Usage);
  EXPECT_EQ(runCli({"lab", "stability", "--map", "scenes", "--scenes", "/dev/null/nowhere.json"}).exit, Exit::File);
}

}  // namespace
}  // namespace underact::test
