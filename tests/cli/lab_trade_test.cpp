#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <set>

#include "tests/cli/scene.h"
#include "tests/cli/session.h"
#include "tests/support/scratch_folder.h"

namespace underact::test {
namespace {

using cli::Exit;

TEST(LabTrade, TellsEachOptionsCostAndErrorAndMarksTheDefault) {
  const Outcome outcome = runCli({"lab", "trade", "--scenes", scene("12_line_pid"), "--hands", "tremor,stab",
                                  "--choices", "velocity,blocks", "--seconds", "1", "--json"});
  ASSERT_EQ(outcome.exit, Exit::Success) << outcome.err;
  int defaults = 0;
  std::set<std::string> options;
  for (const json::Value& row : lines(outcome.out)) {
    options.insert(textAt(row, "choice") + ", " + textAt(row, "option"));
    EXPECT_GT(numberAt(row, "p50_ns"), 0.0);
    EXPECT_LE(numberAt(row, "p50_ns"), numberAt(row, "p99_ns"));
    EXPECT_GT(numberAt(row, "error"), 0.0);
    EXPECT_EQ(numberAt(row, "runs"), 2.0);
    if (!row.find("default")->boolean) continue;
    ++defaults;
    EXPECT_TRUE(textAt(row, "option") == "Kalman, 8 m/s^2" || textAt(row, "option") == "100 ms");
  }
  EXPECT_EQ(defaults, 2);
  EXPECT_EQ(options.size(), 16U);
}

TEST(LabTrade, TellsTheRunsAndTheFronts) {
  const Outcome rows = runCli({"lab", "trade", "--scenes", scene("18_sphere_of_two_joints"), "--hands", "sweep",
                               "--choices", "solver", "--seconds", "0.5", "--table", "rows"});
  ASSERT_EQ(rows.exit, Exit::Success) << rows.err;
  EXPECT_EQ(rows.out.substr(0, rows.out.find('\n')),
            "scene,hand,choice,option,p50_ns,p99_ns,us_per_s,error,worst,unit,default");
  EXPECT_NE(rows.out.find("18_sphere_of_two_joints,sweep,solver,closed form,"), std::string::npos);
  const Outcome fronts = runCli({"lab", "trade", "--scenes", scene("05_circle"), "--hands", "stab", "--seconds", "0.6",
                                 "--table", "fronts", "--json"});
  ASSERT_EQ(fronts.exit, Exit::Success) << fronts.err;
  int on_front = 0, own = 0;
  for (const json::Value& row : lines(fronts.out)) {
    on_front += row.find("on_front")->boolean ? 1 : 0;
    own += row.find("own")->boolean ? 1 : 0;
  }
  EXPECT_GE(on_front, 3);
  EXPECT_EQ(own, 1);
}

TEST(LabTrade, AFolderGetsTablesAndPictures) {
  const ScratchFolder scratch;
  const std::filesystem::path folder = scratch.path();
  const ProcessOutcome outcome = shell(program() + " lab trade --scenes " + scene("05_circle") +
                                       " --hands stab --seconds 0.6 --out " + folder.string() + " 2>&1");
  ASSERT_EQ(outcome.exit, 0) << outcome.out;
  for (const char* file : {"trade_choices.csv", "trade_rows.csv", "trade_fronts.csv", "trade_choices.svg",
                           "trade_choices.png", "trade_fronts.svg", "trade_fronts.png"})
    EXPECT_GT(std::filesystem::file_size(folder / file), 1000U) << file;
}

TEST(LabTrade, WhereNothingCanBeMeasuredItSaysSoAndLeavesTheFolderAlone) {
  const ScratchFolder scratch;
  const std::filesystem::path folder = scratch.path(), old = folder / "trade_choices.csv";
  std::ofstream(old) << "of another day\n";
  for (const std::vector<std::string>& to :
       {std::vector<std::string>{"--out", folder.string()}, std::vector<std::string>{}}) {
    std::vector<std::string> words{"lab",    "trade",   "--scenes", scene("05_circle"), "--choices",
                                   "search", "--hands", "still",    "--seconds",        "0.2"};
    words.insert(words.end(), to.begin(), to.end());
    const Outcome outcome = runCli(words);
    EXPECT_EQ(outcome.exit, Exit::BadInput);
    EXPECT_EQ(outcome.out, "");
    EXPECT_EQ(outcome.err.find("Nothing could be measured: "), 0U) << outcome.err;
    EXPECT_EQ(std::count(outcome.err.begin(), outcome.err.end(), '\n'), 1);
  }
  EXPECT_EQ(std::filesystem::file_size(old), 15U);
  const auto is_one = [](const auto& files) { return std::distance(begin(files), end(files)) == 1; };
  EXPECT_TRUE(is_one(std::filesystem::directory_iterator(folder)));
}

TEST(LabTrade, WhereEveryRunEndsInAFaultThereIsNoFrontButWhatElseCanBeMeasured) {
  const ScratchFile leap(  // 0.1 m in 5 ms
      R"({"underact_hand": 1, "hand": {"mass_kg": 0.01, "damping_N_s_per_m": 1000, "stiffness_N_per_m": 1e6},
          "path": [{"t_s": 0, "p_mm": [-50, 0, 50]}, {"t_s": 0.1, "p_mm": [-50, 0, 50]},
                   {"t_s": 0.105, "p_mm": [50, 0, 50]}]})",
      "leap.json");
  const auto tradeOf = [&](const std::vector<std::string>& more) {
    std::vector<std::string> words{"lab",       "trade",     "--scenes",     scene("05_circle"), "--hands",
                                   leap.path(), "--choices", "rate,inverse", "--seconds",        "0.2"};
    words.insert(words.end(), more.begin(), more.end());
    return runCli(words);
  };
  const ScratchFolder scratch;
  const std::filesystem::path made = std::filesystem::path(scratch.path()) / "made";
  for (const Outcome& outcome : {tradeOf({"--table", "fronts"}), tradeOf({"--out", made.string()})}) {
    EXPECT_EQ(outcome.exit, Exit::BadInput);
    EXPECT_EQ(outcome.out, "");
    EXPECT_EQ(outcome.err.find("No scene has a front: "), 0U) << outcome.err;
  }
  EXPECT_FALSE(std::filesystem::exists(made));
  const Outcome choices = tradeOf({"--json"});
  ASSERT_EQ(choices.exit, Exit::Success) << choices.err;
  for (const json::Value& row : lines(choices.out)) EXPECT_EQ(textAt(row, "choice"), "inverse");
  EXPECT_EQ(lines(choices.out).size(), 6U);
}

TEST(LabTrade, RefusesUnknownWordsAndFiles) {
  EXPECT_EQ(runCli({"lab", "trade", "--choices", "rates"}).exit, Exit::Usage);
  EXPECT_EQ(runCli({"lab", "trade", "--hands", "swep", "--scenes", scene("01_point")}).exit, Exit::Usage);
  EXPECT_EQ(runCli({"lab", "trade", "--scenes", "/dev/null/nowhere.json"}).exit, Exit::File);
}

TEST(LabModel, TellsWhatASceneRequiresAndWhatItSaves) {
  const Outcome outcome =
      runCli({"lab", "model", scene("01_point"), scene("14_circle_influence"), "--seconds", "0.2", "--json"});
  ASSERT_EQ(outcome.exit, Exit::Success) << outcome.err;
  const std::vector<json::Value> rows = lines(outcome.out);
  ASSERT_EQ(rows.size(), 2U * 11U);
  const auto rowOf = [&](const std::string& name, const std::string& quantity) -> const json::Value& {
    return *std::find_if(rows.begin(), rows.end(), [&](const json::Value& row) {
      return textAt(row, "scene") == name && textAt(row, "quantity") == quantity;
    });
  };
  EXPECT_FALSE(rowOf("01_point", "orientation").find("required")->boolean);
  EXPECT_TRUE(isNullAt(rowOf("01_point", "influence"), "ns"));
  EXPECT_TRUE(rowOf("14_circle_influence", "orientation").find("required")->boolean);
  for (const char* name : {"01_point", "14_circle_influence"}) {
    const double all = numberAt(rowOf(name, "everything"), "ns"), own = numberAt(rowOf(name, "as_it_is"), "ns");
    EXPECT_DOUBLE_EQ(numberAt(rowOf(name, "saved"), "ns"), all - own);
    EXPECT_GT(all, 0.0);
  }
}

}  // namespace
}  // namespace underact::test
