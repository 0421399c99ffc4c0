#include <gtest/gtest.h>

#include <QDir>
#include <QFile>
#include <QProcess>
#include <QProgressDialog>
#include <QStandardPaths>
#include <QTemporaryDir>

#include "tests/stories/ghost_desk.h"
#include "tests/stories/story.h"

namespace underact::gui::test {
namespace {

constexpr int kWide = 160, kHigh = 120, kBytes = 3 * kWide * kHigh;

/// The program with an encoder of the test's own in its path, which keeps the pictures as they come.
struct Studio {
  explicit Studio(const QByteArray& encoder = "for last; do :; done\ncat > \"$last\"\n") {
    QFile script(folder.filePath("ffmpeg"));
    EXPECT_TRUE(script.open(QIODevice::WriteOnly));
    script.write("#!/bin/sh\n" + encoder);
    script.setPermissions(QFileDevice::ReadOwner | QFileDevice::WriteOwner | QFileDevice::ExeOwner);
  }
  int film(const QString& file, const QStringList& more = {}) {
    QProcess program;
    QProcessEnvironment environment = QProcessEnvironment::systemEnvironment();
    environment.insert("PATH", folder.path() + path);
    program.setProcessEnvironment(environment);
    program.start(UNDERACT_WINDOW, QStringList{"--film", file, "--out", out(), "--size", size} + more);
    EXPECT_TRUE(program.waitForFinished(kLong_ms * 3));
    message = program.readAllStandardError();
    return program.exitCode();
  }
  QString out() const { return folder.filePath("film.webm"); }
  QByteArray content() const {
    QFile file(out());
    return file.open(QIODevice::ReadOnly) ? file.readAll() : QByteArray();
  }
  QStringList files() const { return QDir(folder.path()).entryList(QDir::Files | QDir::Hidden); }

  QTemporaryDir folder;
  QString path = ":/usr/bin:/bin", size = "160x120";
  QByteArray message;
};

}  // namespace

TEST(FilmStory, OfASceneShowsTheHandMoveAtItsRateAndLength) {
  Studio studio;
  ASSERT_EQ(studio.film(shippedScene("02_sphere"), {"--seconds", "2", "--fps", "10"}), 0) << studio.message.data();
  const QByteArray film = studio.content();
  ASSERT_EQ(film.size(), 20 * kBytes);
  EXPECT_NE(film.left(kBytes), film.right(kBytes)) << "the hand has moved";
  EXPECT_NE(film.left(kBytes).count(film[0]), kBytes) << "something is drawn";
  ASSERT_EQ(studio.film(shippedScene("02_sphere"), {"--seconds", "1", "--fps", "10", "--speed", "0.5", "--overwrite"}),
            0);
  EXPECT_EQ(studio.content().size(), 20 * kBytes) << "half as fast takes twice as long";
  EXPECT_EQ(studio.files(), (QStringList{"ffmpeg", "film.webm"}));
}

TEST(FilmStory, OfASessionLastsAsLongAsItDid) {
  Studio studio;
  ASSERT_EQ(studio.film(teacherSession(), {"--fps", "5"}), 0) << studio.message.data();
  EXPECT_GT(studio.content().size(), kBytes);
  EXPECT_EQ(studio.content().size() % kBytes, 0);
}

TEST(FilmStory, KeepsAnExistingFileAndLeavesNothingBehindWhereItFails) {
  Studio studio;
  ASSERT_EQ(studio.film(shippedScene("01_point"), {"--seconds", "0.2"}), 0);
  const QByteArray before = studio.content();
  EXPECT_EQ(studio.film(shippedScene("02_sphere"), {"--seconds", "0.2"}), 4);
  EXPECT_TRUE(studio.message.contains("exists. --overwrite replaces it."));
  EXPECT_EQ(studio.content(), before);
  Studio failing("cat > /dev/null\necho 'Unknown encoder' >&2\nexit 1\n");
  EXPECT_EQ(failing.film(shippedScene("01_point"), {"--seconds", "0.2"}), 4);
  EXPECT_TRUE(failing.message.contains("ffmpeg says: Unknown encoder")) << failing.message.data();
  EXPECT_EQ(failing.files(), QStringList{"ffmpeg"});
  Studio without;
  QFile::remove(without.folder.filePath("ffmpeg"));
  without.path = "";
  EXPECT_EQ(without.film(shippedScene("01_point")), 4);
  EXPECT_TRUE(without.message.contains("apt install ffmpeg")) << without.message.data();
}

TEST(FilmStory, SaysWhatIsWrongWithWhatIsAsked) {
  Studio studio;
  studio.size = "161x120";
  EXPECT_EQ(studio.film(shippedScene("01_point")), 2);
  EXPECT_TRUE(studio.message.contains("two even numbers")) << studio.message.data();
  studio.size = "160x120";
  EXPECT_NE(studio.film(shippedScene("01_point"), {"--hand", "waltz"}), 0);
  EXPECT_TRUE(studio.message.contains("waltz")) << studio.message.data();
  EXPECT_EQ(studio.film("/nowhere.json"), 4);
  EXPECT_EQ(studio.files(), QStringList{"ffmpeg"});
}

TEST(FilmStory, OfTheWindowsSceneIsMadeBesideItAndCanBeCancelled) {
  Studio studio;
  const QByteArray before = qgetenv("PATH");
  qputenv("PATH", studio.folder.path().toLocal8Bit() + ":" + before);
  qputenv("UNDERACT_PROGRAM", UNDERACT_WINDOW);
  Story story("02_sphere");
  ASSERT_TRUE(story.perform("view.film", studio.out()));
  EXPECT_FALSE(story.perform("view.film", studio.out())) << "one at a time";
  EXPECT_TRUE(QTest::qWaitFor([&studio] { return QFile::exists(studio.out()); }, kLong_ms * 3));
  EXPECT_TRUE(QTest::qWaitFor([&story] { return story.window().findChild<QProgressDialog*>() == nullptr; }, kLong_ms));
  QFile::remove(studio.out());
  ASSERT_TRUE(story.perform("view.film", studio.out()));
  story.window().findChild<QProgressDialog*>()->cancel();
  EXPECT_TRUE(QTest::qWaitFor([&studio] { return studio.files() == QStringList{"ffmpeg"}; }, kLong_ms));
  story.perform("gains.set", "kp", 0, 0.3);
  if (story.window().isWindowModified()) EXPECT_FALSE(story.perform("view.film", studio.out()));
  qputenv("PATH", before);
}

TEST(FilmStory, IsEncodedByFfmpegWhereThatIsInstalled) {
  if (QStandardPaths::findExecutable("ffmpeg").isEmpty()) GTEST_SKIP() << "SKIPPED: ffmpeg is not installed";
  Studio studio;
  QFile::remove(studio.folder.filePath("ffmpeg"));
  ASSERT_EQ(studio.film(shippedScene("02_sphere"), {"--seconds", "1"}), 0) << studio.message.data();
  EXPECT_TRUE(studio.content().startsWith("\x1a\x45\xdf\xa3")) << "the first bytes of WebM";
}

}  // namespace underact::gui::test
