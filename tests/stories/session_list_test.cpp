#include <gtest/gtest.h>

#include <QAction>
#include <QDir>
#include <QFile>
#include <QLabel>
#include <QLineEdit>
#include <QMessageBox>
#include <QPushButton>
#include <QSettings>
#include <QTemporaryDir>
#include <QTimer>
#include <filesystem>

#include "app/gui/model/player.h"
#include "app/gui/sessions/csv_file.h"
#include "app/gui/sessions/rerun_check.h"
#include "app/gui/sessions/session_index.h"
#include "app/gui/sessions/sessions_panel.h"
#include "tests/stories/session_desk.h"

namespace underact::gui::test {
namespace {

int linesOfFile(const QString& path) {
  QFile file(path);
  EXPECT_TRUE(file.open(QIODevice::ReadOnly));
  return static_cast<int>(file.readAll().count('\n'));
}

}  // namespace

TEST(SessionListStory, SearchFindsBySeveralWordsAndSaysHowMany) {
  Desk desk;
  desk.fill("panel.sessions.subject", "S11");
  const QString left = desk.session(200, "left hand");
  desk.fill("panel.sessions.subject", "S12");
  desk.session(200, "right hand");
  ASSERT_TRUE(desk.listed(2));
  EXPECT_EQ(desk.text("panel.sessions.count"), "2 sessions");
  desk.story->perform("sessions.find");
  QTest::keyClicks(desk.story->find("panel.sessions.search"), "S11 HAND");
  EXPECT_EQ(desk.shown(), 1);
  EXPECT_EQ(desk.text("panel.sessions.count"), "1 of 2 sessions");
  desk.fill("panel.sessions.search", "hand sphere");
  EXPECT_EQ(desk.shown(), 2);
  desk.fill("panel.sessions.search", "nobody");
  EXPECT_EQ(desk.shown(), 0);
  desk.story->find<QLineEdit>("panel.sessions.search")->clear();
  ASSERT_TRUE(desk.choose(left));
  EXPECT_TRUE(desk.text("panel.sessions.details").contains("Subject S11"));
}

TEST(SessionListStory, ACsvHasARowForEachTickAndACancelledOneLeavesNoFile) {
  Desk desk;
  const QString path = desk.session(1234);
  ASSERT_TRUE(desk.choose(path));
  const QString out = desk.file("out.csv");
  ASSERT_TRUE(desk.story->perform("sessions.export", out));
  ASSERT_TRUE(QTest::qWaitFor([&] { return desk.text("panel.sessions.told").contains("out.csv"); }, kLong_ms));
  const SessionEntry entry = readSessionEntry(path);
  EXPECT_EQ(linesOfFile(out), entry.info.ticks + 1);
  EXPECT_GE(entry.info.ticks, 1234);
  EXPECT_FALSE(desk.story->find("panel.sessions.progress")->isVisible());
  WorkState state;
  state.cancelled = true;
  const CsvFile cancelled = writeCsvFile(path.toStdString(), desk.file("none.csv").toStdString(), state);
  EXPECT_TRUE(cancelled.cancelled);
  EXPECT_FALSE(QFile::exists(desk.file("none.csv")));
  EXPECT_FALSE(QFile::exists(desk.file("none.csv.part")));
  ASSERT_TRUE(desk.story->perform("sessions.export", "/dev/null/nowhere/all.csv"));
  ASSERT_TRUE(QTest::qWaitFor([&] { return desk.text("panel.sessions.told").startsWith("Not exported."); }, kLong_ms));
}

TEST(SessionListStory, ARunIsMadeAgainAndOneThatIsAnotherIsNamed) {
  Desk desk;
  const QString path = desk.session(600);
  ASSERT_TRUE(desk.choose(path));
  ASSERT_TRUE(desk.story->perform("sessions.rerun"));
  ASSERT_TRUE(QTest::qWaitFor([&] { return desk.text("panel.sessions.told").contains("the same"); }, kLong_ms));
  EXPECT_FALSE(desk.story->find("panel.sessions.progress")->isVisible());
  // The golden one is of a scripted hand: its simulated arm moves again.
  const QString golden = desk.file("golden.h5");
  ASSERT_TRUE(QFile::copy(QString(UNDERACT_SOURCE) + "/tests/golden/session_rerun.h5", golden));
  ASSERT_TRUE(desk.listed(2));
  ASSERT_TRUE(desk.choose(golden));
  ASSERT_TRUE(desk.story->perform("sessions.rerun"));
  ASSERT_TRUE(QTest::qWaitFor(
      [&] { return desk.text("panel.sessions.told") == "Run again: all 500 ticks are the same to the last bit."; },
      kLong_ms))
      << desk.text("panel.sessions.told").toStdString();
  bool alarm = false;
  WorkState state;
  state.cancelled = true;
  const RerunCheck cancelled = checkRerun(golden.toStdString(), state);
  EXPECT_TRUE(cancelled.cancelled);
  EXPECT_EQ(sentenceOf(cancelled, alarm), "Cancelled: the run was not compared to its end.");
  EXPECT_FALSE(alarm);
  RerunCheck other;
  other.result.verified.differs = {17, "force_sent_N"};
  EXPECT_EQ(sentenceOf(other, alarm), "Tick 17 differs from the recording: force_sent_N.");
  other.result.verified.mended = {"friction", "mesh_wall"};
  other.result.verified.different_ticks = 9;
  EXPECT_EQ(sentenceOf(other, alarm),
            "Since this session was made, the law of friction, mesh_wall was mended: 9 ticks differ now, the first one "
            "is 17.");
  EXPECT_TRUE(alarm);
}

TEST(SessionListStory, AKilledSessionIsRecovered) {
  Desk desk;
  const QString path = unclosed(desk.folder.path(), "2026-01-01_00-00-00_sphere.h5");
  ASSERT_TRUE(desk.choose(path));
  EXPECT_TRUE(desk.list().currentItem()->text().contains("not closed"));
  EXPECT_TRUE(desk.story->find("panel.sessions.recover")->isVisible());
  EXPECT_FALSE(desk.story->window().actions().find("sessions.edit")->isEnabled());
  desk.story->click(desk.story->find("panel.sessions.recover"));
  ASSERT_TRUE(QTest::qWaitFor([&] { return !desk.list().currentItem()->text().contains("not closed"); }, kLong_ms));
  const SessionEntry entry = readSessionEntry(path);
  ASSERT_TRUE(entry.isClosed());
  EXPECT_EQ(entry.info.end->reason, record::EndReason::Recovered);
  EXPECT_EQ(entry.info.ticks, 200);
  EXPECT_FALSE(desk.story->find("panel.sessions.recover")->isVisible());
}

TEST(SessionListStory, AfterAKillTheNextStartSaysThatASessionCanBeRecovered) {
  const QTemporaryDir kept;
  const QString path = unclosed(kept.path(), "2026-01-01_00-00-00_sphere.h5");
  {
    Desk desk;
    ASSERT_TRUE(desk.record(true));
    EXPECT_TRUE(QSettings().value("recording/unfinished").toString().endsWith(".h5")) << "so that a kill is known";
    ASSERT_TRUE(desk.record(false));
    EXPECT_TRUE(QSettings().value("recording/unfinished").toString().isEmpty());
    auto* const notice = desk.story->find<QLabel>("notice.sentence");
    EXPECT_FALSE(notice->text().contains("recover"));
  }
  Desk desk({{"recording/unfinished", path}});
  auto* const notice = desk.story->find<QLabel>("notice.sentence");
  ASSERT_TRUE(QTest::qWaitFor([&] { return notice->isVisible() && notice->text().contains("recover"); }, kLong_ms));
  EXPECT_TRUE(notice->text().contains("2026-01-01_00-00-00_sphere.h5"));
}

TEST(SessionListStory, WordsOfAFinishedSessionAreChangedInItsDialog) {
  Desk desk;
  const QString path = desk.session(200, "wrong");
  ASSERT_TRUE(desk.choose(path));
  ASSERT_TRUE(desk.story->perform("sessions.edit"));
  desk.fill("dialog.words.name", "right");
  desk.fill("dialog.words.tags", "kept");
  desk.story->settle();
  EXPECT_TRUE(desk.story->find("dialog.words")->grab().save(QString(UNDERACT_BINARY) + "/pictures/dialog_words.png"));
  desk.story->click(desk.story->find("dialog.words.save"));
  ASSERT_TRUE(QTest::qWaitFor([&] { return desk.list().item(0)->text().startsWith("right\n"); }, kLong_ms));
  EXPECT_EQ(readSessionEntry(path).info.header.words.tags, "kept");
}

TEST(SessionListStory, DeletingAsksAndMovesToTheBin) {
  Desk desk;
  const QString path = desk.session(200);
  ASSERT_TRUE(desk.choose(path));
  desk.list().setFocus(Qt::TabFocusReason);
  desk.story->key(Qt::Key_Delete);
  desk.story->settle();
  EXPECT_TRUE(QFile::exists(path));
  desk.story->click(desk.story->find("dialog.delete_session.move"));
  ASSERT_TRUE(desk.listed(0));
  EXPECT_FALSE(QFile::exists(path));
}

TEST(SessionListStory, DeletingSaysThatTheBinKeepsItAndOffersToRemoveForGoodWhichAsksOnceMore) {
  Desk desk;
  const QString path = desk.session(200);
  ASSERT_TRUE(desk.choose(path));
  ASSERT_TRUE(desk.story->perform("sessions.delete"));
  auto* first = desk.story->find<QMessageBox>("dialog.delete_session");
  EXPECT_TRUE(first->informativeText().contains("It stays in the bin until the bin is emptied"));
  EXPECT_EQ(first->defaultButton()->objectName(), "dialog.delete_session.cancel");
  desk.story->click(desk.story->find("dialog.delete_session.remove"));
  desk.story->settle();
  EXPECT_TRUE(QFile::exists(path));
  auto* second = desk.story->find<QMessageBox>("dialog.remove_session");
  EXPECT_TRUE(second->informativeText().startsWith("This cannot be undone"));
  EXPECT_EQ(second->defaultButton()->objectName(), "dialog.remove_session.cancel");
  EXPECT_EQ(desk.story->find("dialog.remove_session.remove")->accessibleName(), "Delete permanently");
  desk.story->click(desk.story->find("dialog.remove_session.cancel"));
  desk.story->settle();
  EXPECT_TRUE(QFile::exists(path));
  ASSERT_TRUE(desk.story->perform("sessions.remove", true));
  ASSERT_TRUE(desk.listed(0));
  EXPECT_FALSE(QFile::exists(path));
  EXPECT_TRUE(QDir(QFileInfo(path).absolutePath()).entryList(QDir::Files | QDir::Hidden).isEmpty());
}

TEST(SessionListStory, AFileThatIsNoSessionIsListedWithTheReason) {
  Desk desk;
  QFile file(desk.file("broken.h5"));
  ASSERT_TRUE(file.open(QIODevice::WriteOnly));
  file.write("not HDF5");
  file.close();
  ASSERT_TRUE(desk.listed(1));  // the folder is watched
  ASSERT_TRUE(desk.choose(desk.file("broken.h5")));
  EXPECT_TRUE(desk.list().item(0)->text().contains("cannot be read"));
  EXPECT_TRUE(desk.text("panel.sessions.details").contains("This is not a session"));
  EXPECT_FALSE(desk.story->window().actions().find("sessions.export")->isEnabled());
}

TEST(SessionListStory, ReplayIsOfferedAndReplaysWhatIsChosen) {
  Desk desk;
  const QString path = desk.session(200);
  ASSERT_TRUE(desk.choose(path));
  ASSERT_TRUE(desk.story->find("panel.sessions.replay")->isVisible());
  desk.story->click(desk.story->find("panel.sessions.replay"));
  EXPECT_EQ(desk.story->window().player().path(), path);
}

TEST(SessionListStory, PlotsAreDrawnByThePythonPackageAndItsLastSentenceIsSaidWhereItFails) {
  Desk desk;
  const QString path = desk.session(200);
  ASSERT_TRUE(desk.choose(path));
  QDir(desk.folder.path()).mkpath("data/python/underact");
  QFile package(desk.file("data/python/underact/__main__.py"));  // in place of the one that comes with the program
  ASSERT_TRUE(package.open(QIODevice::WriteOnly));
  package.write(
      "import sys\n"
      "command, session, kind, which, out, path = sys.argv[1:]\n"
      "assert (command, kind, which, out) == ('plot', '--kind', 'all', '--out')\n"
      "if path.endswith('slow.pdf'): import time; time.sleep(600)\n"
      "if path.endswith('bad.pdf'): print('Reading.\\nThe session holds no ticks.', file=sys.stderr); sys.exit(1)\n"
      "for kind in 'error', 'force':\n"
      "    open(path[:-4] + '_' + kind + '.pdf', 'wb').write(b'%PDF' + open(session, 'rb').read(4))\n");
  package.close();
  const QByteArray before = qgetenv("UNDERACT_DATA_DIR");
  qputenv("UNDERACT_DATA_DIR", desk.file("data").toUtf8());
  ASSERT_TRUE(desk.story->perform("sessions.plots", desk.file("plots.pdf")));
  EXPECT_TRUE(desk.story->find("panel.sessions.cancel")->isVisible());
  EXPECT_FALSE(desk.story->perform("sessions.export", desk.file("meanwhile.csv")));
  ASSERT_TRUE(
      QTest::qWaitFor([&] { return desk.text("panel.sessions.told") == "2 plots saved: plots_*.pdf"; }, kLong_ms));
  EXPECT_TRUE(QFile::exists(desk.file("plots_error.pdf")));
  ASSERT_TRUE(desk.story->perform("sessions.plots", desk.file("bad.pdf")));
  EXPECT_TRUE(QTest::qWaitFor(
      [&] { return desk.text("panel.sessions.told") == "The plots were not drawn. The session holds no ticks."; },
      kLong_ms))
      << desk.text("panel.sessions.told").toStdString();
  ASSERT_TRUE(desk.story->perform("sessions.plots", desk.file("slow.pdf")));
  desk.story->find<QPushButton>("panel.sessions.cancel")->click();
  EXPECT_TRUE(QTest::qWaitFor(
      [&] { return desk.text("panel.sessions.told") == "Cancelled: not all plots were drawn."; }, kLong_ms))
      << desk.text("panel.sessions.told").toStdString();
  qputenv("UNDERACT_DATA_DIR", before);
}

TEST(SessionListStory, AFolderOfManySessionsIsReadWhileTheWindowGoesOn) {
  constexpr int kMany = 400;
  Desk desk;
  const QString one = unclosed(desk.folder.path(), "one.h5");
  ASSERT_TRUE(QDir().mkpath(desk.file("many")));
  for (int number = 0; number < kMany; ++number) {
    std::filesystem::create_hard_link(one.toStdString(), desk.file(QString("many/%1.h5").arg(number)).toStdString());
  }
  qint64 longest_ms = 0;
  QElapsedTimer since;
  QTimer beat;
  QObject::connect(&beat, &QTimer::timeout, [&] { longest_ms = std::max(longest_ms, since.restart()); });
  since.start();
  beat.start(1);
  QElapsedTimer took;
  took.start();
  ASSERT_TRUE(desk.story->perform("sessions.folder", desk.file("many")));
  ASSERT_TRUE(desk.listed(kMany));
  RecordProperty("read_ms", static_cast<int>(took.elapsed()));
  since.restart();
  desk.fill("panel.sessions.search", "killed sphere");
  EXPECT_EQ(desk.shown(), kMany);
  RecordProperty("longest_ms", static_cast<int>(longest_ms));
  EXPECT_LT(longest_ms, 500);  // a tenth of it where nothing else runs
}

}  // namespace underact::gui::test
