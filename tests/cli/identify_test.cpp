#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>

#include "core/sim/arm_model_file.h"
#include "tests/cli/session.h"

namespace underact::test {
namespace {

std::string scratchPath(const std::string& name) {
  return (std::filesystem::temp_directory_path() / ("underact_identify_" + name)).string();
}

TEST(IdentifyCommand, FindsWithinFivePercentWhatTheSimulationWasGivenAndWritesAFileThatRuns) {
  const ScratchFile given(R"({"underact_arm_model": 1, "name": "given", "title": "Given",
    "provenance": {"device": "a test", "date": "2026-11-22"},
    "mass_kg": 0.08, "friction_N": 0.15, "damping_N_s_per_m": 0.6})",
                          "given_arm.json");
  const std::string out = scratchPath("out.json"), report = scratchPath("report.md");
  const Outcome outcome =
      runCli({"identify", "--arm-model", given.path(), "--json", "--name", "again", "--out", out, "--report", report});
  ASSERT_EQ(outcome.exit, cli::Exit::Success) << outcome.err;
  const json::Value result = lines(outcome.out).at(0);
  EXPECT_NEAR(numberAt(result, "mass_kg"), 0.08, 0.05 * 0.08);
  EXPECT_NEAR(numberAt(result, "friction_N"), 0.15, 0.05 * 0.15);
  EXPECT_NEAR(numberAt(result, "damping_N_s_per_m"), 0.6, 0.05 * 0.6);
  ASSERT_NE(result.find("rows"), nullptr);
  EXPECT_GE(result.find("rows")->items.size(), 20U);
  const Result<sim::ArmModelFile> file = sim::readArmModelFile(out);
  ASSERT_TRUE(static_cast<bool>(file));
  EXPECT_EQ(file.value().arm.name, "again");
  EXPECT_EQ(file.value().arm.mass_kg, numberAt(result, "mass_kg"));
  EXPECT_NE(fileContent(report).find("| Mass |"), std::string::npos);
  // What was measured runs as an arm of its own, and moves as the one that it was measured on.
  const auto stepOf = [](const std::string& model) {
    return lines(runCli({"lab", "step", "--scene", shipped("01_point.json"), "--axis", "x", "--arm-model", model,
                         "--json"})
                     .out)
        .at(0);
  };
  const double was_s = numberAt(stepOf(given.path()), "rise_10_90_s"), is_s = numberAt(stepOf(out), "rise_10_90_s");
  EXPECT_NEAR(is_s, was_s, 0.05 * was_s);
  EXPECT_GT(std::abs(numberAt(stepOf("vendor-nominal"), "rise_10_90_s") - was_s), 0.1 * was_s);
  const Outcome run =
      runCli({"run", shipped("01_point.json"), "--hand", "still", "--seconds", "0.2", "--fast", "--arm-model", out});
  EXPECT_EQ(run.exit, cli::Exit::Success) << run.err;
  std::filesystem::remove(out);
  std::filesystem::remove(report);
}

TEST(IdentifyCommand, PrintsATableWithWhatWasGivenBeside) {
  const Outcome outcome = runCli({"identify"});
  ASSERT_EQ(outcome.exit, cli::Exit::Success) << outcome.err;
  EXPECT_NE(outcome.out.find("Mass along z"), std::string::npos);
  EXPECT_NE(outcome.out.find("difference"), std::string::npos);
  EXPECT_NE(outcome.out.find("Counts per turn, shin               15419.0"), std::string::npos) << outcome.out;
  EXPECT_TRUE(outcome.err.empty()) << outcome.err;
}

TEST(IdentifyCommand, TheSameSeedGivesTheSameBytesAndAnotherOneOthers) {
  const std::string first = runCli({"identify", "--json", "--seed", "3"}).out;
  EXPECT_EQ(first, runCli({"identify", "--json", "--seed", "3"}).out);
  EXPECT_NE(first, runCli({"identify", "--json", "--seed", "4"}).out);
}

TEST(IdentifyCommand, RefusesInWords) {
  const Outcome far = runCli({"identify", "--at_mm", "500,0,0"});
  EXPECT_EQ(far.exit, cli::Exit::BadInput);
  EXPECT_NE(far.err.find("Choose a position nearer to the middle"), std::string::npos) << far.err;
  EXPECT_EQ(runCli({"identify", "--at_mm", "0,0,60,1"}).exit, cli::Exit::Usage);
  const Outcome massless = runCli({"identify", "--arm-model", "ideal"});
  EXPECT_EQ(massless.exit, cli::Exit::BadInput);
  EXPECT_NE(massless.err.find("hardly moved"), std::string::npos) << massless.err;
  EXPECT_EQ(runCli({"identify", "--out", "/nowhere/at/all.json"}).exit, cli::Exit::File);
}

TEST(IdentifyCommand, AFaultOfTheServoHasItsOwnExitStatus) {
  const ScratchFile light(R"({"underact_arm_model": 1, "name": "light", "title": "Light",
    "provenance": {"device": "a test", "date": "2026-11-22"}, "mass_kg": 0.0005, "friction_N": 0})",
                          "light_arm.json");
  // Half a gram on 100 N/m swings 70 times a second: a servo of 100 Hz throws it.
  const Outcome outcome = runCli({"identify", "--arm-model", light.path(), "--rate", "100"});
  EXPECT_EQ(outcome.exit, cli::Exit::Fault) << outcome.err;
  EXPECT_NE(outcome.err.find("m/s"), std::string::npos) << outcome.err;
  EXPECT_EQ(outcome.err.find("press"), std::string::npos) << "there is nothing to press: " << outcome.err;
  EXPECT_TRUE(outcome.out.empty()) << outcome.out;
}

TEST(IdentifyCommand, AnArmModelIsANameOrAFileEverywhere) {
  const Outcome name =
      runCli({"run", shipped("01_point.json"), "--hand", "still", "--seconds", "0.1", "--fast", "--arm-model", "idea"});
  EXPECT_EQ(name.exit, cli::Exit::Usage);
  EXPECT_NE(name.err.find("\"ideal\""), std::string::npos) << name.err;
  const ScratchFile wrong(R"({"underact_arm_model": 1, "name": "x", "title": "X", "mass": 1})", "wrong_arm.json");
  for (const std::vector<std::string>& command :
       {std::vector<std::string>{"run", shipped("01_point.json"), "--hand", "still", "--seconds", "0.1", "--fast"},
        {"lab", "step", "--scene", shipped("01_point.json")},
        {"servo-check", "--seconds", "1"},
        {"identify"}}) {
    std::vector<std::string> with = command;
    with.insert(with.end(), {"--arm-model", wrong.path()});
    const Outcome outcome = runCli(with);
    EXPECT_EQ(outcome.exit, cli::Exit::BadInput) << command[0];
    EXPECT_NE(outcome.err.find("mass_kg"), std::string::npos)
        << outcome.err;  // the nearest key, and one that is missing
    EXPECT_NE(outcome.err.find("provenance"), std::string::npos) << outcome.err;
  }
  std::vector<std::string> missing{"run", shipped("01_point.json"), "--hand", "still", "--seconds", "0.1", "--fast"};
  missing.insert(missing.end(), {"--arm-model", "./nowhere.json"});
  EXPECT_EQ(runCli(missing).exit, cli::Exit::File);
}

}  // namespace
}  // namespace underact::test
