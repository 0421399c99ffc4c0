#include <gtest/gtest.h>

#include <cmath>

#include "core/stability/maps.h"
#include "tests/cli/session.h"
#include "tests/sweep/rig.h"

namespace underact::test {
namespace {

TEST(SweepOfWalls, HasTheCellsOfAMapAsTheLabHasThem) {
  const ScratchFolder folder;
  const std::string out = folder.file("r.csv");
  const Given given = sweepHere({"stability", "--map", "delay", "--threads", "2", "--out", out});
  ASSERT_EQ(given.exit, cli::Exit::Success) << given.err;
  const Table rows = table(out);
  const stability::WallMap* map = nullptr;
  for (const stability::WallMap& one : stability::wallMaps()) {
    if (std::string(one.key) == "delay") map = &one;
  }
  ASSERT_NE(map, nullptr);
  const auto dampings = stability::mapDampings_N_s_per_m();
  ASSERT_EQ(rows.size(), 1 + map->variants.size() * dampings.size());
  for (std::size_t row = 1; row < rows.size(); row += 7) {
    stability::SampledWall wall = map->variants[(row - 1) / dampings.size()].wall;
    wall.kd_N_s_per_m = dampings[(row - 1) % dampings.size()];
    EXPECT_EQ(field(rows, row, "variant"), map->variants[(row - 1) / dampings.size()].name);
    const stability::Limits limits = stability::limitsOf(wall);
    EXPECT_EQ(number(rows, row, "simulated_N_per_m"), limits.simulated_N_per_m);
    EXPECT_EQ(number(rows, row, "exact_N_per_m"), limits.exact_N_per_m.value());
    EXPECT_EQ(number(rows, row, "passive_N_per_m"), limits.passive_N_per_m);
  }
}

TEST(SweepOfWalls, DrawsWallsFromItsRangesWhoseLimitsAgree) {
  const ScratchFolder folder;
  const std::string out = folder.file("r.csv");
  const Given given = sweepHere({"stability", "--map",          "none",     "--draws",
                                 "40",        "--rate_hz",      "500",      "1000",
                                 "2000",      "--mass_kg",      "0.05:0.5", "--damping_N_s_per_m",
                                 "0.2:3",     "--kd_N_s_per_m", "0:1",      "--hand_stiffness_N_per_m",
                                 "0:300",     "--delay_ticks",  "0:2",      "--seed",
                                 "7",         "--out",          out});
  ASSERT_EQ(given.exit, cli::Exit::Success) << given.err;
  const Table rows = table(out);
  ASSERT_EQ(rows.size(), 41U);
  bool delayed[3] = {};
  for (std::size_t row = 1; row < rows.size(); ++row) {
    EXPECT_EQ(field(rows, row, "map"), "drawn");
    EXPECT_GE(number(rows, row, "mass_kg"), 0.05);
    EXPECT_LT(number(rows, row, "mass_kg"), 0.5);
    const double delay = number(rows, row, "delay_ticks");
    ASSERT_TRUE(delay == 0.0 || delay == 1.0 || delay == 2.0);
    delayed[static_cast<int>(delay)] = true;
    const double exact = number(rows, row, "exact_N_per_m");
    EXPECT_NEAR(number(rows, row, "simulated_N_per_m"), exact, 0.02 * exact);
  }
  EXPECT_TRUE(delayed[0] && delayed[1] && delayed[2]);
}

TEST(SweepOfWalls, ARowIsComputedAgainByThePrintedCommandToTheBit) {
  const ScratchFolder folder;
  const std::string out = folder.file("r.csv");
  const std::vector<std::string> wanted{"stability", "--map",          "filter", "quantization", "--draws",
                                        "4",         "--kd_N_s_per_m", "0:1",    "--mass_kg",    "0.05:0.5"};
  std::vector<std::string> all = wanted, print = wanted;
  all.insert(all.end(), {"--out", out});
  print.emplace_back("--print");
  ASSERT_EQ(sweepHere(all).exit, cli::Exit::Success);
  const std::vector<std::string> commands = linesOf(sweepHere(print).out);
  const Table rows = table(out);
  ASSERT_EQ(rows.size(), 1 + commands.size());
  for (std::size_t row = 1; row < rows.size(); row += row + 5 < rows.size() ? 5 : 1) {
    const Outcome again = runCli(argumentsOf(commands[row - 1]));
    ASSERT_EQ(again.exit, cli::Exit::Success) << commands[row - 1] << again.err;
    const json::Value wall = lines(again.out).at(0);
    EXPECT_EQ(number(rows, row, "simulated_N_per_m"), numberAt(wall, "simulated_limit_N_per_m")) << commands[row - 1];
    EXPECT_EQ(number(rows, row, "passive_N_per_m"), numberAt(wall, "passive_limit_N_per_m"));
    EXPECT_EQ(field(rows, row, "label_at_nominal"), textAt(wall, "label"));
    EXPECT_EQ(number(rows, row, "amplitude_mm_at_nominal"), numberAt(wall, "amplitude_mm"));
    const bool has_exact = field(rows, row, "exact_N_per_m") != "nan";
    EXPECT_EQ(has_exact, !isNullAt(wall, "exact_limit_N_per_m"));
    if (!has_exact) continue;
    EXPECT_EQ(number(rows, row, "exact_N_per_m"), numberAt(wall, "exact_limit_N_per_m"));
  }
}

TEST(SweepOfWalls, AMapThatThereIsNotIsRefused) {
  const ScratchFolder folder;
  const Given given = sweepHere({"stability", "--map", "rates", "--out", folder.file("r.csv")});
  EXPECT_EQ(given.exit, cli::Exit::Usage);
  EXPECT_NE(given.err.find("\"rates\""), std::string::npos) << given.err;
}

}  // namespace
}  // namespace underact::test
