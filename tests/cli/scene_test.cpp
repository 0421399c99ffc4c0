#include <gtest/gtest.h>

#include <filesystem>

#include "tests/cli/session.h"

namespace underact::test {
namespace {

using cli::Exit;

std::vector<std::string> shippedScenes() {
  std::vector<std::string> paths;
  for (const auto& entry : std::filesystem::directory_iterator(shipped(""))) {
    if (entry.path().extension() == ".json" && entry.path().stem().extension() != ".schema")
      paths.push_back(entry.path());
  }
  return paths;
}

TEST(SceneCheck, SaysNothingOfScenesThatAreWell) {
  std::vector<std::string> arguments = shippedScenes();
  EXPECT_GE(arguments.size(), 9U);
  arguments.insert(arguments.begin(), {"scene", "check"});
  const Outcome outcome = runCli(arguments);
  EXPECT_EQ(outcome.exit, Exit::Success);
  EXPECT_EQ(outcome.out + outcome.err, "");
}

TEST(SceneCheck, PrintsALineAProblemWithFileLineColumnAndKey) {
  const ScratchFile file(
      "{\"underact_scene\": 1, \"title\": \"Bad\",\n"
      " \"constraints\": [\n"
      "  {\"type\": \"sphere\", \"center_mm\": [0, 0, 0], \"radius_mm\": -1},\n"
      "  {\"type\": \"line\", \"point_mm\": [0, 0, 0], \"direction\": [0, 0, 0]}]}\n");
  const Outcome outcome = runCli({"scene", "check", file.path()});
  EXPECT_EQ(outcome.exit, Exit::BadInput);
  EXPECT_EQ(outcome.err, "");
  EXPECT_EQ(std::count(outcome.out.begin(), outcome.out.end(), '\n'), 2);
  EXPECT_NE(outcome.out.find(file.path() + ":3:"), std::string::npos) << outcome.out;
  EXPECT_NE(outcome.out.find(file.path() + ":4:"), std::string::npos) << outcome.out;
  EXPECT_NE(outcome.out.find(": error: constraints[0].radius_mm: "), std::string::npos) << outcome.out;
}

TEST(SceneCheck, GoesOnAfterABadFile) {
  const ScratchFile bad("{}", "bad.json"), worse("{", "worse.json");
  const Outcome outcome = runCli({"scene", "check", bad.path(), shipped("02_sphere.json"), worse.path()});
  EXPECT_EQ(outcome.exit, Exit::BadInput);
  EXPECT_NE(outcome.out.find(bad.path()), std::string::npos);
  EXPECT_NE(outcome.out.find(worse.path()), std::string::npos);
}

TEST(SceneCheck, AFileThatCannotBeReadGivesItsOwnStatus) {
  const Outcome outcome = runCli({"scene", "check", "/dev/null/nowhere/scene.json", shipped("02_sphere.json")});
  EXPECT_EQ(outcome.exit, Exit::File);
  EXPECT_EQ(outcome.out, "");
  EXPECT_NE(outcome.err.find("/dev/null/nowhere/scene.json"), std::string::npos);
}

TEST(SceneShow, TellsWhatTheTickNeedsAndNothingItDoesNot) {
  const ScratchFile p(sceneText(R"({"type": "point", "position_mm": [0, 0, 0]})"));
  const ScratchFile pid(
      sceneText(R"({"type": "sphere", "center_mm": [0, 0, 0], "radius_mm": 50})",
                R"("control": {"law": "PID", "kp_N_per_mm": [0.5, 0.4, 0.3], "ki_N_per_mm_s": 1}, )"));
  const json::Value lean = lines(runCli({"scene", "show", p.path(), "--json"}).out).at(0);
  const json::Value rich = lines(runCli({"scene", "show", pid.path(), "--json"}).out).at(0);
  EXPECT_TRUE(lean.find("needs")->find("position")->boolean);
  for (const char* need : {"error_rate", "error_integral", "gain_metric"}) {
    EXPECT_FALSE(lean.find("needs")->find(need)->boolean) << need;
    EXPECT_TRUE(rich.find("needs")->find(need)->boolean) << need;
  }
  EXPECT_LT(numberAt(lean, "state_bytes"), numberAt(rich, "state_bytes"));
  EXPECT_LT(numberAt(lean, "predicted_ns"), numberAt(rich, "predicted_ns"));
  EXPECT_GT(numberAt(lean, "predicted_ns"), 0.0);
}

TEST(SceneShow, PrintsATableForPeople) {
  const Outcome outcome = runCli({"scene", "show", shipped("02_sphere.json")});
  EXPECT_EQ(outcome.exit, Exit::Success);
  EXPECT_NE(outcome.out.find("needs position          yes"), std::string::npos) << outcome.out;
  EXPECT_NE(outcome.out.find("ns per tick"), std::string::npos) << outcome.out;
}

}  // namespace
}  // namespace underact::test
