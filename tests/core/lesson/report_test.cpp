#include "core/lesson/report.h"

#include "core/lesson/results.h"
#include "tests/core/lesson/lesson_support.h"
#include "tests/support/scratch_folder.h"

namespace underact::lesson {
namespace {

using test::checkOf;
using test::lessonWith;
using test::problemsIn;

const std::string kAsk = R"({"question": "How much?", "answer": 88, "within": 1.5,
  "misconceptions": [{"answer": 0.088, "name": "Metres"}, {"answer": 176, "name": "Factor 2"}]})";

Report someReport() {
  return {"Ada </script><b>",
          "05_x",
          "A <title>",
          "2026-11-28T17:00:00",
          12.5,
          {{"One", true, 2, 1, {"Metres"}}, {"Two", false, 3, 3, {"Signs", "Metres", "Signs"}}}};
}

std::string pageWith(const std::string& data) {
  return "<!DOCTYPE html>\n<html><head>" + data + "</head><body></body></html>";
}

/// The page of a report with a part of its data replaced.
std::string changed(const std::string& from, const std::string& to) {
  std::string data = reportData(someReport());
  data.replace(data.find(from), from.size(), to);
  return pageWith(data);
}

std::string refusalOf(const std::string& page) {
  const Result<Report> read = readReport(page, "r.html");
  return read ? "" : read.problems().front().sentence;
}

TEST(Misconceptions, AreNamedByTheWrongAnswersThatShowThem) {
  const Check check = checkOf(kAsk);
  const auto nameOf = [&check](double answer) {
    const Misconception* const found = misconceptionOf(check, answer);
    return found == nullptr ? std::string() : found->name;
  };
  EXPECT_EQ(nameOf(0.088), "Metres");
  EXPECT_EQ(nameOf(175), "Factor 2");
  EXPECT_EQ(nameOf(0), "") << "near, but not by a share of the number";
  EXPECT_EQ(nameOf(90), "");
  Step step;
  step.title = "S";
  step.checks = {check};
  CheckState state;
  for (const double answer : {90.0, 176.0, 176.0, 88.0}) state = afterAnswer(check, std::move(state), answer);
  const StepReport report = reportOf(step, true, {state});
  EXPECT_EQ(report.attempts, 4u);
  EXPECT_EQ(report.wrong, 3u);
  EXPECT_EQ(report.misconceptions, (std::vector<std::string>{"Factor 2", "Factor 2"}));
}

TEST(Misconceptions, OfARightAnswerOrWithoutAQuestionAreProblems) {
  for (const char* check :
       {R"({"question": "?", "choices": ["a", "b"], "right": 2, "misconceptions": [{"answer": 2, "name": "x"}]})",
        R"({"question": "?", "choices": ["a", "b"], "right": 2, "misconceptions": [{"answer": 3, "name": "x"}]})",
        R"({"question": "?", "answer": 5, "within": 1, "misconceptions": [{"answer": 6, "name": "x"}]})",
        R"({"question": "?", "answer": 5, "within": 1, "misconceptions": [{"answer": 9}]})",
        R"({"question": "?", "answer": 5, "within": 1, "misconceptions": 9})",
        R"({"measure": "force_N", "above": 1, "misconceptions": []})"})
    EXPECT_EQ(problemsIn(lessonWith(check)).size(), 1u) << check;
}

TEST(LessonReport, ItsPageIsReadAsItWasWrittenWhateverIsInIt) {
  const std::string data = reportData(someReport());
  EXPECT_EQ(data.find('<', 1), data.rfind("</script>")) << "no text can end the element: " << data;
  const Result<Report> read = readReport(pageWith(data), "r.html");
  ASSERT_TRUE(read) << describe(read.problems().front());
  EXPECT_EQ(read.value().student, "Ada </script><b>");
  EXPECT_EQ(read.value().minutes, 12.5);
  ASSERT_EQ(read.value().steps.size(), 2u);
  EXPECT_EQ(reportData(read.value()), data);
}

TEST(LessonReport, WhatIsNoneIsRefusedWithASentence) {
  for (const std::string& page :
       {std::string(), pageWith(""), pageWith(reportData(someReport()).substr(0, 200)), changed("{", "["),
        changed("\"underact_report\": 1", "\"underact_report\": 2"), changed("12.5", "-1"), changed("12.5", "1e999"),
        changed("\"wrong\": 3", "\"wrong\": 0.5"), changed("\"solved\": true", "\"solved\": 1"),
        changed("\"Two\"", "\"" + std::string(500, 'x') + "\""), changed("[\"Metres\"]", "[7]"),
        changed("\"steps\": [", "\"steps\": [[], "), changed("\"date\"", "\"data\"")})
    EXPECT_GT(refusalOf(page).size(), 10u) << page;
}

TEST(ClassResults, SayWhereAStudentStoppedAndWhatTheirAnswersShowMostOften) {
  const underact::test::ScratchFolder folder;
  folder.write("a.html", pageWith(reportData(someReport())));
  const Result<ClassResults> read = readResults(folder.path());
  ASSERT_TRUE(read);
  ASSERT_EQ(read.value().rows.size(), 1u);
  const ResultRow& row = read.value().rows.front();
  EXPECT_EQ(row.solved, 1u);
  EXPECT_EQ(row.stopped_at, 2u);
  EXPECT_EQ(row.stopped_title, "Two");
  EXPECT_EQ(row.attempts, 5u);
  EXPECT_EQ(row.wrong, 4u);
  EXPECT_EQ(row.misconception, "Signs");
}

TEST(ClassResults, OfTwoReportsOfAStudentTheLaterOneCountsAndNamelessOnesAreNotMixed) {
  const underact::test::ScratchFolder folder;
  Report report = someReport();
  const auto write = [&](const std::string& file, const std::string& student, const std::string& date) {
    report.student = student, report.date = date;
    folder.write(file, pageWith(reportData(report)));
  };
  write("a.html", "Bo", "2026-11-28T17:00:00");
  write("b.html", "Bo", "2026-11-28T16:00:00");
  write("c.html", "", "2026-11-28T16:00:00");
  write("d.html", "", "2026-11-28T16:00:00");
  const Result<ClassResults> read = readResults(folder.path());
  ASSERT_TRUE(read);
  ASSERT_EQ(read.value().rows.size(), 3u);
  EXPECT_EQ(read.value().rows.back().report, "a.html");
  ASSERT_EQ(read.value().older.size(), 1u);
  EXPECT_EQ(withoutName(read.value()), 2u);
}

}  // namespace
}  // namespace underact::lesson
