#include <gtest/gtest.h>

#include <QApplication>
#include <QDir>
#include <QFile>
#include <QFileInfo>
#include <QLabel>
#include <QLineEdit>
#include <QListWidget>
#include <QMessageBox>
#include <QSettings>
#include <QTextEdit>
#include <QTimer>

#include "app/gui/lessons/lesson_card.h"
#include "app/gui/lessons/lesson_library.h"
#include "core/base/units.h"
#include "core/lesson/read.h"
#include "tests/stories/lesson_steps.h"

namespace underact::gui::test {
namespace {

QString givenOf(Story& story, int check) {
  return story.find<QLabel>(QString("panel.lessons.check%1.said").arg(check))->text();
}

/// What the question about edits, which comes next, is answered.
void answerUnsaved(QMessageBox::StandardButton button) {
  QTimer::singleShot(100, [button] {
    auto* const box = qobject_cast<QMessageBox*>(QApplication::activeModalWidget());
    ASSERT_NE(box, nullptr);
    EXPECT_EQ(box->objectName(), "dialog.unsaved");
    box->button(button)->click();
  });
}

/// By the Tab key, from wherever the focus is.
void tabTo(Story& story, const QString& name) {
  QWidget* const widget = story.find(name);
  for (int tabs = 0; tabs < 80 && !widget->hasFocus(); ++tabs) story.key(Qt::Key_Tab);
  EXPECT_TRUE(widget->hasFocus()) << name.toStdString();
}

void typeAnswer(Story& story, int check, const QString& text) {
  tabTo(story, QString("panel.lessons.check%1.number").arg(check));
  story.key(Qt::Key_A, Qt::ControlModifier);
  for (const QChar letter : text) QTest::keyClick(story.window().windowHandle(), letter.toLatin1());
  story.key(Qt::Key_Return);
}

/// Arrow keys in the view: so many steps of 10 mm, or of 2 mm without Shift.
void steps(Story& story, Qt::Key key, int count, Qt::KeyboardModifiers modifiers = Qt::ShiftModifier) {
  for (int step = 0; step < count; ++step) {
    QTest::keyPress(story.window().windowHandle(), key, modifiers);
    story.run(100);
    QTest::keyRelease(story.window().windowHandle(), key, modifiers);
  }
  story.run(500);
}

}  // namespace

TEST(LessonsStory, TheFirstLessonIsSolvedByTheKeyboardAlone) {
  Story story("02_sphere");
  story.key(Qt::Key_L, Qt::ControlModifier);  // the panel
  auto* const list = story.find<QListWidget>("panel.lessons.list");
  ASSERT_TRUE(list->isVisible());
  tabTo(story, "panel.lessons.list");
  for (int row = 0; row < 3 && list->currentItem() == nullptr; ++row) story.key(Qt::Key_Down);
  ASSERT_NE(list->currentItem(), nullptr);
  EXPECT_EQ(list->currentItem()->text(), "Frames and transforms");
  story.key(Qt::Key_Return);
  story.settle();
  ASSERT_EQ(stepTitle(story), "The frame W");
  story.key(Qt::Key_1, Qt::ControlModifier);  // the view from the front
  story.settle(400);
  story.key(Qt::Key_F2);  // the arrow keys move the hand; it starts at (0, 0, 50)
  steps(story, Qt::Key_Right, 4);
  steps(story, Qt::Key_Left, 4);
  steps(story, Qt::Key_Up, 4);
  EXPECT_TRUE(givenOf(story, 1).contains("2 of 3 reached")) << givenOf(story, 1).toStdString();
  steps(story, Qt::Key_Down, 4);
  steps(story, Qt::Key_PageUp, 4);
  EXPECT_TRUE(stepTitle(story).contains("✓")) << givenOf(story, 1).toStdString();
  story.key(Qt::Key_F8);  // next
  ASSERT_EQ(stepTitle(story), "The same position in B");
  story.run(500);
  const Vec3 p_mm = 1e3 * story.snapshot().report.p_WT;
  typeAnswer(story, 1, QString::number(p_mm.z() + 176.0));
  typeAnswer(story, 2, QString::number(p_mm.x()));
  typeAnswer(story, 3, "much");
  EXPECT_EQ(givenOf(story, 3), "“much” is not a number.");
  typeAnswer(story, 3, QString::number(p_mm.y() - 30.0));
  EXPECT_TRUE(stepTitle(story).contains("✓")) << givenOf(story, 3).toStdString();
  story.key(Qt::Key_F8);
  story.key(Qt::Key_1, Qt::ControlModifier);  // the view from the front
  story.settle(400);
  story.key(Qt::Key_F2);
  steps(story, Qt::Key_Up, 4);  // to (0, 40, 40) from where each step begins, (0, 0, 50)
  steps(story, Qt::Key_PageUp, 1);
  story.run(1500);
  EXPECT_TRUE(stepTitle(story).contains("✓")) << givenOf(story, 1).toStdString();
  story.key(Qt::Key_F8);
  story.key(Qt::Key_F2);
  story.settle(400);  // the camera goes to the front
  for (int turn = 0; turn < 40 && !stepTitle(story).contains("✓"); ++turn)
    steps(story, Qt::Key_Up, 1, Qt::ControlModifier);
  EXPECT_TRUE(stepTitle(story).contains("✓")) << givenOf(story, 1).toStdString();
  story.key(Qt::Key_F8);
  for (int check = 1; check <= 2; ++check) {
    tabTo(story, QString("panel.lessons.check%1.choice1").arg(check));
    story.key(Qt::Key_Space);
    for (int down = 1; down < (check == 1 ? 3 : 1); ++down) story.key(Qt::Key_Down);
    tabTo(story, QString("panel.lessons.check%1.give").arg(check));
    story.key(Qt::Key_Space);
  }
  EXPECT_TRUE(stepTitle(story).contains("✓"));
  EXPECT_EQ(solvedSteps(lessonPath("01_frames")).size(), 5);
  story.byPalette("leave the lesson");
  EXPECT_TRUE(story.find("panel.lessons.list")->isVisible());
}

TEST(LessonsStory, AWrongHandIsToldWhatIsMissing) {
  Story story("02_sphere");
  ASSERT_TRUE(story.perform("lesson.start", "07_stiffness"));
  story.settle();
  EXPECT_TRUE(story.find("panel.lessons.servo")->isVisible());  // nothing pushes yet
  story.perform("session.start");
  leadHand(story, {0, 0, 0});
  leadHand(story, {3, 0, 0});
  EXPECT_FALSE(story.find("panel.lessons.servo")->isVisible());
  const QString missing = givenOf(story, 1);
  EXPECT_TRUE(missing.startsWith("○ Not yet: Held for 0.0 of 1.0 s. The force is 0.1")) << missing.toStdString();
  EXPECT_TRUE(missing.endsWith("it should be between 0.35 N and 0.45 N.")) << missing.toStdString();
  EXPECT_FALSE(stepTitle(story).contains("✓"));
  leadHand(story, {9.3, 0, 0});
  leadHand(story, {9.3, 0, 0});
  EXPECT_TRUE(givenOf(story, 1).startsWith("✓ Solved: Held for 1.0 of 1.0 s.")) << givenOf(story, 1).toStdString();
  EXPECT_TRUE(stepTitle(story).contains("✓"));
}

TEST(LessonsStory, TheGainsThatAStudentSetsCount) {
  Story story("02_sphere");
  ASSERT_TRUE(story.perform("lesson.start", "07_stiffness"));
  ASSERT_TRUE(story.perform("lesson.next"));
  ASSERT_TRUE(story.perform("lesson.next"));
  story.perform("session.start");
  leadHand(story, {0, 0, 0});
  leadHand(story, {8, 0, 0});
  EXPECT_TRUE(givenOf(story, 1).contains("○"));
  ASSERT_TRUE(story.perform("gains.set", "kp", "x", 0.1));
  story.run(3000);
  EXPECT_TRUE(givenOf(story, 1).contains("✓")) << givenOf(story, 1).toStdString();
  EXPECT_TRUE(givenOf(story, 2).contains("✓")) << givenOf(story, 2).toStdString();
  ASSERT_TRUE(story.perform("lesson.next"));  // nobody is asked what becomes of an exercise's gains
}

TEST(LessonsStory, AReportSaysWhatWasDoneAndNamesNobodyUnasked) {
  Story story("02_sphere");
  EXPECT_FALSE(story.perform("lesson.report", temporaryFile("none.html")));
  ASSERT_TRUE(story.perform("lesson.start", "04_inverse"));
  story.run(100);
  EXPECT_FALSE(story.perform("lesson.answer", 2, 8));
  ASSERT_TRUE(story.perform("lesson.answer", 1, 7));
  EXPECT_TRUE(givenOf(story, 1).contains("7 is not correct")) << givenOf(story, 1).toStdString();
  ASSERT_TRUE(story.perform("lesson.answer", 1, 8));
  const auto report = [&story] {
    const QString path = temporaryFile("report.html");
    EXPECT_TRUE(story.perform("lesson.report", path));
    EXPECT_TRUE(story.find<QLabel>("panel.lessons.note")->text().contains("report.html"));
    QFile file(path);
    EXPECT_TRUE(file.open(QIODevice::ReadOnly));
    return QString::fromUtf8(file.readAll());
  };
  const QString first = report();
  EXPECT_TRUE(first.contains("<h1>Eight inverse solutions</h1>"));
  EXPECT_TRUE(first.contains("1 of 6 steps"));
  EXPECT_TRUE(first.contains("✓ Solved: 8")) << first.toStdString();
  EXPECT_TRUE(first.contains("Underact "));
  EXPECT_FALSE(first.contains("<th>Name</th>"));
  story.find<QLineEdit>("panel.lessons.name")->setText("A. & B.");
  EXPECT_TRUE(report().contains("<th>Name</th><td>A. &amp; B.</td>"));
  EXPECT_FALSE(story.perform("lesson.report", "/nowhere/report.html"));
  EXPECT_TRUE(story.find<QLabel>("panel.lessons.note")->text().startsWith("Not saved"));
}

TEST(LessonsStory, AfterALessonTheWindowIsAsBefore) {
  Story story("05_circle");
  story.perform("layer.ghosts", true);
  story.perform("dock.plots", false);
  const std::string before = shapeOf(story);
  ASSERT_TRUE(story.perform("lesson.start", "05_jacobian"));
  story.settle();
  EXPECT_NE(shapeOf(story), before);
  EXPECT_TRUE(isPanelOpen(story, "kinematics"));
  EXPECT_TRUE(isPanelOpen(story, "lessons"));
  EXPECT_FALSE(isPanelOpen(story, "scenes"));
  EXPECT_TRUE(story.view().layers().motion_ellipsoid);
  ASSERT_TRUE(story.perform("lesson.next"));
  ASSERT_TRUE(story.perform("lesson.back"));
  EXPECT_FALSE(story.perform("lesson.back"));
  ASSERT_TRUE(story.perform("lesson.leave"));
  story.settle();
  EXPECT_EQ(shapeOf(story), before);
  EXPECT_FALSE(story.perform("lesson.leave"));
  EXPECT_FALSE(story.perform("lesson.next"));
}

TEST(LessonsStory, TheKeyboardBeginsWithTheTextAndNotWithBack) {
  Story story("02_sphere");
  ASSERT_TRUE(story.perform("dock.lessons", true));
  for (const char* focus : {"panel.lessons.list", "panel.feel.law"}) {  // the second one goes with its panel
    story.find(focus)->setFocus(Qt::TabFocusReason);
    ASSERT_TRUE(story.perform("lesson.start", "01_frames"));
    story.settle();
    EXPECT_FALSE(story.find("panel.lesson.back")->hasFocus()) << focus;
    ASSERT_TRUE(story.perform("lesson.leave"));
    story.settle();
  }
  story.find("panel.lessons.list")->setFocus(Qt::TabFocusReason);
  ASSERT_TRUE(story.perform("lesson.start", "04_inverse"));
  story.settle();
  EXPECT_TRUE(story.find("panel.lessons.text")->hasFocus()) << QApplication::focusWidget()->objectName().toStdString();
  while (story.perform("lesson.next")) {
    EXPECT_FALSE(story.find("panel.lesson.back")->hasFocus());
    auto* const number = story.window().findChild<QWidget*>("panel.lessons.check1.number");
    (number != nullptr ? number : story.find("panel.lesson.next"))->setFocus(Qt::TabFocusReason);
  }
  story.settle();
  EXPECT_FALSE(story.find("panel.lesson.back")->hasFocus());
}

TEST(LessonsStory, TheGhostOfALessonDoesNotStayInTheNext) {
  Story story("02_sphere");
  ASSERT_TRUE(story.perform("lesson.start", "04_inverse"));
  story.settle();
  story.run(300);
  ASSERT_TRUE(story.perform("solution.show", 3));
  ASSERT_TRUE(story.view().chosenSolution_rad().has_value());
  ASSERT_TRUE(story.perform("lesson.start", "05_jacobian"));
  story.settle();
  story.run(300);
  EXPECT_FALSE(story.view().chosenSolution_rad().has_value());
}

TEST(LessonsStory, EditsFromBeforeAreAskedAboutAndNotLost) {
  QFile shipped(shippedScene("02_sphere"));
  ASSERT_TRUE(shipped.open(QIODevice::ReadOnly));
  Story story(temporaryFile("own_sphere.json", shipped.readAll()));  // of one that ships nobody is asked
  story.perform("gains.set", "kp", "x", 0.7);
  answerUnsaved(QMessageBox::Cancel);
  EXPECT_FALSE(story.perform("lesson.start", "06_statics"));
  EXPECT_EQ(story.host().scene().title, "Sphere");
  EXPECT_DOUBLE_EQ(story.host().scene().control.gains.kp_N_per_mm.x(), 0.7);
  answerUnsaved(QMessageBox::Discard);
  ASSERT_TRUE(story.perform("lesson.start", "06_statics"));
  EXPECT_EQ(story.host().scene().title, "Point");
  story.perform("lesson.leave");
  EXPECT_EQ(story.host().scene().title, "Sphere");
}

TEST(LessonsStory, AWindowClosedInALessonKeepsItsOwnSceneAndDocks) {
  {
    Story story("05_circle");
    ASSERT_TRUE(story.perform("lesson.start", "06_statics"));
    story.perform("gains.set", "kp", "x", 0.3);  // an exercise: nobody is asked
  }
  EXPECT_TRUE(QSettings().value("files/last").toString().endsWith("05_circle.json"));
  Story again("", {.first_start = false});
  EXPECT_TRUE(isPanelOpen(again, "scenes"));
  EXPECT_TRUE(isPanelOpen(again, "feel"));
}

TEST(LessonsStory, ASceneThatWasOpenedMeanwhileStays) {
  Story story("02_sphere");
  ASSERT_TRUE(story.perform("lesson.start", "06_statics"));
  ASSERT_TRUE(story.perform("scene.open", shippedScene("04_plane")));
  ASSERT_TRUE(story.perform("lesson.leave"));
  EXPECT_EQ(story.host().scene().title, "Tilted plane");
}

TEST(LessonsStory, TheHintComesWhereItIsAskedFor) {
  Story story("02_sphere");
  ASSERT_TRUE(story.perform("lesson.start", "01_frames"));
  auto* const text = story.find<QTextEdit>("panel.lessons.text");
  EXPECT_FALSE(text->toPlainText().contains("Hint:"));
  ASSERT_TRUE(story.perform("lesson.hint"));
  EXPECT_TRUE(text->toPlainText().contains("Hint:"));
  EXPECT_FALSE(story.perform("lesson.hint"));
  EXPECT_FALSE(story.window().actions().find("lesson.hint")->isEnabled());
}

TEST(LessonsStory, ATeachersFileIsOpenedDroppedAndListedLately) {
  const QString path = temporaryFile("springs.json", R"({"underact_lesson": 1, "title": "My springs", "steps": [
    {"title": "Pull", "text": "Pull at it.", "scene": "01_point", "checks": [{"measure": "force_N", "above": 0.2}]}]})");
  {
    Story story("02_sphere");
    ASSERT_TRUE(story.perform("scene.open", path));  // as a drop does, and the command line
    EXPECT_EQ(stepTitle(story), "Pull");
    EXPECT_EQ(story.host().scene().title, "Point");
    story.perform("lesson.leave");
    EXPECT_EQ(story.host().scene().title, "Sphere");
  }
  Story again("02_sphere", {.first_start = false});
  again.perform("dock.lessons", true);
  auto* const list = again.find<QListWidget>("panel.lessons.list");
  EXPECT_EQ(list->findItems("My springs", Qt::MatchExactly).size(), 1);
}

TEST(LessonsStory, AFileWithMistakesIsToldAndNothingChanges) {
  const QString path =
      temporaryFile("bad.json", R"({"underact_lesson": 1, "titel": "x", "steps": [{"title": "a", "text": "b"}]})");
  Story story("02_sphere");
  const QString before = story.window().document().path();
  EXPECT_FALSE(story.perform("lesson.open", path));
  EXPECT_TRUE(story.find<QLabel>("panel.lessons.why")->text().contains("bad.json"));
  EXPECT_EQ(story.window().document().path(), before);
  EXPECT_FALSE(story.perform("lesson.next"));
}

TEST(LessonsStory, WhatWasSolvedIsRememberedAndGoesOnThere) {
  {
    Story story("02_sphere");
    ASSERT_TRUE(story.perform("lesson.start", "02_dh"));
    ASSERT_TRUE(story.perform("lesson.answer", 1, 127.5));
    ASSERT_TRUE(story.perform("lesson.answer", 2, 149.4));
    EXPECT_TRUE(stepTitle(story).contains("✓"));
  }
  Story story("02_sphere", {.first_start = false});
  story.perform("dock.lessons", true);
  const auto* const list = story.find<QListWidget>("panel.lessons.list");
  const QList<QListWidgetItem*> cards = list->findItems("Denavit-Hartenberg parameters", Qt::MatchExactly);
  ASSERT_EQ(cards.size(), 1);
  EXPECT_EQ(cards.front()->data(LessonCard::Number).toInt(), 2);
  EXPECT_EQ(cards.front()->data(LessonCard::Solved).toInt(), 1);
  EXPECT_EQ(cards.front()->toolTip(), "12 min, 1 of 5 steps solved");
  EXPECT_EQ(story.host().scene().title, "Sphere");  // the lesson was left with the window
  ASSERT_TRUE(story.perform("lesson.start", "02_dh"));
  EXPECT_EQ(stepTitle(story), "One of them changes");
}

/// A picture of each lesson for the guide: its first step, smaller than the window.
TEST(LessonsStory, PicturesOfEachLesson) {
  Story story("02_sphere");
  const QString folder = QString(UNDERACT_BINARY) + "/pictures/lessons";
  QDir().mkpath(folder);
  for (const lesson::Lesson& lesson : shippedLessons()) {
    const QString path = QString::fromStdString(lesson.file);
    ASSERT_TRUE(story.perform("lesson.start", path));
    story.run(500);
    story.settle(300);
    const QImage whole = story.picture();
    EXPECT_EQ(whole.size(), QSize(1280, 800));
    const QImage small = whole.scaledToWidth(800, Qt::SmoothTransformation);
    const QString name = "/" + QFileInfo(path).completeBaseName() + ".png";
    EXPECT_TRUE(small.save(folder + name));
    if (!qEnvironmentVariableIsSet("UNDERACT_UPDATE_PICTURES")) continue;
    const QString kept = QString(UNDERACT_SOURCE) + "/resources/pictures/lessons";
    QDir().mkpath(kept);
    EXPECT_TRUE(small.save(kept + name));
  }
}

TEST(LessonsStory, AtTheSmallestUsableSizeItCanStillBeDone) {
  Story story("02_sphere", {.size = {1024, 700}});
  story.perform("dock.lessons", true);
  ASSERT_TRUE(story.perform("lesson.start", "02_dh"));
  ASSERT_TRUE(story.perform("lesson.answer", 1, 127.5));
  ASSERT_TRUE(story.perform("lesson.answer", 2, 150));
  story.run(500);
  story.settle(300);
  EXPECT_TRUE(story.picture().save(QString(UNDERACT_BINARY) + "/pictures/lesson_small.png"));
  for (const char* name : {"panel.lesson.next", "panel.lesson.report", "panel.lessons.check1.number"}) {
    const QWidget* const widget = story.find(name);
    EXPECT_TRUE(story.window().rect().contains({widget->mapTo(&story.window(), QPoint()), widget->size()})) << name;
    EXPECT_GE(widget->width(), widget->minimumSizeHint().width()) << name;
  }
  EXPECT_GE(story.view().width(), 320);
  story.perform("lesson.leave");
  story.settle(100);
  EXPECT_TRUE(story.picture().save(QString(UNDERACT_BINARY) + "/pictures/lessons_list.png"));
}

TEST(LessonsStory, InTheDarkItCanBeRead) {
  Story story("02_sphere");
  story.perform("view.theme.dark");
  ASSERT_TRUE(story.perform("lesson.start", "03_forward"));
  story.run(500);
  story.settle(300);
  EXPECT_TRUE(story.picture().save(QString(UNDERACT_BINARY) + "/pictures/lesson_dark.png"));
  const QImage text = story.find("panel.lessons.text")->grab().toImage();
  EXPECT_LT(qGray(text.pixel(2, text.height() - 2)), 80);  // no white page in a dark window
}

}  // namespace underact::gui::test
