#include <gtest/gtest.h>

#include "core/error_bounds/catalogue.h"
#include "tests/cli/session.h"
#include "tests/sweep/rig.h"

namespace underact::test {
namespace {

TEST(SweepOfExtremes, HasTheWorstOfEachRowAndSeedAsTheLabHasIt) {
  const ScratchFolder folder;
  const std::string out = folder.file("r.csv");
  const Said said = sweepHere({"extremes", "--only", "shape_circle", "law_pid", "--seeds", "3", "--count", "200",
                               "--threads", "2", "--out", out});
  ASSERT_EQ(said.exit, cli::Exit::Well) << said.err;
  const auto rows = table(out);
  ASSERT_EQ(rows.size(), 1U + 2 * 3);
  for (std::size_t row = 1; row < rows.size(); ++row) {
    const error_bounds::Row* asked = error_bounds::findRow(row <= 3 ? "shape_circle" : "law_pid");
    ASSERT_NE(asked, nullptr);
    EXPECT_EQ(field(rows, row, "row"), asked->key);
    const error_bounds::Worst worst = measure(*asked, std::stoull(field(rows, row, "seed")), 200);
    EXPECT_EQ(std::stod(field(rows, row, "error_ulp")), worst.error_ulp);
    EXPECT_EQ(field(rows, row, "cases"), std::to_string(worst.cases));
    EXPECT_EQ(field(rows, row, "promise"), "kept");
  }
}

TEST(SweepOfExtremes, ARowIsMeasuredAgainByThePrintedCommandToTheBit) {
  const ScratchFolder folder;
  const std::string out = folder.file("r.csv");
  const std::vector<std::string> wanted{"extremes", "--only", "shape_circle", "law_pid",
                                        "--seeds",  "2",      "--count",      "200"};
  std::vector<std::string> all = wanted, print = wanted;
  all.insert(all.end(), {"--out", out});
  print.emplace_back("--print");
  ASSERT_EQ(sweepHere(all).exit, cli::Exit::Well);
  const std::vector<std::string> commands = linesOf(sweepHere(print).out);
  const auto rows = table(out);
  ASSERT_EQ(rows.size(), 1 + commands.size());
  for (std::size_t row = 1; row < rows.size(); ++row) {
    const json::Value again = lines(runCli(argumentsOf(commands[row - 1])).out).at(0);
    EXPECT_EQ(field(rows, row, "row"), textAt(again, "key"));
    EXPECT_EQ(number(rows, row, "error_ulp"), numberAt(again, "error_ulp"));
    EXPECT_EQ(number(rows, row, "cases"), numberAt(again, "cases"));
  }
}

TEST(SweepOfExtremes, ARowThatThereIsNotIsRefusedWithTheNearest) {
  const ScratchFolder folder;
  const Said said = sweepHere({"extremes", "--only", "shape_cirle", "--out", folder.file("r.csv")});
  EXPECT_EQ(said.exit, cli::Exit::Usage);
  EXPECT_NE(said.err.find("Did you mean \"shape_circle\"?"), std::string::npos) << said.err;
}

}  // namespace
}  // namespace underact::test
