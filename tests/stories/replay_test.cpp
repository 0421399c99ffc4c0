#include <gtest/gtest.h>

#include <QAction>
#include <QComboBox>
#include <QFile>
#include <QLabel>
#include <QMessageBox>
#include <QMimeData>
#include <QPushButton>
#include <QSlider>
#include <cmath>
#include <cstring>
#include <functional>

#include "app/gui/model/player.h"
#include "app/gui/replay/session_plot.h"
#include "core/record/recorder.h"
#include "core/scene/read.h"
#include "tests/stories/story.h"

namespace underact::gui::test {
namespace {

constexpr int kSessionTicks = 4000;

/// A session of 4 s: a hand slowly goes into the sphere and out; a marker at 1 s; from 3 s on the sphere is softer.
QString sessionFile() {
  static const QString kPath = [] {
    const QString path = temporaryFile("push.h5");
    SimulatedHost simulated = makeSimulatedHost({.clock = servo::Clock::Manual});
    Document document(*simulated.host);
    EXPECT_TRUE(document.open(scene::readSceneFile(shippedScene("02_sphere").toStdString()).value()).empty());
    simulated.host->start();
    simulated.host->run(1000);
    auto recorder = record::Recorder::start(*simulated.host, path.toStdString(), {.name = "Slow push"});
    EXPECT_TRUE(static_cast<bool>(recorder));
    for (int tick = 0; tick < kSessionTicks; tick += 50) {
      sim::HandSetpoint setpoint = simulated.arm->setpoint();
      setpoint.p_WT.z() = 0.05 - 0.0013 * std::sin(3.14159 * tick / kSessionTicks);
      setpoint.p_WT.x() = 0.008 * std::sin(6.0 * 3.14159 * tick / kSessionTicks);
      simulated.arm->setSetpoint(setpoint);
      if (tick == 1000) recorder.value()->mark("half way in");
      if (tick == 3000) {
        scene::Description softer = document.scene();
        softer.control.gains.kp_N_per_mm *= 0.5;
        EXPECT_TRUE(simulated.host->edit(softer).empty());
      }
      simulated.host->run(50);
    }
    EXPECT_TRUE(recorder.value()->stop().empty());
    return path;
  }();
  return kPath;
}

bool open(Story& story, const QString& path = sessionFile()) {
  if (!story.perform("replay.open", path)) return false;
  const bool is_open = QTest::qWaitFor([&] {
    story.window().frame();
    return story.window().player().isOpen() && !story.window().player().isLoading();
  });
  if (is_open) {  // it plays: back to the beginning
    story.window().player().pause();
    story.window().player().seek(0);
  }
  story.run(1);
  return is_open;
}

double kp(Story& story) {
  return story.window().document().scene().control.gains.kp_N_per_mm.x();
}

std::function<QString()> textOf(Story& story, const char* name) {
  auto* label = story.find<QLabel>(name);
  return [label] { return label->text(); };
}

}  // namespace

TEST(ReplayStory, ASessionBeginsToPlayWhenItIsOpened) {
  Story story("03_line");
  ASSERT_TRUE(story.perform("replay.open", sessionFile()));
  Player& player = story.window().player();
  ASSERT_TRUE(QTest::qWaitFor([&] {
    story.window().frame();
    return player.isOpen() && !player.isLoading();
  }));
  EXPECT_TRUE(player.isPlaying());
  story.run(500);
  EXPECT_GE(player.row(), 499);
}

TEST(ReplayStory, ASessionOpensWithItsSceneAndForcesGoToNoArm) {
  Story story("03_line");
  Player& player = story.window().player();
  EXPECT_FALSE(story.find("panel.replay")->isVisible());
  EXPECT_FALSE(story.perform("replay.play")) << "nothing is open";
  ASSERT_TRUE(open(story));
  EXPECT_TRUE(story.find("panel.replay")->isVisible());
  EXPECT_EQ(story.window().document().scene().title, "Sphere");
  EXPECT_EQ(story.find<QLabel>("status.device")->text(), "Recorded arm: Slow push");
  EXPECT_FALSE(player.isPlaying());
  EXPECT_EQ(player.row(), 0);
  EXPECT_EQ(player.lastRow(), kSessionTicks - 1);
  EXPECT_EQ(story.find<QLabel>("panel.replay.time")->text(), "0:00.000 / 0:03.999");
  story.run(500);
  EXPECT_EQ(player.row(), 0);
  EXPECT_EQ(story.snapshot().mode, servo::Mode::Running) << "so that the force is shown";
}

TEST(ReplayStory, ItPlaysWhatWasRecordedToTheBitAndStopsAtItsEnd) {
  Story story("02_sphere");
  ASSERT_TRUE(open(story));
  story.run(1000);  // the ramp
  Player& player = story.window().player();
  story.key(Qt::Key_P);
  for (int step = 0; step < 7; ++step) {
    story.run(500);
    const auto row = static_cast<std::size_t>(player.row());
    EXPECT_EQ(row, 500U * static_cast<std::size_t>(step + 1));
    const servo::Snapshot now = story.snapshot();
    EXPECT_EQ(std::memcmp(&now.report.sample.q_rad, &player.recorded().rows[row].q_rad, sizeof(arm::JointAngles)), 0);
    EXPECT_NEAR(story.force_N(), static_cast<double>(player.recorded().rows[row].force_N), 1e-5) << row;
  }
  EXPECT_GT(player.comparison().recorded().peakForce_N(), 0.1);
  story.run(600);
  EXPECT_EQ(player.row(), kSessionTicks - 1);
  EXPECT_FALSE(player.isPlaying());
  story.key(Qt::Key_P);
  story.run(11);
  EXPECT_EQ(player.row(), 10) << "played again from its beginning";
  story.key(Qt::Key_P);
  story.run(100);
  EXPECT_EQ(player.row(), 10);
}

TEST(ReplayStory, ScrubStepsSpeedAndLoop) {
  Story story("02_sphere");
  ASSERT_TRUE(open(story));
  Player& player = story.window().player();
  auto* scrub = story.find<QSlider>("panel.replay.scrub");
  story.click(scrub, {scrub->width() / 2, scrub->height() / 2});
  story.run(1);
  EXPECT_NEAR(static_cast<double>(player.row()), kSessionTicks / 2.0, 20.0);
  EXPECT_EQ(story.snapshot().report.fault.kind, FaultKind::None);
  ASSERT_TRUE(story.perform("replay.seek", 1.0));
  story.run(1);
  EXPECT_EQ(player.row(), 1000);
  EXPECT_EQ(scrub->value(), 1000);
  story.key(Qt::Key_Period);
  story.run(1);
  EXPECT_EQ(player.row(), 1001);
  story.key(Qt::Key_Comma);
  story.run(1);
  EXPECT_EQ(player.row(), 1000);
  ASSERT_TRUE(story.perform("replay.speed", 0.25));
  ASSERT_TRUE(story.perform("replay.play"));
  story.run(400);
  EXPECT_EQ(player.row(), 1100);
  EXPECT_EQ(story.find<QComboBox>("panel.replay.speed")->currentText(), QString::fromUtf8("0.25 ×"));
  ASSERT_TRUE(story.perform("replay.speed", 4.0));
  story.run(100);
  EXPECT_EQ(player.row(), 1500);
  EXPECT_EQ(story.snapshot().report.fault.kind, FaultKind::None);
  ASSERT_TRUE(story.perform("replay.speed", 1.0));
  story.key(Qt::Key_I);
  ASSERT_TRUE(story.perform("replay.seek", 1.6));
  story.run(1);
  story.key(Qt::Key_O);
  EXPECT_TRUE(story.window().actions().find("replay.loop")->isChecked());
  story.run(50);
  EXPECT_GE(player.row(), 1500);
  EXPECT_LT(player.row(), 1600);
  story.run(101);
  EXPECT_LT(player.row(), 1600);
  EXPECT_TRUE(player.isPlaying());
  story.key(Qt::Key_L);
  story.run(200);
  EXPECT_GT(player.row(), 1600);
}

TEST(ReplayStory, ChangesOfTheSessionAreFollowedUnlessWhatIfIsOn) {
  Story story("02_sphere");
  ASSERT_TRUE(open(story));
  const double own = kp(story);
  ASSERT_TRUE(story.perform("replay.seek", 3.5));
  story.run(300);
  EXPECT_EQ(kp(story), 0.5 * own);
  EXPECT_FALSE(story.window().document().modified());
  ASSERT_TRUE(story.perform("replay.seek", 0.5));
  story.run(300);
  EXPECT_EQ(kp(story), own);
  ASSERT_TRUE(story.perform("replay.what_if", true));
  ASSERT_TRUE(story.perform("replay.seek", 3.5));
  story.run(300);
  EXPECT_EQ(kp(story), own);
  ASSERT_TRUE(story.perform("replay.what_if", false));
  story.run(300);
  EXPECT_EQ(kp(story), 0.5 * own);
}

TEST(ReplayStory, WhatIfDiffersWhereTheGainIsAnotherAndOnlyThere) {
  Story story("02_sphere");
  ASSERT_TRUE(open(story));
  const auto recorded = textOf(story, "panel.replay.recorded.mean"), now = textOf(story, "panel.replay.now.mean");
  const auto recorded_rms = textOf(story, "panel.replay.recorded.rms"), now_rms = textOf(story, "panel.replay.now.rms");
  ASSERT_TRUE(story.perform("replay.what_if", true));
  EXPECT_TRUE(story.find("panel.replay.comparison")->isVisible());
  story.run(1000);
  ASSERT_TRUE(story.perform("replay.play"));
  story.run(2000);
  EXPECT_GT(recorded().toDouble(), 0.05);
  EXPECT_EQ(now(), recorded());
  EXPECT_EQ(now_rms(), recorded_rms());
  ASSERT_TRUE(story.perform("replay.play", false));
  ASSERT_TRUE(story.perform("replay.seek", 0.0));
  scene::Description softer = story.window().document().scene();
  softer.control.gains.kp_N_per_mm *= 0.5;
  ASSERT_TRUE(story.window().document().edit(softer, "stiffness", story.window().document().newGesture()).empty());
  story.run(1000);
  ASSERT_TRUE(story.perform("replay.play", true));
  story.run(2000);
  EXPECT_NEAR(now().toDouble(), 0.5 * recorded().toDouble(), 0.01);
  EXPECT_EQ(now_rms(), recorded_rms()) << "the hand is the recorded one";
  story.savePicture("replay");
  story.perform("view.theme.dark");
  story.settle(200);
  story.savePicture("replay_dark");
  story.perform("view.theme.light");
}

TEST(ReplayStory, AnEditIsAQuestionWhatIf) {
  Story story("02_sphere");
  ASSERT_TRUE(open(story));
  scene::Description softer = story.window().document().scene();
  softer.control.gains.kp_N_per_mm *= 0.25;
  ASSERT_TRUE(story.window().document().edit(softer, "stiffness", 7).empty());
  EXPECT_TRUE(story.window().actions().find("replay.what_if")->isChecked());
  ASSERT_TRUE(story.perform("replay.what_if", false));
  EXPECT_EQ(kp(story), 4.0 * softer.control.gains.kp_N_per_mm.x());
  ASSERT_TRUE(story.perform("replay.what_if", true));
  EXPECT_EQ(kp(story), softer.control.gains.kp_N_per_mm.x()) << "what was tried is there again";
}

TEST(ReplayStory, LeavingPutsBackTheSceneWithItsEditsAndTheArm) {
  Story story("03_line");
  story.perform("session.start");
  story.run(500);
  Document& document = story.window().document();
  const QString file = document.path();
  scene::Description tuned = document.scene();
  tuned.control.gains.kp_N_per_mm *= 0.5;
  ASSERT_TRUE(document.edit(tuned, "stiffness", document.newGesture()).empty());
  const Vec3 p_WT = story.snapshot().report.p_WT;
  ASSERT_TRUE(open(story));
  EXPECT_FALSE(document.modified());
  ASSERT_TRUE(story.perform("replay.seek", 2.33));
  story.run(1500);
  EXPECT_GT((story.snapshot().report.p_WT - p_WT).norm(), 0.003);
  ASSERT_TRUE(story.perform("replay.close"));
  story.run(1500);
  EXPECT_FALSE(story.find("panel.replay")->isVisible());
  EXPECT_EQ(document.path(), file);
  EXPECT_EQ(document.scene().title, tuned.title);
  EXPECT_EQ(kp(story), tuned.control.gains.kp_N_per_mm.x());
  EXPECT_TRUE(document.modified());
  EXPECT_LT((story.snapshot().report.p_WT - p_WT).norm(), 0.001);
  EXPECT_EQ(story.find<QLabel>("status.device")->text(), "Simulated arm");
  EXPECT_EQ(story.snapshot().mode, servo::Mode::Running);
  ASSERT_TRUE(story.perform("edit.undo"));
  EXPECT_FALSE(document.modified());
  EXPECT_EQ(kp(story), 2.0 * tuned.control.gains.kp_N_per_mm.x());
}

TEST(ReplayStory, TheWholeSessionStandsInPlotsAndAClickGoesThere) {
  Story story("02_sphere");
  ASSERT_TRUE(story.perform("dock.session", true));
  EXPECT_FALSE(story.find<QComboBox>("panel.session.kind")->isEnabled());
  ASSERT_TRUE(open(story));
  story.settle(200);
  auto* plot = story.find<SessionPlot>("panel.session.plot");
  ASSERT_TRUE(plot->isVisible());
  story.click(plot, plot->placeOf(2.5).toPoint());
  story.run(1);
  EXPECT_NEAR(story.window().player().secondsAt(story.window().player().row()), 2.5, 0.03);
  story.run(400);
  auto* kind = story.find<QComboBox>("panel.session.kind");
  QImage before;
  for (int index = 0; index < kind->count(); ++index) {
    ASSERT_TRUE(story.perform("session.plot", kind->itemText(index)));
    story.settle(100);
    const QImage image = story.window().grab().toImage();
    EXPECT_NE(image, before) << kind->itemText(index).toStdString();
    before = image;
    story.savePicture(QString("replay_session_%1").arg(index));
  }
  EXPECT_FALSE(story.perform("session.plot", QString("Taste")));
}

TEST(ReplayStory, TheRecordedPathIsALayerOfTheView) {
  Story story("02_sphere");
  EXPECT_EQ(story.view().pathPartsDrawn(), 0U);
  ASSERT_TRUE(open(story));
  EXPECT_GT(story.view().pathPartsDrawn(), 50U);
  ASSERT_TRUE(story.perform("layer.path", false));
  EXPECT_EQ(story.view().pathPartsDrawn(), 0U);
  ASSERT_TRUE(story.perform("layer.path", true));
  ASSERT_TRUE(story.perform("replay.close"));
  EXPECT_EQ(story.view().pathPartsDrawn(), 0U);
}

TEST(ReplayStory, AFileThatIsNoSessionIsSaidAndNothingChanges) {
  Story story("02_sphere");
  const QString path = temporaryFile("broken.h5", "this is no session");
  ASSERT_TRUE(story.perform("replay.open", path));
  ASSERT_TRUE(QTest::qWaitFor([&] {
    story.window().frame();
    return !story.window().player().isLoading();
  }));
  auto* box = story.find<QMessageBox>("dialog.session_problems");
  ASSERT_TRUE(box->isVisible());
  EXPECT_TRUE(box->text().contains("broken.h5"));
  EXPECT_FALSE(box->informativeText().isEmpty());
  box->close();
  EXPECT_FALSE(story.window().player().isOpen());
  EXPECT_FALSE(story.find("panel.replay")->isVisible());
  EXPECT_EQ(story.window().document().scene().title, "Sphere");
}

TEST(ReplayStory, ReadingCanBeCancelledAndNothingChanges) {
  Story story("03_line");
  ASSERT_TRUE(story.perform("replay.open", sessionFile()));
  ASSERT_TRUE(story.find("panel.replay.cancel")->isVisible());
  story.find<QPushButton>("panel.replay.cancel")->click();  // at once: before a frame looks at what was read
  ASSERT_TRUE(QTest::qWaitFor([&] {
    story.window().frame();
    return !story.window().player().isLoading();
  }));
  EXPECT_FALSE(story.window().player().isOpen());
  EXPECT_FALSE(story.find("panel.replay")->isVisible());
  EXPECT_EQ(story.window().findChild<QMessageBox*>("dialog.session_problems"), nullptr);
}

TEST(ReplayStory, ASessionIsDroppedOnTheWindowOrOpenedAsAFile) {
  Story story("02_sphere");
  QMimeData data;
  data.setUrls({QUrl::fromLocalFile(sessionFile())});
  QDragEnterEvent enter({100, 100}, Qt::CopyAction, &data, Qt::LeftButton, {});
  QApplication::sendEvent(&story.window(), &enter);
  QDropEvent drop({100.0, 100.0}, Qt::CopyAction, &data, Qt::LeftButton, {});
  QApplication::sendEvent(&story.window(), &drop);
  EXPECT_TRUE(story.window().player().isLoading());
  ASSERT_TRUE(QTest::qWaitFor([&] {
    story.window().frame();
    return story.window().player().isOpen();
  }));
  ASSERT_TRUE(story.perform("replay.close"));
  ASSERT_TRUE(story.perform("scene.open", sessionFile()));
  EXPECT_TRUE(story.window().player().isLoading());
  EXPECT_EQ(story.window().document().scene().title, "Sphere");
}

}  // namespace underact::gui::test
