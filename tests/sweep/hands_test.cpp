#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <set>

#include "app/sweeper/catalogue.h"
#include "tests/cli/session.h"
#include "tests/sweep/rig.h"

namespace underact::test {
namespace {

/// A sweep of hands with what every hand file has by itself.
std::vector<std::string> defaultHands(std::vector<std::string> more) {
  std::vector<std::string> all{"hands", "--mass_kg", "0.1", "--damping_N_s_per_m", "4", "--stiffness_N_per_m", "300"};
  all.insert(all.end(), more.begin(), more.end());
  return all;
}

TEST(SweepOfHands, HasTheNumbersOfUnderactCliRunToTheBit) {
  const ScratchFolder folder;
  const std::string out = folder.file("r.csv");
  const std::vector<std::string> scenes{scene("02_sphere.json"), scene("12_line_pid.json"),
                                        scene("26_bumpy_sphere.json")};
  const Given given = sweepHere(defaultHands(
      {"--scene", scenes[0], scenes[1],   scenes[2], "--hand", "tremor", "stab",        "--rate_hz", "500",   "1000",
       "--draws", "2",       "--seconds", "0.7",     "--seed", "9",      "--arm-model", "ideal",     "--out", out}));
  ASSERT_EQ(given.exit, cli::Exit::Success) << given.err;
  const Table rows = table(out);
  ASSERT_EQ(rows.size(), 1U + 3 * 2 * 2 * 2);
  for (std::size_t row = 1; row < rows.size(); ++row) {
    const Outcome run = runCli({"run", field(rows, row, "scene"), "--hand", field(rows, row, "hand"), "--rate",
                                field(rows, row, "rate_hz"), "--seed", field(rows, row, "seed"), "--seconds", "0.7",
                                "--arm-model", "ideal", "--fast"});
    ASSERT_EQ(run.exit, cli::Exit::Success) << run.err;
    const json::Value object = lines(run.out).at(0);
    for (const char* key :
         {"ticks", "peak_force_N", "rms_error_mm", "clamped_ticks", "work_mJ", "most_work_mJ", "rate_hz", "seed"}) {
      EXPECT_EQ(number(rows, row, key), numberAt(object, key)) << key << " of row " << row;
    }
    EXPECT_EQ(field(rows, row, "faults"), "0");
    EXPECT_EQ(field(rows, row, "first_fault"), "none");
  }
}

TEST(SweepOfHands, HasEachSceneHandAndRateWithAllItsDraws) {
  const ScratchFolder folder;
  const std::string out = folder.file("r.csv");
  const Given given =
      sweepHere({"hands", "--scene", scene("01_point.json"), scene("02_sphere.json"), "--hand", "still", "tremor",
                 "--rate_hz", "500", "1000", "--draws", "3", "--seconds", "0.02", "--out", out});
  ASSERT_EQ(given.exit, cli::Exit::Success) << given.err;
  const Table rows = table(out);
  std::set<std::string> combinations;
  for (std::size_t row = 1; row < rows.size(); ++row) {
    std::string combination;
    for (const char* column : {"scene", "hand", "rate_hz", "draw"}) combination += field(rows, row, column) + " ";
    combinations.insert(combination);
    EXPECT_EQ(field(rows, row, "cell"), std::to_string(row - 1));
    EXPECT_EQ(number(rows, row, "ticks"), 0.02 * number(rows, row, "rate_hz"));
  }
  EXPECT_EQ(combinations.size(), 24U);
}

TEST(SweepOfHands, DrawsEachHandFromTheRangesAnew) {
  const ScratchFolder folder;
  const std::string out = folder.file("r.csv");
  const Given given =
      sweepHere({"hands", "--scene", scene("02_sphere.json"), "--draws", "200", "--seconds", "0.001", "--mass_kg",
                 "0.1:0.3", "--damping_N_s_per_m", "5", "--stiffness_N_per_m", "0:1000", "--out", out});
  ASSERT_EQ(given.exit, cli::Exit::Success) << given.err;
  const Table rows = table(out);
  std::set<double> masses;
  double sum_kg = 0.0, together = 0.0;
  for (std::size_t row = 1; row < rows.size(); ++row) {
    const double mass_kg = number(rows, row, "mass_kg"), stiffness = number(rows, row, "stiffness_N_per_m");
    EXPECT_TRUE(mass_kg >= 0.1 && mass_kg <= 0.3);
    EXPECT_TRUE(stiffness >= 0.0 && stiffness <= 1000.0);
    EXPECT_EQ(number(rows, row, "damping_N_s_per_m"), 5.0);
    masses.insert(mass_kg);
    sum_kg += mass_kg;
    together += (mass_kg - 0.2) / 0.1 * (stiffness - 500.0) / 500.0;
  }
  EXPECT_EQ(masses.size(), 200U);
  // Of even draws on (-1, 1): the mean's sigma is 1 / sqrt(3 n), that of the mean of products 1 / (3 sqrt(n)).
  EXPECT_NEAR((sum_kg / 200 - 0.2) / 0.1, 0.0, 5.0 / std::sqrt(3.0 * 200));
  EXPECT_NEAR(together / 200, 0.0, 5.0 / (3.0 * std::sqrt(200.0))) << "mass and stiffness are drawn together";
}

TEST(SweepOfHands, HasForceAndEnergyOfTheTicks) {  // against every tick of the same run, written by the other program
  const ScratchFolder folder;
  const std::string out = folder.file("r.csv"), ticks = folder.file("ticks.csv");
  ASSERT_EQ(sweepHere(defaultHands({"--scene", scene("02_sphere.json"), "--hand", "stab", "--draws", "1", "--seconds",
                                    "1.5", "--out", out}))
                .exit,
            cli::Exit::Success);
  const Table rows = table(out);
  ASSERT_EQ(runCli({"run", scene("02_sphere.json"), "--hand", "stab", "--seed", field(rows, 1, "seed"), "--seconds",
                    "1.5", "--fast", "--record", ticks})
                .exit,
            cli::Exit::Success);
  const Table all = table(ticks);
  double sum_N2 = 0.0, lowest_mJ = 0.0, last_mJ = 0.0;
  for (std::size_t row = 1; row < all.size(); ++row) {
    for (const char* axis : {"x", "y", "z"})
      sum_N2 += std::pow(number(all, row, std::string("force_sent_") + axis + "_N"), 2);
    last_mJ = number(all, row, "energy_mJ");
    lowest_mJ = std::min(lowest_mJ, last_mJ);
  }
  const double rms_N = std::sqrt(sum_N2 / static_cast<double>(all.size() - 1));
  EXPECT_GT(rms_N, 0.1);
  EXPECT_NEAR(number(rows, 1, "rms_force_N"), rms_N, 1e-12) << "another order of the same squares";
  EXPECT_DOUBLE_EQ(number(rows, 1, "energy_mJ"), last_mJ);
  EXPECT_DOUBLE_EQ(number(rows, 1, "lowest_energy_mJ"), lowest_mJ);
}

/// Every column of each row against what the printed command of its cell says.
TEST(SweepOfHands, ARowIsRunAgainByThePrintedCommandToTheBit) {
  const ScratchFolder folder;
  const std::string out = folder.file("r.csv"), drawn = folder.file("hand.json");
  std::ofstream(drawn)
      << R"({"underact_hand": 1, "path": [{"t_s": 0, "p_mm": [0, 0, 70]}, {"t_s": 0.4, "p_mm": [9, 8, 40]}]})";
  const std::vector<std::string> wanted{"hands",
                                        "--scene",
                                        scene("02_sphere.json"),
                                        scene("12_line_pid.json"),
                                        "--hand",
                                        "tremor",
                                        "stab",
                                        drawn,
                                        "--draws",
                                        "2",
                                        "--seconds",
                                        "0.6",
                                        "--seed",
                                        "5"};
  std::vector<std::string> all = wanted, print = wanted;
  all.insert(all.end(), {"--out", out});
  print.emplace_back("--print");
  ASSERT_EQ(sweepHere(all).exit, cli::Exit::Success);
  const Given given = sweepHere(print);
  ASSERT_EQ(given.exit, cli::Exit::Success) << given.err;
  const Table rows = table(out);
  ASSERT_EQ(rows.size(), 1U + 12);
  const std::vector<std::string> commands = linesOf(given.out);
  ASSERT_EQ(commands.size(), 12U);
  std::set<std::string> masses;
  for (std::size_t row = 1; row < rows.size(); ++row) {
    const std::string& command = commands[row - 1];
    EXPECT_EQ(command.rfind("underact-cli run ", 0), 0U) << command;
    const Outcome run = runCli(argumentsOf(command));
    ASSERT_EQ(run.exit, cli::Exit::Success) << command << run.err;
    const json::Value object = lines(run.out).at(0);
    for (const char* key : {"ticks", "peak_force_N", "rms_force_N", "rms_error_mm", "clamped_ticks", "work_mJ",
                            "most_work_mJ", "energy_mJ", "lowest_energy_mJ", "rate_hz", "seed"}) {
      EXPECT_EQ(number(rows, row, key), numberAt(object, key)) << key << " of row " << row;
    }
    masses.insert(field(rows, row, "mass_kg"));
  }
  EXPECT_EQ(masses.size(), 12U) << "each row has a hand of its own";
}

TEST(SweepOfHands, PrintsTheCommandOfOneCell) {
  const std::vector<std::string> wanted{"hands", "--scene", scene("02_sphere.json"), "--draws", "3", "--print"};
  const auto printed = [&wanted](const std::string& cell) {
    std::vector<std::string> words = wanted;
    words.insert(words.end(), {"--cell", cell});
    return sweepHere(words);
  };
  const std::string all = sweepHere(wanted).out;
  EXPECT_EQ(all, printed("0").out + printed("1").out + printed("2").out);
  EXPECT_EQ(std::count(all.begin(), all.end(), '\n'), 3);
  EXPECT_EQ(printed("3").exit, cli::Exit::Usage);
  EXPECT_NE(printed("3").err.find("the last one is number 2"), std::string::npos);
  EXPECT_EQ(sweepHere({"hands", "--scene", scene("02_sphere.json"), "--cell", "1", "--out", "x.csv"}).exit,
            cli::Exit::Usage)
      << "--cell is for --print alone";
}

TEST(SweepOfHands, PairedConditionsHaveTheSameHands) {
  const ScratchFolder folder;
  const std::string out = folder.file("r.csv");
  const Given given =
      sweepHere({"hands", "--scene", scene("01_point.json"), scene("02_sphere.json"), "--hand", "tremor", "stab",
                 "--draws", "3", "--seconds", "0.02", "--paired", "yes", "--out", out});
  ASSERT_EQ(given.exit, cli::Exit::Success) << given.err;
  const Table rows = table(out);
  ASSERT_EQ(rows.size(), 1U + 12);
  std::set<std::string> seeds;
  for (std::size_t row = 1; row < rows.size(); ++row) {
    const std::size_t of_first = 1 + (row - 1) % 3;  // the same draw in the first condition
    EXPECT_EQ(field(rows, row, "draw"), field(rows, of_first, "draw"));
    for (const char* key : {"seed", "mass_kg", "damping_N_s_per_m", "stiffness_N_per_m"})
      EXPECT_EQ(field(rows, row, key), field(rows, of_first, key)) << key << " of row " << row;
    seeds.insert(field(rows, row, "seed"));
  }
  EXPECT_EQ(seeds.size(), 3U);
  const Given wrong = sweepHere({"hands", "--scene", scene("01_point.json"), "--paired", "maybe", "--out", out});
  EXPECT_EQ(wrong.exit, cli::Exit::Usage);
  EXPECT_NE(wrong.err.find("--paired"), std::string::npos) << wrong.err;
}

TEST(SweepOfHands, RefusesWhatItCannotRunAndSaysAllOfIt) {
  const Given given = sweepHere({"hands", "--scene", "none.json", "--hand", "waving", "--rate_hz", "50", "--draws", "0",
                                 "--arm-model", "heavy", "--mass_kg", "0", "--out", "x.csv"});
  for (const char* words : {"none.json", "There is no hand \"waving\"", "--rate_hz", "--draws", "--arm-model",
                            "--mass_kg", "\"vendor-nominal\" or \"ideal\""}) {
    EXPECT_NE(given.err.find(words), std::string::npos) << words << " in\n" << given.err;
  }
  EXPECT_EQ(given.exit, cli::Exit::File);
  EXPECT_FALSE(std::filesystem::exists("x.csv.part"));
}

}  // namespace
}  // namespace underact::test
