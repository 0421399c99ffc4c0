#include <gtest/gtest.h>

#include "tests/cli/session.h"

namespace underact::test {
namespace {

using cli::Exit;
using json::Value;

Value check(std::vector<std::string> more) {
  std::vector<std::string> arguments{"servo-check", "--json", "--seconds", "1"};
  arguments.insert(arguments.end(), more.begin(), more.end());
  const Outcome outcome = runCli(arguments);
  EXPECT_EQ(outcome.exit, Exit::Success) << outcome.err;
  const std::vector<Value> all = lines(outcome.out);
  EXPECT_EQ(all.size(), 1U) << outcome.out;
  return all.empty() ? Value{} : all[0];
}

TEST(ServoCheck, GivesEveryFigureOfTheContract) {
  const Value all = check({"--scheduling", "normal"});
  for (const char* who : {"floor_us", "servo_us", "tick_us"}) {
    const Value* figures = all.find(who);
    ASSERT_NE(figures, nullptr) << who;
    EXPECT_GT(numberAt(*figures, "p50"), 0.0);
    EXPECT_LE(numberAt(*figures, "p50"), numberAt(*figures, "p99"));
    EXPECT_LE(numberAt(*figures, "p99"), numberAt(*figures, "p99.9"));
    EXPECT_LE(numberAt(*figures, "p99.9"), numberAt(*figures, "max"));
  }
  EXPECT_EQ(textAt(all, "scheduling"), "normal");
  EXPECT_NE(textAt(all, "hint"), "");
  EXPECT_EQ(numberAt(all, "rate_hz"), 1000.0);
  EXPECT_GE(numberAt(all, "seconds"), 1.0);
  EXPECT_GT(numberAt(all, "ticks"), 0.0);
  const Value* causes = all.find("late_ticks_by_cause");
  ASSERT_NE(causes, nullptr);
  double sum = 0.0;
  for (const char* cause : {"overrun", "device", "page_fault", "preempted", "woken"}) sum += numberAt(*causes, cause);
  EXPECT_EQ(sum, numberAt(all, "late_ticks"));
}

TEST(ServoCheck, TakesAnyShippedSceneRateAndArmModelAndALoad) {
  const Value all =
      check({"--scene", shipped("20_scara.json"), "--rate", "4000", "--arm-model", "ideal", "--load", "--core", "0"});
  EXPECT_EQ(numberAt(all, "rate_hz"), 4000.0);
  EXPECT_GT(numberAt(all, "ticks"), 0.0);
}

TEST(ServoCheck, PrintsATableForPeople) {
  const Outcome outcome = runCli({"servo-check", "--seconds", "1", "--scheduling", "normal"});
  EXPECT_EQ(outcome.exit, Exit::Success);
  for (const char* word :
       {"Scheduling: normal", "p99.9", "latency of a bare loop", "latency of the servo", "A period or more late"}) {
    EXPECT_NE(outcome.out.find(word), std::string::npos) << word << " in\n" << outcome.out;
  }
  EXPECT_NE(outcome.err, "");  // the hint
}

TEST(ServoCheck, RefusesUnknownWordsAsWrongUsage) {
  for (const std::vector<std::string>& wrong : std::vector<std::vector<std::string>>{{"--seconds", "0"},
                                                                                     {"--seconds", "1.5"},
                                                                                     {"--rate", "99"},
                                                                                     {"--rate", "10001"},
                                                                                     {"--scheduling", "best"},
                                                                                     {"--core", "-1"},
                                                                                     {"--arm-model", "stone"}}) {
    std::vector<std::string> arguments{"servo-check"};
    arguments.insert(arguments.end(), wrong.begin(), wrong.end());
    const Outcome outcome = runCli(arguments);
    EXPECT_EQ(outcome.exit, Exit::Usage) << wrong[0] << ' ' << wrong[1];
    EXPECT_EQ(outcome.out, "");
  }
}

TEST(ServoCheck, ASceneThatIsNotThereOrNotRightIsSaidSo) {
  EXPECT_EQ(runCli({"servo-check", "--scene", "/nonexistent.json"}).exit, Exit::File);
  const ScratchFile broken("{\"underact_scene\": 1}");
  EXPECT_EQ(runCli({"servo-check", "--scene", broken.path()}).exit, Exit::BadInput);
}

TEST(Process, CtrlCEndsAServoCheckEarlyAndItStillPrints) {
  const ProcessOutcome outcome =
      shell("timeout --signal=INT 3 " + program() + " servo-check --seconds 600 --json --scheduling normal");
  ASSERT_EQ(lines(outcome.out).size(), 1U) << outcome.out;
  EXPECT_LT(numberAt(lines(outcome.out)[0], "seconds"), 500.0);
}

TEST(Run, TakesTheSchedulingThatIsAskedFor) {
  const std::vector<std::string> still{"run", shipped("02_sphere.json"), "--hand", "still", "--seconds", "0.1"};
  std::vector<std::string> arguments = still;
  for (const char* more : {"--scheduling", "normal"}) arguments.emplace_back(more);
  const Outcome outcome = runCli(arguments);
  ASSERT_EQ(outcome.exit, Exit::Success) << outcome.err;
  EXPECT_EQ(textAt(lines(outcome.out)[0], "scheduling"), "normal");
  arguments.back() = "best";
  EXPECT_EQ(runCli(arguments).exit, Exit::Usage);
}

}  // namespace
}  // namespace underact::test
