#include "app/gui/files/scene_files.h"

#include <gtest/gtest.h>

#include <QApplication>
#include <QDir>
#include <QFile>
#include <QFileDialog>
#include <QMessageBox>
#include <QStandardPaths>
#include <QTemporaryDir>
#include <QTest>
#include <QTimer>

#include "app/gui/files/load_strip.h"
#include "app/gui/model/document.h"
#include "app/gui/model/scene_library.h"
#include "app/gui/model/simulated_host.h"

namespace underact::gui::test {
namespace {

/// What opens and saves, without a window around it.
struct FilesDesk {
  SimulatedHost simulated = makeSimulatedHost({.clock = servo::Clock::Manual});
  QTemporaryDir folder;
  QWidget window;
  Document document{*simulated.host};
  RecentFiles recent;
  LoadStrip loads{&window};
  SceneFiles files{document, recent, loads, &window};

  QString write(const QString& name, const QByteArray& text) const {
    QFile file(folder.filePath(name));
    EXPECT_TRUE(file.open(QIODevice::WriteOnly));
    file.write(text);
    return file.fileName();
  }
  QString sphere(const QString& name) const {
    return write(name, R"({"underact_scene": 1, "title": "Ball", "constraints": [
      {"type": "sphere", "center_mm": [0, 0, 0], "radius_mm": 25}]})");
  }
  void editTitle(const char* title) {
    scene::Description edited = document.scene();
    edited.title = title;
    EXPECT_TRUE(document.edit(edited, "title", document.newGesture()).empty());
  }
};

/// Answers the question that comes next.
void answerWith(QMessageBox::StandardButton button) {
  QTimer::singleShot(0, [button] {
    auto* box = qobject_cast<QMessageBox*>(QApplication::activeModalWidget());
    ASSERT_NE(box, nullptr);
    EXPECT_EQ(box->objectName(), QString("dialog.unsaved"));
    box->button(button)->click();
  });
}

}  // namespace

TEST(SceneFiles, WhatShipsIsSavedInTheUsersOwnFolderAndIsTold) {
  const QString own = QStandardPaths::writableLocation(QStandardPaths::DocumentsLocation);
  ASSERT_TRUE(QDir().mkpath(own));
  for (const char* shipped : {"/scenes/02_sphere.json", "/resources/lessons/scenes/free.json"}) {
    FilesDesk desk;
    ASSERT_TRUE(desk.files.open(QString(UNDERACT_SOURCE) + shipped));
    desk.files.chooseAndSave();
    auto* dialog = desk.window.findChild<QFileDialog*>("dialog.save");
    ASSERT_NE(dialog, nullptr);
    EXPECT_EQ(dialog->directory().absolutePath(), QDir(own).absolutePath()) << shipped;
    delete dialog;
  }
  FilesDesk desk;
  QString told;
  QObject::connect(&desk.files, &SceneFiles::saved, [&told](const QString& path) { told = path; });
  ASSERT_TRUE(desk.files.open(desk.sphere("ball.json")));
  ASSERT_TRUE(desk.files.saveAs(desk.folder.filePath("saved.json")));
  EXPECT_EQ(told, desk.folder.filePath("saved.json"));
}

TEST(SceneFiles, WhatIsOpenedIsAmongThoseOpenedLatelyButNotWhatShips) {
  FilesDesk desk;
  const QString own = desk.sphere("ball.json");
  ASSERT_TRUE(desk.files.open(own));
  EXPECT_EQ(desk.document.scene().title, "Ball");
  EXPECT_EQ(desk.recent.paths(), QStringList{own});
  ASSERT_TRUE(desk.files.open(QString(UNDERACT_SOURCE) + "/scenes/02_sphere.json"));
  EXPECT_EQ(desk.recent.paths(), QStringList{own});
}

TEST(SceneFiles, AWrongFileIsToldWithItsProblemsAndTheSceneStays) {
  FilesDesk desk;
  ASSERT_TRUE(desk.files.open(desk.sphere("ball.json")));
  EXPECT_FALSE(desk.files.open(desk.write("wrong.json", R"({"underact_scene": 1, "constraints": []})")));
  EXPECT_EQ(desk.document.scene().title, "Ball");
  auto* told = desk.window.findChild<QWidget*>("dialog.problems");
  ASSERT_NE(told, nullptr);
  EXPECT_FALSE(told->isHidden());
}

TEST(SceneFiles, EditsAreAskedAboutAndCancelKeepsThem) {
  FilesDesk desk;
  ASSERT_TRUE(desk.files.open(desk.sphere("ball.json")));
  EXPECT_TRUE(desk.files.settleEdits()) << "nothing is asked where nothing was edited";
  desk.editTitle("Tuned");
  answerWith(QMessageBox::Cancel);
  EXPECT_FALSE(desk.files.open(desk.sphere("other.json")));
  EXPECT_EQ(desk.document.scene().title, "Tuned");
  answerWith(QMessageBox::Discard);
  EXPECT_TRUE(desk.files.open(desk.sphere("other.json")));
  EXPECT_EQ(desk.document.scene().title, "Ball");
}

TEST(SceneFiles, WhatIsSavedIsTheFileFromThenOn) {
  FilesDesk desk;
  ASSERT_TRUE(desk.files.open(desk.sphere("ball.json")));
  desk.editTitle("Tuned");
  const QString saved = desk.folder.filePath("tuned.json");
  ASSERT_TRUE(desk.files.saveAs(saved));
  EXPECT_FALSE(desk.document.modified());
  EXPECT_EQ(desk.document.path(), saved);
  EXPECT_EQ(desk.recent.paths().first(), saved);
}

TEST(LoadStrip, ALoadThatIsCancelledIsNotDoneAndAnotherOneIs) {
  LoadStrip strip;
  bool first = false, second = false;
  strip.begin(
      "Loading one", [](const TaskMonitor&) {}, [&first] { first = true; });
  strip.begin(
      "Loading another", [](const TaskMonitor&) {}, [&second] { second = true; });
  EXPECT_TRUE(strip.isBusy());
  EXPECT_TRUE(QTest::qWaitFor([&] { return second; }, 10'000));
  EXPECT_FALSE(first);
  EXPECT_FALSE(strip.isBusy());
}

}  // namespace underact::gui::test
