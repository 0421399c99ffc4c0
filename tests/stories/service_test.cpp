#include <gtest/gtest.h>
#include <sys/stat.h>

#include <QFile>
#include <QProcess>
#include <QSignalSpy>
#include <QTemporaryDir>
#include <QToolButton>

#include "app/gui/model/player.h"
#include "app/gui/service/live_service.h"
#include "tests/stories/session_desk.h"

namespace underact::gui::test {
namespace {

const char* const kStiffness = "/control/kp_N_per_mm";

/// A window that lets programs steer, and a program without a socket.
struct ServedWindow {
  ServedWindow() {
    qputenv("XDG_RUNTIME_DIR", folder_.path().toUtf8());
    desk = std::make_unique<Desk>();
    story = desk->story.get();
    EXPECT_TRUE(story->perform("service.on", true));
    live = story->window().findChild<LiveService*>();
    story->run(2);
  }
  ~ServedWindow() { story->window().document().undoStack().setClean(); }  // or it asks whether to save
  int join(const std::string& name) {
    const int client = live->service()->connect();
    EXPECT_TRUE(isOk(ask(client, R"("do": "hello", "token": ")" + token() + R"(", "name": ")" + name + "\"")));
    return client;
  }
  std::string token() {
    QFile file(live->tokenFile());
    EXPECT_TRUE(file.open(QIODevice::ReadOnly));
    return file.readAll().trimmed().toStdString();
  }
  /// The answer; the events before it are in heard.
  std::string ask(int client, const std::string& keys) {
    live->service()->receive(client, {R"({"id": 7, )" + keys + "}", true, story->host().stops()}, 0.0);
    for (int tries = 0; tries < 400; ++tries) {
      while (live->service()->hasMessage(client)) {
        const std::string message = live->service()->takeMessage(client).bytes;
        if (message.starts_with("{\"id\"")) return message;
        heard += message;
      }
      story->run(1);
      live->service()->poll(0.0);
      if (tries > 50) QTest::qWait(5);  // a worker reads
    }
    return "no answer to " + keys;
  }
  static bool isOk(const std::string& answer) { return answer.find("\"ok\": true") != std::string::npos; }
  static std::string setStiffness(double kp) {
    return R"("do": "set", "values": {")" + std::string(kStiffness) + "\": " + std::to_string(kp) + "}";
  }
  double stiffness() { return story->host().scene().control.gains.kp_N_per_mm.x(); }
  QString button() {
    story->run(1);
    return story->find<QToolButton>("status.service")->text();
  }

  QTemporaryDir folder_;
  std::unique_ptr<Desk> desk;
  Story* story = nullptr;
  LiveService* live = nullptr;
  std::string heard;
};

TEST(ServiceStory, IsOffUntilItIsAskedForAndItsTokenIsForTheOwnerAlone) {
  ServedWindow served;
  EXPECT_EQ(served.button(), "No program");
  struct stat status {};
  const QString file = served.live->tokenFile();
  ASSERT_EQ(::stat(file.toLocal8Bit().constData(), &status), 0);
  EXPECT_EQ(status.st_mode & 0777U, 0600U);
  served.story->perform("service.on", false);
  served.story->run(1);
  EXPECT_FALSE(QFile::exists(file));
  EXPECT_FALSE(served.story->find("status.service")->isVisible());
  Story other("02_sphere");
  other.run(1);
  EXPECT_FALSE(other.find("status.service")->isVisible());
}

TEST(ServiceStory, WhatAProgramChangesIsShownAndIsOneStepOfUndo) {
  ServedWindow served;
  const double before = served.stiffness();
  const QSignalSpy hand_edits(&served.story->window().document(), &Document::editedHere);
  const int client = served.join("trials");
  EXPECT_EQ(served.button(), "1 program listens");
  for (int time = 0; time < 20; ++time)
    ASSERT_TRUE(ServedWindow::isOk(served.ask(client, ServedWindow::setStiffness(0.1 + 0.01 * time))));
  EXPECT_EQ(served.button(), "trials steers");
  EXPECT_DOUBLE_EQ(served.stiffness(), 0.29);
  EXPECT_EQ(served.story->window().document().undoStack().count(), 1);
  EXPECT_EQ(served.story->window().document().undoStack().undoText(), "changes by trials");
  served.story->settle();
  EXPECT_TRUE(served.story->window().isWindowModified());
  EXPECT_EQ(hand_edits.count(), 0) << "the welcome counts what the person does";
  EXPECT_TRUE(served.story->perform("edit.undo"));
  EXPECT_DOUBLE_EQ(served.stiffness(), before);
  ASSERT_TRUE(ServedWindow::isOk(served.ask(client, ServedWindow::setStiffness(0.2))));
  EXPECT_NE(served.heard.find(R"("do": "edit", "by": "window")"), std::string::npos) << served.heard;
  EXPECT_EQ(served.story->window().document().undoStack().count(), 1) << "after the person's undo a new step begins";
}

TEST(ServiceStory, ThePersonTakesTheSteeringBackAndStopIsStillForEverybody) {
  ServedWindow served;
  const int client = served.join("wall");
  ASSERT_TRUE(ServedWindow::isOk(served.ask(client, "\"do\": \"start\"")));
  EXPECT_TRUE(served.story->host().running());
  ASSERT_TRUE(ServedWindow::isOk(served.ask(client, R"("do": "force", "f_N": [0.3, 0, 0], "for_ms": 1000)")));
  ASSERT_TRUE(served.story->perform("service.take_back", true));
  EXPECT_EQ(served.button(), "You steer");
  const double before = served.stiffness();
  EXPECT_NE(served.ask(client, ServedWindow::setStiffness(0.2)).find("The person at the window steers"),
            std::string::npos);
  EXPECT_EQ(served.stiffness(), before);
  EXPECT_NE(served.heard.find(R"("event": "lease")"), std::string::npos);
  EXPECT_NE(served.heard.find(R"("held": true, "by": "window")"), std::string::npos) << served.heard;
  served.story->run(20);
  EXPECT_TRUE(ServedWindow::isOk(served.ask(client, "\"do\": \"stop\"")));
  EXPECT_FALSE(served.story->host().running());
  ASSERT_TRUE(served.story->perform("service.take_back", false));
  EXPECT_TRUE(ServedWindow::isOk(served.ask(client, ServedWindow::setStiffness(0.2))));
  EXPECT_EQ(served.button(), "wall steers");
}

TEST(ServiceStory, WhatThePersonHasStoppedNoProgramStartsAgain) {
  ServedWindow served;
  const int client = served.join("restless");
  ASSERT_TRUE(ServedWindow::isOk(served.ask(client, "\"do\": \"start\"")));
  ASSERT_TRUE(served.story->perform("session.stop"));
  EXPECT_FALSE(ServedWindow::isOk(served.ask(client, "\"do\": \"start\"")));
  EXPECT_FALSE(served.story->host().running());
  EXPECT_EQ(served.button(), "You steer");
  ASSERT_TRUE(served.story->perform("service.take_back", false));
  EXPECT_TRUE(ServedWindow::isOk(served.ask(client, "\"do\": \"start\"")));
}

TEST(ServiceStory, AnotherSceneDoesNotReplaceThePersonsUnsavedChanges) {
  ServedWindow served;
  const int client = served.join("loader");
  ASSERT_TRUE(ServedWindow::isOk(served.ask(client, R"("do": "load", "file": "03_line")")));
  EXPECT_EQ(served.story->host().scene().title, "Line");
  ASSERT_TRUE(ServedWindow::isOk(served.ask(client, ServedWindow::setStiffness(0.2))));
  ASSERT_TRUE(ServedWindow::isOk(served.ask(client, R"("do": "load", "file": "02_sphere")")))
      << "its own changes are in nobody's way";
  scene::Description edited = served.story->window().document().scene();
  edited.control.gains.kp_N_per_mm.setConstant(0.15);
  ASSERT_TRUE(served.story->window().document().edit(edited, "stiffness", 1).empty());
  EXPECT_NE(served.ask(client, R"("do": "load", "file": "03_line")").find("not saved"), std::string::npos);
  EXPECT_DOUBLE_EQ(served.stiffness(), 0.15);
}

TEST(ServiceStory, AProgramRecordsIntoTheWindowsFolderAndTheWindowShowsIt) {
  ServedWindow served;
  const int client = served.join("recorder");
  const std::string begun = served.ask(client, R"("do": "record", "file": "trial_1.h5")");
  ASSERT_TRUE(ServedWindow::isOk(begun)) << begun;
  EXPECT_NE(begun.find("trial_1.h5"), std::string::npos);
  served.story->run(50);
  EXPECT_TRUE(ServedWindow::isOk(served.ask(client, R"("do": "mark", "text": "here")")));
  served.story->host().endRecord();  // a recording ends between two ticks, and in a story time stands
  served.story->host().run(1);
  const std::string ended = served.ask(client, R"("do": "record", "stop": true)");
  EXPECT_TRUE(ServedWindow::isOk(ended)) << ended;
  EXPECT_TRUE(QFile::exists(served.desk->file("trial_1.h5")));
  ASSERT_TRUE(served.desk->record(true));
  EXPECT_NE(served.ask(client, R"("do": "record", "stop": true)").find("No client has begun"), std::string::npos);
  EXPECT_TRUE(served.desk->record(false));
}

TEST(ServiceStory, AReplayIsNotSteered) {
  ServedWindow served;
  const int client = served.join("late");
  ASSERT_TRUE(served.story->perform("replay.open", served.desk->session(100)));
  ASSERT_TRUE(QTest::qWaitFor([&] { return served.story->window().player().isOpen(); }, kLong_ms));
  EXPECT_NE(served.ask(client, ServedWindow::setStiffness(0.2)).find("Close the replay there first"),
            std::string::npos);
}

TEST(ServiceStory, APythonProgramSteersTheWindowThroughTheSocket) {
  ServedWindow served;
  QProcess python;
  QProcessEnvironment surroundings = QProcessEnvironment::systemEnvironment();
  surroundings.insert("PYTHONPATH", QString(UNDERACT_SOURCE) + "/app/python");
  python.setProcessEnvironment(surroundings);
  python.setProcessChannelMode(QProcess::MergedChannels);
  python.start("/usr/bin/python3", {"-B", "-c",
                                    QString(R"(
import sys
try:
    import websockets
except ModuleNotFoundError:
    sys.exit(77)
import underact
with underact.connect(port=%1, name="script") as live:
    live.settings["/control/kp_N_per_mm"] = 0.25
    for ticks in live.ticks(["p_WT_mm"], hz=100):
        print(ticks["p_WT_mm"].shape[1])
        break
    print(live.status()["steered_by"])
)")
                                        .arg(served.live->port())});
  ASSERT_TRUE(python.waitForStarted());
  for (int times = 0; python.state() != QProcess::NotRunning && times < 4000; ++times) {
    served.story->run(2);
    QTest::qWait(5);
  }
  if (python.exitCode() == 77) GTEST_SKIP() << "python3-websockets is not installed";
  EXPECT_EQ(python.readAll().toStdString(), "3\nscript\n");
  EXPECT_DOUBLE_EQ(served.stiffness(), 0.25);
  QTest::qWait(50);
  EXPECT_EQ(served.button(), "No program");
}

}  // namespace
}  // namespace underact::gui::test
