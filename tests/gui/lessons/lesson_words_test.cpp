#include "app/gui/lessons/lesson_words.h"

#include <gtest/gtest.h>

#include <QDateTime>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QRadioButton>
#include <QSignalSpy>

#include "app/gui/lessons/check_row.h"
#include "app/gui/lessons/lesson_library.h"
#include "app/gui/lessons/lessons_panel.h"
#include "tests/gui/desk.h"

namespace underact::gui {
FeatureRow lessonsFeature();
}

namespace underact::gui::test {
namespace {

QString anyLesson(Desk& desk) {
  return desk.fileOf("ask.lesson.json", R"({
  "underact_lesson": 1, "title": "A <question>", "about": "One.",
  "steps": [
    {"title": "First", "text": "Look.", "scene": "02_sphere",
     "checks": [{"question": "How many joints?", "answer": 6, "within": 0.1}]},
    {"title": "Second", "text": "Choose.",
     "checks": [{"question": "Which?", "choices": ["this", "that"], "right": 2}]}
  ]})");
}

lesson::AskNumber askedNumber() {
  lesson::AskNumber ask;
  ask.question = "How many?";
  ask.answer = 6.0;
  ask.within = 0.1;
  return ask;
}

}  // namespace

TEST(LessonWords, ACheckIsToDoUntilItIsSolved) {
  lesson::Check check;
  check.task = askedNumber();
  lesson::CheckState state;
  EXPECT_TRUE(checkText(check, state).startsWith("○ Not yet: "));
  state.solved = true;
  EXPECT_TRUE(checkText(check, state).startsWith("✓ Solved: "));
}

TEST(CheckRow, GivesTheNumberThatIsTypedAndTheChoiceThatIsMade) {
  lesson::Check number;
  number.task = askedNumber();
  CheckRow typed(number, 1, nullptr);
  QSignalSpy answered(&typed, &CheckRow::answered);
  auto* field = typed.findChild<QLineEdit*>();
  field->setText("6");
  emit field->returnPressed();
  ASSERT_EQ(answered.count(), 1);
  EXPECT_EQ(answered.first().first().toDouble(), 6.0);
  lesson::Check choice;
  choice.task = lesson::AskChoice{.question = "Which?", .choices = {"this", "that"}, .right = 2};
  CheckRow chosen(choice, 1, nullptr);
  QSignalSpy chose(&chosen, &CheckRow::answered);
  auto* give = chosen.findChild<QPushButton*>();
  give->click();
  EXPECT_EQ(chose.count(), 0) << "nothing is chosen yet";
  chosen.findChildren<QRadioButton*>().at(1)->click();
  give->click();
  ASSERT_EQ(chose.count(), 1);
  EXPECT_EQ(chose.last().first().toDouble(), 2.0);
}

TEST(LessonRun, ARightAnswerSolvesItsStepWhichIsRememberedAndReported) {
  Desk desk(lessonsFeature());
  const QString path = anyLesson(desk);
  LessonRun run({desk.document(), desk.actions(), desk.view(), *desk.services().player, desk.services().host,
                 *desk.services().hand},
                desk.panel<LessonsPanel>());
  QString why;
  ASSERT_TRUE(run.begin(path, why)) << why.toStdString();
  EXPECT_FALSE(run.answer(3, 6.0)) << "there is no such question";
  EXPECT_TRUE(run.answer(0, 4.0));
  EXPECT_FALSE(run.isSolved(0));
  EXPECT_TRUE(run.answer(0, 6.0));
  EXPECT_TRUE(run.isSolved(0));
  EXPECT_TRUE(solvedSteps(path).contains(0));
  const QString report = lessonReport(run, "A. <b>", QDateTime(QDate(2026, 1, 2), QTime(3, 4)));
  EXPECT_TRUE(report.contains("A &lt;question&gt;") && report.contains("A. &lt;b&gt;")) << "nothing typed is HTML";
  EXPECT_TRUE(report.contains("1 of 2 steps"));
  run.leave();
  EXPECT_FALSE(run.isOn());
}

TEST(LessonLibrary, TheShippedOnesAreInTheirOrderAndFoundByName) {
  const std::vector<lesson::Lesson> lessons = shippedLessons();
  ASSERT_GT(lessons.size(), 3U);
  EXPECT_FALSE(solvedSteps("/no/such/lesson.json").contains(0));
}

}  // namespace underact::gui::test
