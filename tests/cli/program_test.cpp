#include <gtest/gtest.h>

#include <algorithm>

#include "tests/cli/session.h"

namespace underact::test {
namespace {

using cli::Exit;

TEST(Program, EveryCommandHasHelpOnStandardOutput) {
  const std::vector<std::vector<std::string>> commands{{},        {"target"},         {"run"},
                                                       {"scene"}, {"scene", "check"}, {"scene", "show"}};
  for (std::vector<std::string> arguments : commands) {
    arguments.emplace_back("--help");
    const Outcome outcome = runCli(arguments);
    EXPECT_EQ(outcome.exit, Exit::Success) << testing::PrintToString(arguments);
    EXPECT_NE(outcome.out.find("Usage: underact-cli"), std::string::npos) << outcome.out;
    EXPECT_EQ(outcome.err, "");
  }
}

TEST(Program, SaysItsVersion) {
  const Outcome outcome = runCli({"--version"});
  EXPECT_EQ(outcome.exit, Exit::Success);
  EXPECT_TRUE(outcome.out.starts_with("underact-cli ")) << outcome.out;
}

TEST(Program, NoCommandAndUnknownOnesAreWrongUsage) {
  for (const std::vector<std::string>& arguments :
       std::vector<std::vector<std::string>>{{}, {"dance"}, {"scene"}, {"scene", "burn"}, {"target"}, {"--wrong"}}) {
    const Outcome outcome = runCli(arguments);
    EXPECT_EQ(outcome.exit, Exit::Usage) << testing::PrintToString(arguments);
    EXPECT_EQ(outcome.out, "");
    EXPECT_NE(outcome.err, "");
  }
}

TEST(Process, AnswersEachLineBeforeTheNextIsSent) {
  // The second line is sent only once the first answer has come: a pipe that held answers back would hang here.
  const std::string command =
      "bash -c 'set -e; coproc \"$0\" target \"$1\"; for i in 1 2 3; do "
      "echo \"{\\\"p_mm\\\": [$i, 0, 0]}\" >&${COPROC[1]}; "
      "read -t 20 -u ${COPROC[0]} answer; echo \"$answer\"; done' " +
      program() + " '" + shipped("02_sphere.json") + "'";
  const ProcessOutcome outcome = shell(command);
  EXPECT_EQ(outcome.exit, 0);
  EXPECT_EQ(lines(outcome.out).size(), 3U) << outcome.out;
}

TEST(Process, ResultsThatCannotBeWrittenGiveStatus4) {
  const std::string line = "echo '{\"p_mm\": [1, 2, 3]}' | ";
  EXPECT_EQ(shell(line + program() + " target '" + shipped("02_sphere.json") + "' 2>&1 >/dev/full").exit, 4);
  EXPECT_EQ(shell(program() + " --help 2>&1 >/dev/full").exit, 4);
}

TEST(Process, AFullDiskUnderTheRecordingGivesStatus4AndStillTheResult) {
  // Blocks of 512 bytes. A session that has no room to begin with is refused before anything runs.
  for (const auto& [name, blocks, results] :
       {std::tuple{"full.csv", "64", 1U}, {"full.h5", "600", 1U}, {"full.h5", "40", 0U}}) {
    const ScratchPath place(name);
    const ProcessOutcome outcome =
        shell("ulimit -f " + std::string(blocks) + "; " + program() + " run '" + shipped("02_sphere.json") +
              "' --hand still --seconds 1 --fast --record '" + place.path() + "' 2>/dev/null");
    EXPECT_EQ(outcome.exit, 4) << name;
    EXPECT_EQ(lines(outcome.out).size(), results) << name;
  }
}

TEST(Process, CtrlCEndsARunEarlyAndItStillPrints) {
  const ProcessOutcome outcome = shell("timeout --signal=INT 1 " + program() + " run '" + shipped("02_sphere.json") +
                                       "' --hand sweep --seconds 600");
  ASSERT_EQ(lines(outcome.out).size(), 1U) << outcome.out;
  const double ticks = numberAt(lines(outcome.out)[0], "ticks");
  EXPECT_GT(ticks, 0.0);
  EXPECT_LT(ticks, 10'000.0);
}

}  // namespace
}  // namespace underact::test
