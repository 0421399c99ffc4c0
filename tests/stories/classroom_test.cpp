// A teacher with one computer and thirty students: the next student, lessons on paper, and the table of all.
#include <gtest/gtest.h>

#include <QComboBox>
#include <QDialog>
#include <QDir>
#include <QFile>
#include <QFileDialog>
#include <QFileInfo>
#include <QLabel>
#include <QLineEdit>
#include <QMessageBox>
#include <QPushButton>
#include <QStandardPaths>
#include <QTableWidget>

#include "app/gui/lessons/class_results.h"
#include "app/gui/lessons/lesson_library.h"
#include "core/lesson/results.h"
#include "tests/stories/access_desk.h"
#include "tests/stories/lesson_steps.h"

namespace underact::gui::test {
namespace {

QByteArray contentOf(const QString& path) {
  QFile file(path);
  EXPECT_TRUE(file.open(QIODevice::ReadOnly)) << path.toStdString();
  return file.readAll();
}

/// What stands in the folder where reports are kept that nobody saved.
QStringList keptReports() {
  const QDir kept(QStandardPaths::writableLocation(QStandardPaths::DocumentsLocation) + "/Underact/reports");
  return kept.entryList(QDir::Files, QDir::Name);
}

void doALesson(Story& story) {
  ASSERT_TRUE(story.perform("lesson.start", "04_inverse"));
  story.run(100);
  ASSERT_TRUE(story.perform("lesson.answer", 1, 7));
  ASSERT_TRUE(story.perform("lesson.answer", 1, 8));
  story.find<QLineEdit>("panel.lessons.name")->setText("Zoë / Ż");
}

void askAndAnswer(Story& story, const char* button) {
  ASSERT_TRUE(story.perform("lesson.new_student"));
  story.click(story.find(QString("dialog.new_student.") + button));
  story.settle();
}

QString reportsOfAClass() {
  constexpr const char* kSteps[] = {"Hooke's law",           "How far is that?", "Mass on a spring",
                                    "Read it from a figure", "Critical damping", "The other axis"};
  const QString folder = QFileInfo(temporaryFile("class.mark")).absolutePath() + "/class 7b";
  QDir().mkpath(folder);
  for (int number = 0; number < 30; ++number) {
    lesson::Report report{number == 3 ? std::string() : "Student " + std::to_string(number),
                          "07_stiffness",
                          "Stiffness and damping",
                          "2026-11-28T10:" + std::to_string(10 + number) + ":00",
                          12.0,
                          {}};
    const int stopped = number % 7;
    for (int step = 0; step < 6; ++step) {
      lesson::StepReport& one = report.steps.emplace_back();
      one.title = kSteps[step];
      one.solved = step < stopped;
      one.wrong = step == stopped ? static_cast<std::size_t>(number % 4) * 4 : 0;
      one.attempts = one.wrong + (one.solved ? 1 : 0);
      if (one.wrong > 0 && step == 2) one.misconceptions = {"Square root forgotten", "N/mm not converted to N/m"};
      if (one.wrong > 0 && step == 3) one.misconceptions = {"Factor 2 forgotten"};
    }
    QFile file(folder + QString("/report%1.html").arg(number));
    EXPECT_TRUE(file.open(QIODevice::WriteOnly));
    file.write(QByteArray::fromStdString("<html><head>" + reportData(report) + "</head></html>"));
  }
  QFile other(folder + "/holidays.html");
  EXPECT_TRUE(other.open(QIODevice::WriteOnly));
  return folder;
}

}  // namespace

TEST(ClassroomStory, ANewStudentFindsNothingOfTheLastOneWhoseReportIsKept) {
  Story story("02_sphere");
  doALesson(story);
  ASSERT_FALSE(solvedSteps(lessonPath("04_inverse")).isEmpty());
  askAndAnswer(story, "cancel");
  EXPECT_FALSE(solvedSteps(lessonPath("04_inverse")).isEmpty());
  EXPECT_EQ(keptReports(), QStringList());
  ASSERT_TRUE(story.perform("lesson.new_student"));
  EXPECT_TRUE(story.find<QMessageBox>("dialog.new_student")->informativeText().contains("04_inverse-report-Zoë-Ż.html"))
      << "it says where";
  story.click(story.find("dialog.new_student.begin"));
  story.settle();
  EXPECT_EQ(story.find<QLineEdit>("panel.lessons.name")->text(), "");
  EXPECT_TRUE(solvedSteps(lessonPath("04_inverse")).isEmpty());
  EXPECT_EQ(stepTitle(story), "How many?") << "no tick, and the lesson is there for the next";
  ASSERT_EQ(keptReports(), QStringList{"04_inverse-report-Zoë-Ż.html"});
  askAndAnswer(story, "begin");
  EXPECT_EQ(keptReports().size(), 1) << "of a student who did nothing there is none";
}

TEST(ClassroomStory, AReportThatWasSavedIsNotKeptTwiceAndSaysWhatTheTableNeeds) {
  Story story("02_sphere");
  doALesson(story);
  const qsizetype before = keptReports().size();
  const QString path = temporaryFile("zoe.html");
  ASSERT_TRUE(story.perform("lesson.report", path));
  askAndAnswer(story, "begin");
  EXPECT_EQ(keptReports().size(), before);
  const QByteArray page = contentOf(path);
  const Result<lesson::Report> report =
      lesson::readReport({page.data(), static_cast<std::size_t>(page.size())}, "zoe.html");
  ASSERT_TRUE(report) << describe(report.problems().front());
  EXPECT_EQ(report.value().student, "Zoë / Ż");
  EXPECT_EQ(report.value().lesson, "04_inverse");
  ASSERT_EQ(report.value().steps.size(), 6u);
  EXPECT_TRUE(report.value().steps[0].solved);
  EXPECT_EQ(report.value().steps[0].attempts, 2u);
  EXPECT_EQ(report.value().steps[0].wrong, 1u);
}

TEST(ClassroomStory, WhereTheReportCannotBeKeptNothingIsCleared) {
  Story story("02_sphere");
  doALesson(story);
  const QString folder = QStandardPaths::writableLocation(QStandardPaths::DocumentsLocation) + "/Underact";
  QDir(folder).removeRecursively();
  QDir().mkpath(QFileInfo(folder).path());
  QFile in_the_way(folder);
  ASSERT_TRUE(in_the_way.open(QIODevice::WriteOnly));
  askAndAnswer(story, "begin");
  EXPECT_EQ(story.find<QLineEdit>("panel.lessons.name")->text(), "Zoë / Ż");
  EXPECT_TRUE(story.find<QLabel>("panel.lessons.note")->text().startsWith("Not saved"));
  in_the_way.remove();
}

TEST(ClassroomStory, TheReportsFileIsProposedWithTheStudentsName) {
  Story story("02_sphere");
  doALesson(story);
  ASSERT_TRUE(story.perform("lesson.report"));
  const auto* const dialog = story.find<QFileDialog>("dialog.save_lesson_report");
  EXPECT_TRUE(dialog->selectedFiles().value(0).endsWith("/04_inverse-report-Zoë-Ż.html"));
}

TEST(ClassroomStory, LessonsAndPagesOfTheGuideArePrintedAndSavedAsPdf) {
  Story story("02_sphere");
  EXPECT_FALSE(story.perform("lesson.pdf"));
  doALesson(story);
  ASSERT_TRUE(story.perform("lesson.print"));
  story.find<QDialog>("dialog.lesson_print")->reject();
  const auto saved = [&story](const char* name, const QString& path) {
    auto* const dialog = story.find<QFileDialog>(name);
    emit dialog->fileSelected(path);
    dialog->reject();
    return contentOf(path);
  };
  ASSERT_TRUE(story.perform("lesson.pdf"));
  EXPECT_TRUE(saved("dialog.lesson_pdf", temporaryFile("lesson.pdf")).startsWith("%PDF-"));
  ASSERT_TRUE(story.perform("help.guide", "experiments"));
  story.click(story.find("guide.pdf"));
  EXPECT_GE(saved("dialog.guide_pdf", temporaryFile("guide.pdf")).count("/Type /Page\n"), 13);
  story.click(story.find("guide.print"));
  story.find<QDialog>("dialog.guide_print")->reject();
}

TEST(ClassroomStory, AFolderOfThirtyReportsIsATableThatIsSortedAndSaved) {
  Story story("02_sphere");
  ASSERT_TRUE(story.perform("lesson.results"));
  auto* const dialog = story.find<ClassResults>("dialog.class_results");
  const auto* const message = story.find<QLabel>("dialog.class_results.message");
  EXPECT_TRUE(message->text().startsWith("Choose the folder")) << "what to do";
  EXPECT_FALSE(story.find("dialog.class_results.csv")->isEnabled());
  const QString folder = reportsOfAClass();
  ASSERT_TRUE(story.perform("lesson.results", folder));
  EXPECT_EQ(story.find<ClassResults>("dialog.class_results"), dialog) << "there is one";
  EXPECT_EQ(message->text(), "Reports in class 7b: 30") << message->text().toStdString();
  EXPECT_TRUE(story.find<QLabel>("dialog.class_results.unread")->text().startsWith("holidays.html: "));
  const auto* const table = story.find<QTableWidget>("dialog.class_results.table");
  ASSERT_EQ(table->rowCount(), 30);
  EXPECT_EQ(table->item(0, 0)->text(), "Student 0");
  EXPECT_EQ(table->item(29, 0)->text(), "(no name)");
  EXPECT_EQ(table->item(0, 4)->text(), "1. Hooke's law");
  EXPECT_EQ(table->findItems("3. Mass on a spring", Qt::MatchExactly).size(), 4);
  EXPECT_GE(table->findItems("Square root forgotten", Qt::MatchExactly).size(), 2);
  story.find<QComboBox>("dialog.class_results.order")->setCurrentIndex(5);
  EXPECT_EQ(table->item(29, 5)->text(), "12") << "by number";
  EXPECT_EQ(table->item(0, 5)->text(), "0");
  for (const char* theme : {"light", "dark"}) {
    story.perform(QString("view.theme.%1").arg(theme));
    story.settle(200);
    const QString folder_of_pictures = qEnvironmentVariableIsSet("UNDERACT_UPDATE_PICTURES")
                                           ? QString(UNDERACT_SOURCE) + "/resources/pictures"
                                           : QString(UNDERACT_BINARY) + "/pictures";
    QDir().mkpath(folder_of_pictures);
    EXPECT_TRUE(dialog->grab().save(folder_of_pictures + QString("/class_results_%1.png").arg(theme)));
  }
  EXPECT_EQ((wronglyNamed(*dialog) + wronglyOrdered(story, *dialog)).join('\n').toStdString(), "");
  const QString csv = temporaryFile("class.csv"), moodle = temporaryFile("moodle.csv");
  const Result<lesson::ClassResults> read = lesson::readResults(folder.toStdString());
  ASSERT_TRUE(read);
  EXPECT_TRUE(dialog->save(csv, false));
  EXPECT_EQ(contentOf(csv).toStdString(), resultsCsv(read.value())) << "as the command prints it";
  EXPECT_TRUE(dialog->save(moodle, true));
  EXPECT_EQ(contentOf(moodle).toStdString(), moodleCsv(read.value()));
  EXPECT_TRUE(message->text().endsWith("Left out, as they have no name: 1.")) << message->text().toStdString();
  EXPECT_FALSE(dialog->save("/nowhere/class.csv", false));
  dialog->read("/nowhere");
  EXPECT_EQ(table->rowCount(), 30) << "what was shown stays";
}

}  // namespace underact::gui::test
