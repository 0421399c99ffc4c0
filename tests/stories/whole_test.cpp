#include <gtest/gtest.h>

#include <QApplication>
#include <QDir>
#include <QFile>
#include <QLabel>
#include <QProcess>
#include <QTemporaryDir>

#include "tests/stories/access_desk.h"
#include "tests/stories/story.h"

namespace underact::gui::test {
namespace {

constexpr const char* kAlone = "UNDERACT_STORY_ALONE";  // set: this is the program without what belongs to it

/// This very test in a copy of the program that lies in a folder by itself.
void tellAlone(const char* test) {
  const QTemporaryDir folder(QString(UNDERACT_BINARY) + "/alone_XXXXXX");
  const QString program = folder.filePath("odd/stories");
  ASSERT_TRUE(QDir(folder.path()).mkdir("odd"));
  ASSERT_TRUE(QFile::copy(QCoreApplication::applicationFilePath(), program));
  QProcess process;
  QProcessEnvironment surroundings = QProcessEnvironment::systemEnvironment();
  surroundings.insert(kAlone, folder.path());
  process.setProcessEnvironment(surroundings);
  process.setProcessChannelMode(QProcess::MergedChannels);
  process.setWorkingDirectory(folder.path());
  process.start(program, {QString("--gtest_filter=") + test});
  ASSERT_TRUE(process.waitForFinished(kLong_ms * 4)) << process.errorString().toStdString();
  EXPECT_EQ(process.exitCode(), 0) << process.readAll().toStdString();
}

TEST(WholeStory, AWindowWithoutItsFilesSaysSoWithThePlaces) {
  if (!qEnvironmentVariableIsSet(kAlone)) return tellAlone("WholeStory.AWindowWithoutItsFilesSaysSoWithThePlaces");
  const QString share = qEnvironmentVariable(kAlone) + "/share/underact/";
  qunsetenv("UNDERACT_DATA_DIR");
  qunsetenv("UNDERACT_CLI");
  Story story("02_sphere");
  auto* const scenes = story.find<QLabel>("panel.scenes.missing");
  EXPECT_TRUE(scenes->isVisible());
  EXPECT_TRUE(scenes->text().startsWith("The scenes that come with Underact were not found in"));
  EXPECT_TRUE(scenes->text().contains(share + "scenes")) << scenes->text().toStdString();
  bringPanel(story, "lessons");
  auto* const lessons = story.find<QLabel>("panel.lessons.missing");
  EXPECT_TRUE(lessons->text().startsWith("The lessons that come with Underact were not found in"));
  EXPECT_TRUE(lessons->text().contains(share + "lessons")) << lessons->text().toStdString();
  story.savePicture("window_without_its_lessons");
  bringPanel(story, "scenes");
  story.savePicture("window_without_its_scenes");
  EXPECT_FALSE(story.perform("help.guide"));
  QString given;
  for (const QWidget* const window : QApplication::topLevelWidgets()) {
    for (const QLabel* const label : window->findChildren<QLabel*>()) given += label->text() + "\n";
  }
  EXPECT_TRUE(given.contains("The guide's pages were not found in")) << given.toStdString();
  EXPECT_TRUE(given.contains(share + "guide")) << given.toStdString();
}

TEST(WholeStory, AWindowThatIsWholeSaysNothingOfIt) {
  Story story("02_sphere");
  EXPECT_FALSE(story.find<QLabel>("panel.scenes.missing")->isVisible());
  EXPECT_TRUE(story.find<QLabel>("panel.lessons.missing")->text().isEmpty());
}

}  // namespace
}  // namespace underact::gui::test
