#include <gtest/gtest.h>

#include <filesystem>

#include "core/lesson/report.h"
#include "tests/cli/session.h"

namespace underact::test {
namespace {

using cli::Exit;

/// What a student whose number this is has done; names as a class may type them, also to harm.
lesson::Report reportOfStudent(int number) {
  static const std::vector<std::string> kNames{
      "Ada Lovelace", "Émilie du Châtelet", "李明",    "=1+1", "+49 30 1",     "-x",
      "@SUM(A1)",     "Bo \"B\" Ek",        "Li, Wei", "a;=2", "\x1b[31mred\n"};
  const auto index = static_cast<std::size_t>(number);
  lesson::Report report{index < kNames.size() ? kNames[index] : "student" + std::to_string(number) + "@example.org",
                        number % 3 == 0 ? "07_stiffness" : "04_inverse",
                        number % 3 == 0 ? "Stiffness and damping" : "Eight inverse solutions",
                        "2026-11-28T10:" + std::to_string(10 + number) + ":00",
                        4.5 + number,
                        {}};
  for (int step = 0; step < 6; ++step) {
    const bool solved = step < number % 7;
    lesson::StepReport& one = report.steps.emplace_back();
    one.title = "Step " + std::to_string(step + 1);
    one.solved = solved, one.attempts = solved ? 1 : 2, one.wrong = solved ? 0 : 2;
    if (!solved && number % 2 == 0)
      one.misconceptions = {"Square root forgotten", "Factor 2 forgotten", "Factor 2 forgotten"};
  }
  return report;
}

/// The folder of thirty reports, as a teacher collects them.
class LessonResults : public testing::Test {
 protected:
  void SetUp() override {
    for (int number = 0; number < 30; ++number)
      folder_.write("report" + std::to_string(100 + number) + ".html",
                    "<html><head>" + reportData(reportOfStudent(number)) + "</head><body>text</body></html>");
  }
  std::string golden(const std::string& name) const {
    return fileContent(std::string(UNDERACT_SOURCE) + "/tests/golden/" + name);
  }
  ScratchFolder folder_;
};

TEST_F(LessonResults, OfThirtyReportsAreOneTable) {
  const Outcome outcome = runCli({"lesson", "results", folder_.path(), "--csv"});
  EXPECT_EQ(outcome.exit, Exit::Success) << outcome.err;
  EXPECT_EQ(outcome.out, golden("lesson_results.csv"));
  EXPECT_EQ(outcome.err, "");
}

TEST_F(LessonResults, ForMoodleAreARowAStudentWithAColumnALesson) {
  const Outcome outcome = runCli({"lesson", "results", folder_.path(), "--moodle"});
  EXPECT_EQ(outcome.exit, Exit::Success) << outcome.err;
  EXPECT_EQ(outcome.out, golden("lesson_results_moodle.csv"));
}

TEST_F(LessonResults, AreATableForPeopleAndObjectsForPrograms) {
  const Outcome table = runCli({"lesson", "results", folder_.path()});
  EXPECT_EQ(table.exit, Exit::Success);
  EXPECT_NE(table.out.find("Émilie du Châtelet     04_inverse    2026-11-28  1 of 6  2 Step 2"), std::string::npos)
      << table.out;
  EXPECT_EQ(table.out.find('\x1b'), std::string::npos);
  const std::vector<json::Value> objects = lines(runCli({"lesson", "results", folder_.path(), "--json"}).out);
  ASSERT_EQ(objects.size(), 30u);
  EXPECT_EQ(textAt(objects[1], "student"), "+49 30 1");
  EXPECT_EQ(textAt(objects[1], "misconception"), "Factor 2 forgotten");
  EXPECT_EQ(runCli({"lesson", "results", folder_.path(), "--json", "--csv"}).exit, Exit::Usage);
}

TEST_F(LessonResults, WhatCannotBeReadIsListedAndSpoilsNothing) {
  folder_.write("notes.html", "<html>Not a report</html>");
  folder_.write("cut.html", reportData(reportOfStudent(1)).substr(0, 120));
  folder_.write("large.html", std::string((std::size_t{1} << 20) + 1, ' ') + reportData(reportOfStudent(2)));
  folder_.write("readme.txt", "no page");
  std::filesystem::create_symlink("/dev/zero", folder_.file("zero.html"));
  std::filesystem::create_directories(folder_.file("moodle/Ada_1_assignsubmission_file"));
  folder_.write("moodle/Ada_1_assignsubmission_file/r.html", reportData(reportOfStudent(40)));
  const Outcome outcome = runCli({"lesson", "results", folder_.path(), "--json"});
  EXPECT_EQ(outcome.exit, Exit::BadInput);
  EXPECT_EQ(lines(outcome.out).size(), 31u);
  EXPECT_EQ(std::count(outcome.err.begin(), outcome.err.end(), '\n'), 4) << outcome.err;
  EXPECT_NE(outcome.err.find("notes.html"), std::string::npos);
}

TEST_F(LessonResults, AFolderThatIsMissingHasItsOwnStatus) {
  EXPECT_EQ(runCli({"lesson", "results", folder_.file("nowhere")}).exit, Exit::File);
}

}  // namespace
}  // namespace underact::test
