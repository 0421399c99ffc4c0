#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>

#include "core/lesson/quantity.h"
#include "tests/cli/session.h"

namespace underact::test {
namespace {

using cli::Exit;

const std::string kPull =
    R"({"underact_lesson": 1, "title": "Pull", "steps": [{"title": "A", "text": "Pull at the spring.",
  "scene": "01_point", "checks": [{"measure": "asked_N", "above": 0.5, "for_s": 0.5},
                                  {"question": "How many?", "answer": 3, "within": 0}]}]})";

/// The scenes and lessons of the sources are those that ship.
class LessonCommand : public testing::Test {
 protected:
  void SetUp() override { setenv("UNDERACT_DATA_DIR", UNDERACT_SOURCE, 1); }
  void TearDown() override { unsetenv("UNDERACT_DATA_DIR"); }
};
class LessonCheck : public LessonCommand {};
class LessonTry : public LessonCommand {};
class LessonQuantities : public LessonCommand {};
class LessonList : public LessonCommand {};

/// A hand that stands so far from the point.
std::string handAt(double x_mm) {
  return R"({"underact_hand": 1, "path": [{"t_s": 0, "p_mm": [0, 0, 0]}, {"t_s": 2, "p_mm": [)" + std::to_string(x_mm) +
         R"(, 0, 0]}]})";
}

TEST_F(LessonCheck, SaysNothingOfTheLessonsThatShip) {
  std::vector<std::string> arguments{"lesson", "check"};
  for (const json::Value& line : lines(runCli({"lesson", "list", "--json"}).out)) {
    arguments.push_back(textAt(line, "file"));
  }
  EXPECT_GE(arguments.size(), 12u);
  const Outcome outcome = runCli(arguments);
  EXPECT_EQ(outcome.exit, Exit::Success);
  EXPECT_EQ(outcome.out + outcome.err, "");
}

TEST_F(LessonCheck, PrintsALineAProblemOfTheLessonAndOfItsScenes) {
  const ScratchFile bad(R"({"underact_lesson": 1, "title": "T",
 "steps": [{"title": "A", "text": "x", "scene": "02_sphere", "cheks": []}]})",
                        "bad.json");
  const ScratchFile poor(R"({"underact_lesson": 1, "title": "T", "steps": [
  {"title": "A", "text": "x", "scene": "02_sphere", "checks": [{"measure": "robot", "part": 1, "above": 1}]},
  {"title": "B", "text": "x", "scene": "nowhere"}]})",
                         "poor.json");
  const Outcome outcome = runCli({"lesson", "check", bad.path(), poor.path()});
  EXPECT_EQ(outcome.exit, Exit::BadInput);
  EXPECT_EQ(outcome.err, "");
  EXPECT_EQ(std::count(outcome.out.begin(), outcome.out.end(), '\n'), 3) << outcome.out;
  EXPECT_NE(outcome.out.find(bad.path() + ":2:62: error: steps[0].cheks: "), std::string::npos) << outcome.out;
  EXPECT_NE(outcome.out.find("Did you mean \"checks\"?"), std::string::npos);
  EXPECT_NE(outcome.out.find("none of its constraints is a virtual robot"), std::string::npos);
  EXPECT_NE(outcome.out.find("nowhere.json"), std::string::npos);
}

TEST_F(LessonCheck, AFileThatCannotBeReadGivesItsOwnStatus) {
  const Outcome outcome = runCli({"lesson", "check", "/nowhere/lesson.json"});
  EXPECT_EQ(outcome.exit, Exit::File);
  EXPECT_EQ(outcome.out, "");
}

TEST_F(LessonTry, SaysWhatIsSolvedAndWhatIsMissing) {
  const ScratchFile lesson(kPull, "pull.json"), strong(handAt(10), "strong.json"), weak(handAt(1), "weak.json");
  const Outcome right = runCli({"lesson", "try", lesson.path(), "--hand", strong.path(), "--answer", "3"});
  EXPECT_EQ(right.exit, Exit::Success) << right.out;
  EXPECT_NE(right.out.find("solved   Held for 0.5 of 0.5 s."), std::string::npos) << right.out;
  EXPECT_NE(right.out.find("solved   3 is correct."), std::string::npos) << right.out;
  const Outcome wrong = runCli({"lesson", "try", lesson.path(), "--hand", weak.path(), "--answer", "4"});
  EXPECT_EQ(wrong.exit, Exit::BadInput);
  EXPECT_NE(wrong.out.find("missing  Held for 0.0 of 0.5 s."), std::string::npos) << wrong.out;
  EXPECT_NE(wrong.out.find("missing  4 is not correct."), std::string::npos) << wrong.out;
}

TEST_F(LessonTry, GivesOneObjectForPrograms) {
  const ScratchFile lesson(kPull, "pull.json"), strong(handAt(10), "strong.json");
  const Outcome outcome = runCli({"lesson", "try", lesson.path(), "--hand", strong.path(), "--json"});
  EXPECT_EQ(outcome.exit, Exit::BadInput);  // nobody answered
  const json::Value object = lines(outcome.out).at(0);
  EXPECT_FALSE(object.find("solved")->boolean);
  EXPECT_TRUE(object.find("checks")->items.at(0).find("solved")->boolean);
  EXPECT_FALSE(object.find("checks")->items.at(1).find("solved")->boolean);
}

TEST_F(LessonTry, TakesALessonByItsNameAndSettingsOfTheStudent) {
  const Outcome outcome = runCli({"lesson", "try", "07_stiffness", "--step", "5", "--hand", "still", "--seconds", "1",
                                  "--set", "kp_N_per_mm=0.1", "--set", "kd_N_s_per_mm=0.0023"});
  EXPECT_EQ(outcome.exit, Exit::Success) << outcome.out << outcome.err;
  const Outcome odd = runCli({"lesson", "try", "07_stiffness", "--hand", "still", "--set", "stiffness=1"});
  EXPECT_EQ(odd.exit, Exit::BadInput);
  EXPECT_NE(odd.err.find("is none"), std::string::npos) << odd.err;
}

TEST_F(LessonTry, WrongUsageIsTold) {
  const ScratchFile lesson(kPull, "pull.json");
  EXPECT_EQ(runCli({"lesson", "try", lesson.path(), "--hand", "still", "--step", "2"}).exit, Exit::Usage);
  EXPECT_EQ(runCli({"lesson", "try", lesson.path(), "--hand", "stil"}).exit, Exit::Usage);
  EXPECT_EQ(runCli({"lesson", "try", lesson.path(), "--hand", "still", "--set", "kp"}).exit, Exit::Usage);
  EXPECT_EQ(runCli({"lesson", "try", lesson.path()}).exit, Exit::Usage);
  EXPECT_EQ(runCli({"lesson"}).exit, Exit::Usage);
  EXPECT_EQ(runCli({"lesson", "try", "/nowhere.json", "--hand", "still"}).exit, Exit::File);
}

TEST_F(LessonQuantities, AreAllListed) {
  EXPECT_EQ(lines(runCli({"lesson", "quantities", "--json"}).out).size(), lesson::quantities().size());
  const Outcome table = runCli({"lesson", "quantities"});
  EXPECT_NE(table.out.find("force_N"), std::string::npos);
  EXPECT_EQ(table.exit, Exit::Success);
}

TEST_F(LessonList, NamesEachWithItsSteps) {
  const Outcome outcome = runCli({"lesson", "list"});
  EXPECT_EQ(outcome.exit, Exit::Success);
  EXPECT_NE(outcome.out.find("04_inverse                  6  steps  Eight inverse solutions"), std::string::npos)
      << outcome.out;
}

}  // namespace
}  // namespace underact::test
