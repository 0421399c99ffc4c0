#include <gtest/gtest.h>

#include <QDropEvent>
#include <QFileDialog>
#include <QLabel>
#include <QMimeData>
#include <QProcess>

#include "app/gui/model/player.h"
#include "core/arm/arm_text.h"
#include "tests/stories/mesh_desk.h"
#include "tests/stories/story.h"
#include "tests/stories/titles_on_screen.h"

namespace underact::gui::test {
namespace {

QString ball() {
  return temporaryFile("ball.bin", ballStl(20.0, Vec3::Zero(), 12, 8));
}
QString urdf() {
  return temporaryFile("robot.URDF",
                       QByteArray::fromStdString(arm::textOf(*arm::findModel("ur5e"), arm::ArmForm::Urdf).value()));
}
QString session() {
  return QString(UNDERACT_SOURCE) + "/tests/golden/session.h5";
}
QString manual() {
  return temporaryFile("manual.stl", "%PDF-1.7\n");
}

/// A file of each kind under a name that does not tell, what a drop is announced as, and a part of the title of the
/// window that it opens.
struct OfKind {
  QString path, announced, title;
};
std::vector<OfKind> ofEachKind() {
  QFile scene(shippedScene("04_plane"));
  EXPECT_TRUE(scene.open(QIODevice::ReadOnly));
  const QString lesson = R"({"underact_lesson": 1, "title": "L", "steps": [{"title": "S", "text": "T",
    "scene": "01_point"}]})";
  return {{temporaryFile("scene.txt", scene.readAll()), "Drop to open the scene", "Tilted plane"},
          {session(), "Drop to replay the session", "SCARA"},
          {urdf(), "Drop to give the scene this arm", "Sphere*"},
          {ball(), "Drop to hold the stylus to this mesh", "Mesh ball.bin"},
          {temporaryFile("path", "0 0 0\n9 9 9\n"), "Drop to hold the stylus to this curve", "Curve path"},
          {temporaryFile("lesson.txt", lesson.toUtf8()), "Drop to begin the lesson", "Point"},
          {temporaryFile("figures.txt", R"([{"figure": "4.5", "numbers": []}])"), "Drop to look at these figures",
           "Figures of the thesis"},
          {temporaryFile("book.json", R"({"cells": [], "nbformat": 4})"),
           "Drop to open the notebook in another program", "Notebook"},
          {manual(), "This is a PDF document. Underact opens ", "File not opened"}};
}

struct Drag {
  explicit Drag(const QList<QUrl>& urls) { data.setUrls(urls); }
  bool enter(Story& story) {
    QDragEnterEvent event(where, Qt::CopyAction | Qt::MoveAction, &data, Qt::LeftButton, {});
    event.setDropAction(Qt::MoveAction);
    QApplication::sendEvent(&story.window(), &event);
    EXPECT_TRUE(!event.isAccepted() || event.dropAction() == Qt::CopyAction);
    return event.isAccepted();
  }
  bool move(Story& story) {
    QDragMoveEvent event(where, Qt::CopyAction, &data, Qt::LeftButton, {});
    QApplication::sendEvent(&story.window(), &event);
    return event.isAccepted();
  }
  void leave(Story& story) {
    QDragLeaveEvent event;
    QApplication::sendEvent(&story.window(), &event);
  }
  QPoint where{20, 300};
  QMimeData data;
};

QString announced(Story& story) {
  return story.find("drop")->isVisible() ? story.find<QLabel>("drop.sentence")->text() : QString();
}

void lookAside(Story& story) {
  Viewpoint aside = story.view().viewpoint();
  aside.camera.focus_mm += Vec3(300.0, 0.0, 0.0);
  aside.fits = false;
  story.view().setViewpoint(aside);
}

}  // namespace

TEST(OpeningStory, ADragSaysWhatDroppingDoesUntilItLeaves) {
  Story story("02_sphere");
  story.perform("view.theme.dark");
  for (const OfKind& one : ofEachKind()) {
    Drag drag({QUrl::fromLocalFile(one.path)});
    EXPECT_TRUE(drag.enter(story)) << "or nobody would say that it has left";
    EXPECT_TRUE(announced(story).startsWith(one.announced)) << announced(story).toStdString();
    EXPECT_EQ(story.find<QLabel>("drop.file")->text(), QFileInfo(one.path).fileName());
    EXPECT_EQ(drag.move(story), one.path != manual());
    if (one.path == manual()) keepPicture(story, "window", "drop_refused_dark");
    if (one.path == ball()) keepPicture(story, "window", "drop_mesh_dark");
    drag.leave(story);
    EXPECT_EQ(announced(story), QString());
  }
  story.perform("view.theme.light");
  Drag mesh({QUrl::fromLocalFile(ball())});
  mesh.enter(story);
  keepPicture(story, "window", "drop_mesh_light");
  EXPECT_FALSE(story.find("drop")->accessibleName().isEmpty());
  mesh.leave(story);
  Drag both({QUrl::fromLocalFile(ball()), QUrl::fromLocalFile(urdf())});
  both.enter(story);
  EXPECT_EQ(announced(story), QString("Drop one file at a time."));
  EXPECT_FALSE(both.move(story));
  Drag far({QUrl("https://example.org/ball.stl")});
  far.enter(story);
  EXPECT_TRUE(announced(story).contains("not on this computer"));
  far.leave(story);
  QMimeData words;
  words.setText("a text from an editor");
  QDragEnterEvent text(QPoint(9, 9), Qt::CopyAction, &words, Qt::LeftButton, {});
  QApplication::sendEvent(&story.window(), &text);
  EXPECT_FALSE(text.isAccepted());
}

TEST(OpeningStory, NoPartOfTheWindowTakesADropForItself) {
  Story story("02_sphere");
  for (const QString& name : story.window().actions().names())
    if (name.startsWith("dock.")) story.perform(name, true);
  for (const QWidget* one : story.window().findChildren<QWidget*>())
    EXPECT_FALSE(one->acceptDrops() && one->window() == &story.window())
        << one->objectName().toStdString() << " " << one->metaObject()->className();
}

TEST(OpeningStory, WhatIsOpenedIsInTheView) {
  {
    Story story("02_sphere");
    lookAside(story);
    drop(story, shippedScene("04_plane"));
    EXPECT_TRUE(story.view().viewpoint().fits) << "a scene";
    lookAside(story);
    openMesh(story, ball());
    EXPECT_TRUE(story.view().viewpoint().fits) << "a mesh";
    lookAside(story);
    drop(story, urdf());
    EXPECT_TRUE(story.view().viewpoint().fits) << "an arm";
  }
  Story story("02_sphere");
  lookAside(story);
  drop(story, session());
  ASSERT_TRUE(QTest::qWaitFor([&] {
    story.window().frame();
    return story.window().player().isOpen();
  }));
  EXPECT_TRUE(story.view().viewpoint().fits) << "a session";
}

TEST(OpeningStory, TheDialogOpensAFileOfEachKind) {
  for (const OfKind& one : ofEachKind()) {
    Story story("02_sphere");
    ASSERT_TRUE(story.perform("scene.open"));
    auto* const dialog = story.find<QFileDialog>("dialog.open");
    ASSERT_NE(dialog, nullptr);
    for (const char* pattern : {"*.json", "*.h5", "*.URDF", "*.stl", "*.STL", "*.csv", "*.ipynb"})
      EXPECT_TRUE(dialog->nameFilters().first().contains(pattern)) << pattern;
    emit dialog->fileSelected(one.path);
    dialog->close();
    QStringList titles;
    EXPECT_TRUE(QTest::qWaitFor(
        [&] {
          story.window().frame();
          titles.clear();
          for (const QWidget* window : QApplication::topLevelWidgets())
            if (window->isVisible())
              titles << QString(window->windowTitle()).replace("[*]", window->isWindowModified() ? "*" : "");
          return !titles.filter(one.title).isEmpty();
        },
        kLong_ms))
        << one.path.toStdString() << ": " << titles.join(", ").toStdString();
  }
}

TEST(OpeningStory, TheCommandLineOpensAFileOfEachKind) {
  forgetSettings();
  for (const OfKind& one : ofEachKind()) {
    QProcess program;
    program.start(UNDERACT_WINDOW, {one.path});
    EXPECT_TRUE(QTest::qWaitFor([&] { return !TitlesOnScreen::read().filter(one.title).isEmpty(); }, 3 * kLong_ms))
        << one.path.toStdString() << ": " << TitlesOnScreen::read().join(", ").toStdString();
    program.kill();
    program.waitForFinished();
  }
}

}  // namespace underact::gui::test
