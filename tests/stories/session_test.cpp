#include "core/record/session.h"

#include <gtest/gtest.h>
#include <sys/stat.h>

#include <QAbstractButton>
#include <QAction>
#include <QComboBox>
#include <QDir>
#include <QDockWidget>
#include <QFile>
#include <QLabel>
#include <QLineEdit>
#include <QPlainTextEdit>
#include <QSettings>
#include <QVBoxLayout>

#include "app/gui/feature/status_line.h"
#include "app/gui/model/recording.h"
#include "app/gui/model/session_paths.h"
#include "app/gui/model/session_words.h"
#include "app/gui/sessions/session_index.h"
#include "app/gui/sessions/sessions_panel.h"
#include "tests/stories/picture_difference.h"
#include "tests/stories/session_desk.h"

namespace underact::gui::test {

TEST(SessionStory, OneClickRecordsAtOnceAndTheFileSaysWhoAndWhat) {
  Desk desk;
  desk.fill("panel.sessions.name", "first try");
  desk.fill("panel.sessions.tags", "pilot, left");
  desk.fill("panel.sessions.subject", "S07");
  desk.story->perform("purpose.research");
  desk.story->settle();
  desk.story->click(desk.story->find("button.session.record"));
  ASSERT_TRUE(desk.story->window().actions().find("session.record")->isChecked());
  EXPECT_EQ(desk.files().size(), 1);
  EXPECT_TRUE(desk.files().first().endsWith("_sphere.underact.h5")) << desk.files().first().toStdString();
  EXPECT_TRUE(desk.story->find("status.recording")->isVisible());
  desk.story->run(3000);
  ASSERT_TRUE(QTest::qWaitFor([&] { return desk.text("panel.sessions.status.0") == "00:02"; }, kLong_ms))
      << desk.text("panel.sessions.status.0").toStdString();
  EXPECT_EQ(desk.story->find<QAbstractButton>("button.session.record")->text(), "Stop recording 00:02");
  EXPECT_EQ(desk.text("panel.sessions.status.2"), "3000");
  EXPECT_TRUE(desk.text("panel.sessions.status.4").endsWith(" GB"))
      << desk.text("panel.sessions.status.4").toStdString();
  EXPECT_FALSE(desk.text("panel.sessions.status.5").isEmpty());
  ASSERT_TRUE(desk.record(false));
  EXPECT_FALSE(desk.story->find("status.recording")->isVisible());
  EXPECT_FALSE(desk.story->find("panel.sessions.notice")->isVisible());
  Result<record::Session> session = record::Session::open(desk.file(desk.files().first()).toStdString());
  ASSERT_TRUE(session);
  const record::SessionInfo& info = session.value().info();
  EXPECT_GE(info.ticks, 3000);
  EXPECT_TRUE(info.isComplete());
  EXPECT_EQ(info.end->reason, record::EndReason::Stopped);
  EXPECT_EQ(info.header.words.name, "first try");
  EXPECT_EQ(info.header.words.tags, "pilot, left");
  EXPECT_EQ(info.header.words.subject, "S07");
  EXPECT_EQ(info.header.scene_title, "Sphere");
  ASSERT_TRUE(desk.listed(1));
  EXPECT_TRUE(desk.list().item(0)->text().startsWith("first try\n"));
  EXPECT_EQ(desk.list().currentRow(), 0);
}

TEST(SessionStory, WordsTypedWhileItRecordsAreInTheFileTagsAndSubjectStayForTheNext) {
  Desk desk({{"recording/subject", "S01"}, {"recording/tags", "pilot"}});
  EXPECT_EQ(desk.story->find<QLineEdit>("panel.sessions.subject")->text(), "S01");
  ASSERT_TRUE(desk.record(true));
  desk.story->run(200);
  desk.fill("panel.sessions.name", "named later");
  desk.fill("panel.sessions.subject", "S02");
  desk.story->find<QPlainTextEdit>("panel.sessions.notes")->setPlainText("the chair was low");
  ASSERT_TRUE(desk.record(false));
  const SessionEntry entry = readSessionEntry(desk.file(desk.files().first()));
  EXPECT_EQ(entry.info.header.words.name, "named later");
  EXPECT_EQ(entry.info.header.words.notes, "the chair was low");
  EXPECT_EQ(entry.info.header.words.subject, "S02");
  EXPECT_EQ(desk.story->find<QLineEdit>("panel.sessions.name")->text(), "");
  EXPECT_EQ(desk.story->find<QPlainTextEdit>("panel.sessions.notes")->toPlainText(), "");
  EXPECT_EQ(desk.story->find<QLineEdit>("panel.sessions.subject")->text(), "S02");
  desk.story.reset();
  EXPECT_EQ(QSettings().value("recording/subject").toString(), "S02");
  EXPECT_EQ(QSettings().value("recording/tags").toString(), "pilot");
}

TEST(SessionStory, ConsentIsOfOnePersonAndNotCarriedToTheNext) {
  Desk desk;
  const auto recordedConsent = [&desk] {
    EXPECT_TRUE(desk.record(true));
    desk.story->run(200);
    EXPECT_TRUE(desk.record(false));
    QStringList files = desk.files();
    files.sort();
    return readSessionEntry(desk.file(files.last())).info.header.words.consent;
  };
  desk.fill("panel.sessions.subject", "S01");
  desk.fill("panel.sessions.consent", "form 2.1, in writing");
  EXPECT_EQ(recordedConsent(), "form 2.1, in writing");
  EXPECT_EQ(desk.story->find<QLineEdit>("panel.sessions.consent")->text(), "form 2.1, in writing");  // a second trial
  EXPECT_EQ(recordedConsent(), "form 2.1, in writing");
  desk.fill("panel.sessions.subject", "S02");
  EXPECT_EQ(desk.story->find<QLineEdit>("panel.sessions.consent")->text(), "");
  EXPECT_EQ(recordedConsent(), "");
  EXPECT_EQ(desk.story->find<QLineEdit>("panel.sessions.consent")->accessibleName(), "Consent");
}

TEST(SessionStory, RecordingsAndTheirFolderAreTheirOwnersAlone) {
  const mode_t before = ::umask(0);
  Desk desk;
  const QString folder = desk.file("made") + "/sessions";
  ASSERT_TRUE(desk.story->perform("sessions.folder", folder));
  ASSERT_TRUE(desk.record(true));
  desk.story->run(200);
  ASSERT_TRUE(desk.record(false));
  ::umask(before);
  const QFile::Permissions others =
      QFile::ReadGroup | QFile::WriteGroup | QFile::ExeGroup | QFile::ReadOther | QFile::WriteOther | QFile::ExeOther;
  for (const QFileInfo& one : QDir(folder).entryInfoList({"*.h5"}, QDir::Files))
    EXPECT_FALSE(one.permissions() & others) << one.fileName().toStdString();
  EXPECT_FALSE(QFileInfo(folder).permissions() & others);
  EXPECT_EQ(QDir(folder).entryList({"*.h5"}).size(), 1);
}

TEST(SessionStory, KeyMMarksButNotWhereOneTypes) {
  Desk desk;
  desk.story->perform("view.focus");
  desk.story->key(Qt::Key_M);  // nothing is recorded yet
  ASSERT_TRUE(desk.record(true));
  desk.story->run(500);
  desk.story->perform("view.focus");
  desk.story->key(Qt::Key_M);
  desk.story->run(500);
  desk.fill("panel.sessions.mark_label", "mug");
  EXPECT_EQ(desk.story->find<QLineEdit>("panel.sessions.mark_label")->text(), "mug");
  desk.story->find("panel.sessions.notes")->setFocus(Qt::TabFocusReason);
  desk.story->key(Qt::Key_M);
  EXPECT_EQ(desk.story->find<QPlainTextEdit>("panel.sessions.notes")->toPlainText(), "m");
  desk.story->click(desk.story->find("panel.sessions.mark"));
  desk.story->run(500);
  EXPECT_EQ(desk.text("panel.sessions.status.3"), "2");
  ASSERT_TRUE(desk.record(false));
  const SessionEntry entry = readSessionEntry(desk.file(desk.files().first()));
  ASSERT_EQ(entry.markers.size(), 2U);
  EXPECT_EQ(entry.markers[0].label, "");
  EXPECT_EQ(entry.markers[1].label, "mug");
  EXPECT_EQ(entry.markers[1].tick - entry.markers[0].tick, 500);
  EXPECT_FALSE(desk.story->window().actions().find("session.mark")->isEnabled());
}

TEST(SessionStory, AButtonOfTheStylusStartsAndStopsTheRecording) {
  Desk desk;
  desk.story->find<QComboBox>("panel.sessions.button.1")->setCurrentIndex(1);
  desk.story->perform("view.focus");
  QWindow* window = desk.story->window().windowHandle();
  const auto press = [&] {
    QTest::keyPress(window, Qt::Key_Space);
    desk.story->run(100);
    QTest::keyRelease(window, Qt::Key_Space);
    desk.story->run(100);
  };
  desk.story->run(100);
  press();
  const QAction* record = desk.story->window().actions().find("session.record");
  ASSERT_TRUE(record->isChecked());
  press();
  EXPECT_TRUE(QTest::qWaitFor([&] { return !record->isChecked(); }, kLong_ms));
  EXPECT_EQ(desk.files().size(), 1);
  desk.story->perform("session.hold_to_run", true);  // then that button is the servo's
  EXPECT_FALSE(desk.story->find("panel.sessions.button.1")->isEnabled());
  press();
  EXPECT_FALSE(record->isChecked());
}

TEST(SessionStory, AFullDiskEndsTheRecordingInOrderAndSaysWhatToDo) {
  Desk desk({{"recording/keep_free_MB", 1'000'000'000}});  // more than any disk has
  desk.story->perform("session.start");
  desk.story->run(500);
  desk.story->find<QDockWidget>("dock.scenes")->raise();
  desk.story->settle();
  ASSERT_TRUE(desk.story->find("panel.sessions")->visibleRegion().isEmpty());
  ASSERT_TRUE(desk.record(true));
  desk.story->run(500);
  const QAction* record = desk.story->window().actions().find("session.record");
  ASSERT_TRUE(QTest::qWaitFor([&] { return !record->isChecked(); }, kLong_ms));
  EXPECT_TRUE(desk.text("panel.sessions.notice").contains("record into another folder"))
      << desk.text("panel.sessions.notice").toStdString();
  EXPECT_EQ(desk.text("status.recording"), "not recording");
  desk.story->settle();
  EXPECT_FALSE(desk.story->find("panel.sessions")->visibleRegion().isEmpty());
  desk.story->run(200);
  EXPECT_EQ(desk.story->snapshot().mode, servo::Mode::Running);
  const SessionEntry entry = readSessionEntry(desk.file(desk.files().first()));
  ASSERT_TRUE(entry.isClosed());
  EXPECT_EQ(entry.info.end->reason, record::EndReason::DiskFull);
}

TEST(SessionStory, AFolderThatCannotBeUsedIsSaidWithTheWayOut) {
  Desk desk;
  QFile in_its_place(desk.file("taken"));
  ASSERT_TRUE(in_its_place.open(QIODevice::WriteOnly));
  in_its_place.close();
  EXPECT_FALSE(desk.story->perform("sessions.folder", desk.file("taken")));
  EXPECT_TRUE(desk.text("panel.sessions.told").contains("Choose another folder"));
  ASSERT_TRUE(desk.story->perform("sessions.folder", desk.file("new/one")));
  QDir(desk.file("new")).removeRecursively();
  QFile new_in_its_place(desk.file("new"));
  ASSERT_TRUE(new_in_its_place.open(QIODevice::WriteOnly));
  EXPECT_FALSE(desk.record(true));
  EXPECT_FALSE(desk.story->window().actions().find("session.record")->isChecked());
  EXPECT_TRUE(desk.text("panel.sessions.notice").contains("Choose another folder"))
      << desk.text("panel.sessions.notice").toStdString();
}

TEST(SessionStory, ClosingTheWindowEndsTheRecordingInOrder) {
  Desk desk;
  ASSERT_TRUE(desk.record(true));
  desk.story->run(700);
  desk.story.reset();
  const SessionEntry entry = readSessionEntry(desk.file(desk.files().first()));
  ASSERT_TRUE(entry.isClosed());
  EXPECT_EQ(entry.info.end->reason, record::EndReason::ProgramEnded);
  EXPECT_EQ(entry.info.ticks, 700);
}

TEST(SessionStory, TheServoThreadRecordsInRealTimeAndTheWindowStaysQuick) {
  forgetSettings();
  QTemporaryDir folder;
  QSettings().setValue("recording/folder", folder.path());
  Story story("02_sphere", {.first_start = false, .servo = {.clock = servo::Clock::Thread}});
  story.perform("session.start");
  QElapsedTimer took;
  took.start();
  story.perform("session.record", true);
  const qint64 start_ms = took.restart();
  story.run(1500);
  took.restart();
  story.perform("session.record", false);
  const qint64 stop_ms = took.elapsed();
  RecordProperty("start_ms", static_cast<int>(start_ms));
  RecordProperty("stop_ms", static_cast<int>(stop_ms));
  EXPECT_LT(stop_ms, 500);  // a tenth of it where nothing else runs
  const QString path = QDir(folder.path()).filePath(QDir(folder.path()).entryList({"*.h5"}).value(0));
  const SessionEntry entry = readSessionEntry(path);
  ASSERT_TRUE(entry.isClosed());
  EXPECT_GT(entry.info.ticks, 1000);
  EXPECT_EQ(entry.info.dropped, 0);
}

TEST(SessionStory, ARestartOfTheServoIsPartOfTheRecording) {
  Desk desk;
  ASSERT_TRUE(desk.record(true));
  desk.story->run(500);
  ASSERT_TRUE(desk.story->perform("servo.restart"));
  desk.story->run(500);
  ASSERT_TRUE(desk.story->window().actions().find("session.record")->isChecked());
  ASSERT_TRUE(desk.record(false));
  EXPECT_EQ(readSessionEntry(desk.file(desk.files().first())).info.ticks, 1000);
}

// To be looked at by people: build/.../pictures/window_sessions_*.png.
TEST(SessionStory, NoTextOfThePanelIsCutAtTheUsualSizeNorAtTwiceIt) {
  const QFont default_value = QApplication::font();
  QFont large = default_value;
  large.setPointSizeF(2.0 * default_value.pointSizeF());
  for (const QFont& font : {default_value, large}) {
    QApplication::setFont(font);
    for (const char* theme : {"light", "dark"}) {
      Desk desk;
      desk.story->window().resize(font == large ? QSize(1920, 1080) : QSize(1024, 700));
      desk.story->perform(QString("view.theme.") + theme);
      unclosed(desk.folder.path(), "2026-01-01_00-00-00_sphere.h5");
      desk.session(2000, "first try");
      ASSERT_TRUE(desk.listed(2));
      desk.list().setCurrentRow(1);
      ASSERT_TRUE(desk.record(true));
      desk.story->run(1000);
      desk.story->settle(600);
      for (const QLabel* label : desk.story->find("panel.sessions")->findChildren<QLabel*>()) {
        if (label->text().isEmpty() || !label->isVisible() || label->wordWrap()) continue;
        EXPECT_GE(label->width(), label->fontMetrics().horizontalAdvance(QString(label->text()).remove('&')))
            << label->objectName().toStdString() << ": " << label->text().toStdString();
      }
      EXPECT_TRUE(desk.story->picture().save(QString("%1/pictures/window_sessions_%2_%3.png")
                                                 .arg(UNDERACT_BINARY, theme)
                                                 .arg(font == default_value ? 1 : 2)));
      desk.record(false);
    }
  }
  QApplication::setFont(default_value);
}

TEST(SessionStory, ThePictureOfTheRecordingAndTheList) {
  for (const Theme& theme : {Theme::light(), Theme::dark_theme()}) {
    forgetSettings();
    QTemporaryDir folder;
    QSettings().setValue("recording/folder", folder.path());
    unclosed(folder.path(), "2026-01-01_00-00-00_sphere.h5");
    Story story({}, {.first_start = false});
    QWidget page;
    QFont no_text = page.font();
    no_text.setPixelSize(1);
    page.setFont(no_text);
    page.setPalette(paletteOf(theme));
    Actions actions(&page);
    actions.add({"session.hold_to_run", "hold", {}, "hold", {}, {}, true}, [](const QVariantList&) { return true; });
    Recording recording(story.host(), &page);
    StatusLine status(story.host(), 1.0);
    auto* panel = new SessionsPanel({actions, status, recording}, &page);
    auto* column = new QVBoxLayout(&page);
    column->addWidget(panel);
    page.setFixedSize(360, 480);
    page.show();
    actions.perform("session.record");
    story.run(1000);
    auto* list = panel->findChild<QListWidget*>("panel.sessions.list");
    ASSERT_TRUE(QTest::qWaitFor([&] { return list->count() == 1; }, kLong_ms));
    list->setCurrentRow(0);
    story.settle(600);
    EXPECT_LT(differenceFromReference(page.grab().toImage(), theme.dark ? "sessions_dark" : "sessions_light"),
              kTolerance);
    panel->finish();
  }
}

TEST(SessionStory, AStoppedRecordingIsToldAndShowFindsItInTheList) {
  Desk desk;
  auto* notice = desk.story->find("notice");
  EXPECT_FALSE(notice->isVisible());
  const QAction* record = desk.story->window().actions().find("session.record");
  ASSERT_TRUE(desk.record(true));
  EXPECT_TRUE(record->iconText().startsWith("Stop recording")) << record->iconText().toStdString();
  desk.story->run(500);
  ASSERT_TRUE(desk.record(false));
  EXPECT_EQ(record->iconText(), "Record");
  ASSERT_TRUE(notice->isVisible());
  EXPECT_TRUE(desk.text("notice.sentence").startsWith("Recording saved: "))
      << desk.text("notice.sentence").toStdString();
  EXPECT_TRUE(desk.story->view().rect().contains(notice->geometry()));
  desk.story->savePicture("notice");
  desk.story->perform("dock.sessions", false);
  desk.story->click(desk.story->find("notice.show"));
  EXPECT_TRUE(QTest::qWaitFor(
      [&] {
        const QListWidgetItem* chosen = desk.list().currentItem();
        return desk.list().isVisible() && chosen != nullptr && !chosen->isHidden();
      },
      kLong_ms));
  EXPECT_FALSE(notice->isVisible());
}

}  // namespace underact::gui::test
