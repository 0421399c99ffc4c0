#include <gtest/gtest.h>

#include <QApplication>
#include <QFile>
#include <QLabel>
#include <QLineEdit>
#include <QRegularExpression>
#include <QSet>
#include <QTabBar>

#include "app/gui/arms/fix_dialog.h"
#include "app/gui/model/player.h"
#include "app/gui/window/features.h"
#include "tests/stories/access_desk.h"
#include "tests/stories/mesh_desk.h"
#include "tests/stories/session_desk.h"
#include "tests/stories/visitor_desk.h"

namespace underact::gui::test {
namespace {

/// Windows beside the main one that are seen, checked and closed. names: of each, for who asks whether all were.
QStringList wrongInWindows(Story& story, QSet<QString>& names) {
  QStringList wrong;
  int count = 0;
  for (QWidget* widget : QApplication::topLevelWidgets()) {
    if (widget == &story.window() || !widget->isVisible() || widget->windowType() == Qt::ToolTip) continue;
    ++count;
    names.insert(widget->objectName());
    EXPECT_FALSE(spokenName(*widget).isEmpty()) << widget->objectName().toStdString();
    wrong << wronglyNamed(*widget);
    story.bringToFront(widget);
    wrong << wronglyOrdered(story, *widget);
    widget->close();
  }
  EXPECT_GT(count, 0);
  story.settle();
  story.bringToFront(&story.window());
  return wrong;
}

/// Those that Qt makes whole: questions, and choosers of files and printers.
const QSet<QString> kQtsOwn{"dialog.save_plot",
                            "dialog.film",
                            "dialog.add_curve",
                            "dialog.add_mesh",
                            "dialog.address",
                            "dialog.arm_problems",
                            "dialog.class_results_folder",
                            "dialog.class_results_save",
                            "dialog.compare_scene",
                            "dialog.curve_problems",
                            "dialog.delete_session",
                            "dialog.follow",
                            "dialog.guide_pdf",
                            "dialog.guide_pdf_problems",
                            "dialog.guide_print",
                            "dialog.guide_problems",
                            "dialog.language",
                            "dialog.lesson_pdf",
                            "dialog.lesson_pdf_problems",
                            "dialog.lesson_print",
                            "dialog.mesh_problems",
                            "dialog.new_student",
                            "dialog.newer_settings",
                            "dialog.no_visitors",
                            "dialog.not_saved",
                            "dialog.notebook",
                            "dialog.notebook_problems",
                            "dialog.open",
                            "dialog.open_lesson",
                            "dialog.registration_sheet",
                            "dialog.remove_session",
                            "dialog.replay_files",
                            "dialog.save",
                            "dialog.save_calibration",
                            "dialog.save_lesson_report",
                            "dialog.save_session",
                            "dialog.scene_arm",
                            "dialog.second_scene",
                            "dialog.session",
                            "dialog.session_folder",
                            "dialog.session_problems",
                            "dialog.unsaved"};

QString pointsFile() {
  return temporaryFile("points.csv", "x,y,z\n-20,-20,0\n20,-20,0\n20,20,0\n");
}

}  // namespace

TEST(AccessStory, EveryPanelSaysWhatItIsAndTheTabKeyGoesThroughItAsTheEyeDoes) {
  Story story("20_scara");  // with a robot, so that its panel has all it can have
  story.perform("session.start");
  story.run(500);
  for (const PanelRow& row : panelsOf(features())) {
    bringPanel(story, row.key);
    QWidget& panel = *story.find(QString("panel.") + row.key);
    const QStringList wrong = wronglyNamed(panel) + wronglyOrdered(story, panel);
    EXPECT_EQ(wrong.join('\n').toStdString(), "") << row.key;
  }
  for (const QTabBar* tabs : story.window().findChildren<QTabBar*>())
    EXPECT_TRUE(!tabs->isVisible() || !spokenName(*tabs).isEmpty());
}

TEST(AccessStory, SoDoesWhatSomeScenesAndALessonHave) {
  Story story("02_sphere");
  for (const char* scene : {"12_line_pid", "14_circle_influence", "09_wall"}) {
    EXPECT_TRUE(story.perform("scene.open", shippedScene(scene)));
    story.run(250);
    for (const char* key : {"feel", "shape", "scenes"}) {
      bringPanel(story, key);
      QWidget& panel = *story.find(QString("panel.") + key);
      EXPECT_EQ((wronglyNamed(panel) + wronglyOrdered(story, panel)).join('\n').toStdString(), "") << scene << key;
    }
  }
  ASSERT_TRUE(story.perform("lesson.start", QString("01_frames")));
  story.settle();
  QWidget& lesson = *story.find("panel.lessons");
  EXPECT_EQ((wronglyNamed(lesson) + wronglyOrdered(story, lesson)).join('\n').toStdString(), "");
}

TEST(AccessStory, SoDoTheBarsAroundTheViewAndWhatLiesOverIt) {
  Story story("02_sphere");
  story.perform("layer.section", true);
  ASSERT_TRUE(story.perform("compare.on", true));
  story.perform("help.tour");
  story.run(250);
  story.settle();
  for (const char* name :
       {"toolbar", "rail", "menubar", "status", "section", "load", "tour", "view.scene", "compare", "view.beside"}) {
    QWidget& part = *story.find(name);
    EXPECT_EQ((wronglyNamed(part) + wronglyOrdered(story, part)).join('\n').toStdString(), "") << name;
  }
  story.find("tour")->hide();
  story.perform("help.welcome");
  story.run(250);
  EXPECT_EQ(wronglyNamed(*story.find("welcome")).join('\n').toStdString(), "");
  static const QRegularExpression kNotOfTwo("^(?!.* is called as is )");
  EXPECT_EQ(wronglyNamed(story.window()).filter(kNotOfTwo).join('\n').toStdString(), "") << "anywhere, seen or not";
}

TEST(AccessStory, SoDoTheReplayBarTheGhostAndTheWordsOfASession) {
  Desk desk;
  Story& story = *desk.story;
  const QString path = desk.session(500, "short");
  ASSERT_TRUE(desk.choose(path));
  ASSERT_TRUE(story.perform("sessions.edit"));
  QSet<QString> seen;
  EXPECT_EQ(wrongInWindows(story, seen).join('\n').toStdString(), "");
  EXPECT_TRUE(seen.contains("dialog.words"));
  ASSERT_TRUE(story.perform("replay.open", path));
  ASSERT_TRUE(QTest::qWaitFor(
      [&] {
        story.window().frame();
        return story.window().player().isOpen() && !story.window().player().isLoading();
      },
      kLong_ms));
  for (const char* name : {"panel.replay", "panel.session", "panel.sessions"}) {
    if (QString(name) != "panel.replay") bringPanel(story, QString(name).section('.', 1));
    QWidget& part = *story.find(name);
    EXPECT_EQ((wronglyNamed(part) + wronglyOrdered(story, part)).join('\n').toStdString(), "") << name;
  }
  story.perform("replay.close");
  ASSERT_TRUE(story.perform("ghost.open", path));
  const auto isOpen = [&] { return story.window().frame(), story.find("ghost")->isVisible(); };
  ASSERT_TRUE(QTest::qWaitFor(isOpen, kLong_ms));
  QWidget& ghost = *story.find("ghost");
  EXPECT_EQ((wronglyNamed(ghost) + wronglyOrdered(story, ghost)).join('\n').toStdString(), "");
}

TEST(AccessStory, SoDoesEveryDialogAndWizard) {
  Story story("02_sphere");
  QSet<QString> seen;
  QStringList wrong;
  for (const char* name :
       {"help.keys", "help.about", "live.address", "servo.check", "help.figures", "registration.open", "identify.open",
        "help.guide", "help.find", "language.en", "lesson.results"}) {
    EXPECT_TRUE(story.perform(name)) << name;
    story.settle();
    wrong << wrongInWindows(story, seen);
  }
  story.perform("scene.open", temporaryFile("typos.json", R"({"underact_scene": 1, "title": "Typos"})"));
  story.settle();
  wrong << wrongInWindows(story, seen);
  story.perform("scene.open", temporaryFile("manual.pdf", "%PDF-1.7"));
  story.settle();
  wrong << wrongInWindows(story, seen);
  story.perform("scene.arm", temporaryFile("arm.json", R"({"underact_arm": 1, "name": "typos"})"));
  story.settle();
  wrong << wrongInWindows(story, seen);
  for (const QString& file : {temporaryFile("ball.stl", ballStl(30.0, Vec3::Zero(), 24, 12)), pointsFile()}) {
    drop(story, file);
    ASSERT_TRUE(waitForMeshes(story));
    story.settle();
    wrong << wrongInWindows(story, seen);
  }
  const QString slow = temporaryFile("slow_film", "#!/bin/sh\nsleep 2\nexit 1\n");
  QFile::setPermissions(slow, QFileDevice::ReadOwner | QFileDevice::ExeOwner);
  qputenv("UNDERACT_PROGRAM", slow.toLocal8Bit());
  EXPECT_TRUE(story.perform("view.film", temporaryFile("a.webm", "")));
  wrong << wrongInWindows(story, seen);
  qputenv("UNDERACT_PROGRAM", "/bin/false");
  EXPECT_TRUE(QTest::qWaitFor([&] { return story.perform("view.film", temporaryFile("b.webm", "")); }, kLong_ms));
  EXPECT_TRUE(
      QTest::qWaitFor([&story] { return story.window().findChild<QWidget*>("dialog.film_problems"); }, kLong_ms));
  wrong << wrongInWindows(story, seen);
  auto* fix = new FixDialog("Touch, Omni", {{"The driver is missing.", "sudo apt install a-driver"}}, &story.window());
  fix->setAttribute(Qt::WA_DeleteOnClose);
  fix->show();
  wrong << wrongInWindows(story, seen);
  EXPECT_EQ(wrong.join('\n').toStdString(), "");
  for (const HelpPage& row : helpPages(features())) {
    const QString name = row.part;
    const bool is_elsewhere = name == "dialog.fault" || name == "dialog.words";
    if (!name.startsWith("dialog.") || is_elsewhere || kQtsOwn.contains(name)) continue;
    EXPECT_TRUE(seen.contains(name)) << name.toStdString() << " was not looked at";
  }
}

TEST(AccessStory, SoDoWhatIsSaidOfAFaultAndWhatVisitorsSee) {
  VisitorDesk desk;
  desk.plugged_in = false;
  desk.run(100);
  desk.plugged_in = true;
  EXPECT_EQ(wronglyNamed(*desk.find("dialog.fault")).join('\n').toStdString(), "");
  ASSERT_TRUE(desk.begin());
  ASSERT_TRUE(desk.window->actions().perform("visitor.demonstrator"));
  desk.run(100);
  for (const char* name : {"demonstrator", "visitor"})
    EXPECT_EQ(wronglyNamed(*desk.find(name)).join('\n').toStdString(), "") << name;
}

TEST(AccessStory, ALabelSaysItsNameAndItsWordsAndLeadsToWhatItNames) {
  QLineEdit field;
  QLabel label("&Depth");
  label.setBuddy(&field);
  EXPECT_EQ(spokenName(label), "Depth");
  const auto names = QAccessible::queryAccessibleInterface(&label)->relations(QAccessible::Labelled);
  ASSERT_EQ(names.size(), 1);
  EXPECT_EQ(names[0].first->object(), &field);
  label.setBuddy(nullptr);
  label.setAccessibleName("Depth of the tip");
  label.setTextFormat(Qt::RichText);
  label.setText("<b>1.5</b> mm");
  EXPECT_EQ(spokenName(label), "Depth of the tip: 1.5 mm");
  EXPECT_EQ(QAccessible::queryAccessibleInterface(&label)->role(), QAccessible::StaticText);
}

}  // namespace underact::gui::test
