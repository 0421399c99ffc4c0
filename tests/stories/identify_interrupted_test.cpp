// What comes between while the arm is measured: the person, a fault, another scene, a recording, another measurement.
#include <gtest/gtest.h>

#include <QElapsedTimer>

#include "app/gui/model/player.h"
#include "core/record/recorder.h"
#include "core/scene/edit.h"
#include "core/scene/read.h"
#include "tests/stories/identify_desk.h"

namespace underact::gui::test {
namespace {

/// Half a second of the line, with the servo at work.
QString lineSession() {
  QString path = temporaryFile("line.h5");
  SimulatedHost simulated = makeSimulatedHost({.clock = servo::Clock::Manual});
  EXPECT_TRUE(simulated.host->load(scene::readSceneFile(shippedScene("03_line").toStdString()).value()).empty());
  simulated.host->start();
  auto recorder = record::Recorder::start(*simulated.host, path.toStdString(), {.name = "Line"});
  EXPECT_TRUE(static_cast<bool>(recorder));
  simulated.host->run(500);
  EXPECT_TRUE(recorder.value()->stop().empty());
  return path;
}

scene::Description softer(const scene::Description& scene) {
  scene::Description edited = scene;
  edited.control.gains.kp_N_per_mm.setConstant(0.3);
  return edited;
}

void edit(Document& document) {
  ASSERT_TRUE(document.edit(softer(document.scene()), "stiffness", document.newGesture()).empty());
}

/// The page says why the measurement has stopped, and "Begin again" begins again.
void expectAWayOn(IdentifyDesk& desk, const char* why) {
  EXPECT_EQ(desk.wizard.state(), Wizard::State::Failed);
  EXPECT_FALSE(desk.document().isTryingOut());
  EXPECT_TRUE(desk.wizard.shows("identify.why"));
  EXPECT_TRUE(desk.wizard.text("identify.why").contains(why)) << desk.wizard.text("identify.why").toStdString();
  EXPECT_TRUE(desk.wizard.shows("identify.repeat"));
  EXPECT_TRUE(desk.wizard.in("identify.repeat")->text().contains("Begin again", Qt::CaseInsensitive));
}

}  // namespace

TEST(IdentifyInterruptedStory, AWindowThatIsGoneWithoutBeingClosedPutsTheSceneBack) {
  const SimulatedHost simulated = makeSimulatedHost({.clock = servo::Clock::Manual});
  forgetSettings();
  ThemeWatcher theme;
  auto window = std::make_unique<MainWindow>(WindowParts{*simulated.host, simulated.arm, theme});
  window->show();
  ASSERT_TRUE(QTest::qWaitForWindowExposed(window.get()));
  ASSERT_TRUE(window->actions().perform("scene.open", {shippedScene("02_sphere")}));
  const scene::Description own = simulated.host->scene();
  Wizard wizard(*window, [&](int ticks) {
    simulated.host->run(ticks);
    window->frame();
  });
  ASSERT_TRUE(window->actions().perform("session.start", QVariantList{}));
  simulated.host->run(500);
  window->frame();
  wizard.begin();
  for (int frame = 0; frame < 100; ++frame) {
    simulated.host->run(50);
    window->frame();
  }
  ASSERT_TRUE(window->document().isTryingOut());
  ASSERT_FALSE(scene::isSame(simulated.host->scene(), own));
  window.reset();
  EXPECT_TRUE(scene::isSame(simulated.host->scene(), own));
}

TEST(IdentifyInterruptedStory, EscStopsTheServoAndASceneThatIsEditedMeanwhileStopsTheMeasurement) {
  IdentifyDesk desk;
  desk.wizard.begin();
  desk.run(5000);
  desk.bringToFront(desk.wizard.dialog());
  desk.key(Qt::Key_Escape);
  desk.run(100);
  EXPECT_EQ(desk.snapshot().report.force.f_T_W().norm(), 0.0);
  EXPECT_EQ(desk.wizard.state(), Wizard::State::Stopped);
  EXPECT_TRUE(desk.wizard.text("identify.why").contains("stopped"));
  desk.wizard.press("identify.repeat");
  desk.run(1000);
  EXPECT_EQ(desk.wizard.state(), Wizard::State::Runs);
  const scene::Description edited = softer(desk.document().scene());
  edit(desk.document());
  desk.run(100);
  EXPECT_EQ(desk.wizard.state(), Wizard::State::Stopped);
  EXPECT_TRUE(desk.wizard.text("identify.why").contains("changed"));
  desk.wizard.keepPicture("identify_stopped");
  desk.wizard.press("identify.repeat");  // the edited scene is the one that is put back now
  desk.run(1000);
  desk.wizard.press("identify.cancel");
  desk.settle();
  EXPECT_EQ(desk.wizard.state(), Wizard::State::Idle);
  EXPECT_TRUE(scene::isSame(desk.host().scene(), edited));
}

TEST(IdentifyInterruptedStory, AnotherSceneEndsItWithASentenceAndAWayOn) {
  IdentifyDesk desk;
  desk.wizard.begin();
  desk.run(5000);
  ASSERT_EQ(desk.wizard.state(), Wizard::State::Runs);
  ASSERT_TRUE(desk.perform("scene.open", shippedScene("03_line")));
  const scene::Description line = desk.host().scene();
  desk.run(1000);
  expectAWayOn(desk, "Another scene was opened");
  EXPECT_EQ(desk.snapshot().mode, servo::Mode::Running) << "as before";
  EXPECT_EQ(desk.document().scene().title, line.title);
  desk.wizard.press("identify.repeat");
  desk.run(1000);
  EXPECT_EQ(desk.wizard.state(), Wizard::State::Runs);
  EXPECT_FALSE(desk.wizard.shows("identify.why"));
  ASSERT_TRUE(desk.perform("scene.open", shippedScene("02_sphere")));  // stopped or not
  expectAWayOn(desk, "Another scene was opened");
  desk.wizard.press("identify.cancel");
  desk.settle();
  EXPECT_EQ(desk.host().scene().title, "Sphere");
}

TEST(IdentifyInterruptedStory, WhatWasFoundIsOfTheArmAndOutlivesTheScene) {
  IdentifyDesk desk;
  desk.wizard.begin();
  ASSERT_TRUE(desk.wizard.record()) << desk.wizard.run().why().toStdString();
  ASSERT_TRUE(desk.perform("scene.open", shippedScene("03_line")));  // while it is evaluated, or after it
  ASSERT_TRUE(desk.wizard.comes([&] { return desk.wizard.state() == Wizard::State::Done; }));
  ASSERT_TRUE(desk.perform("scene.open", shippedScene("04_plane")));
  EXPECT_EQ(desk.wizard.state(), Wizard::State::Done);
  expectNear(desk.wizard.in<QTableWidget>("identify.table"), "Mass", 45.0);
  desk.wizard.press("identify.next");
  EXPECT_TRUE(desk.perform("identify.save", temporaryFile("outlived.json")));
  EXPECT_EQ(desk.host().scene().title, desk.document().scene().title);
}

TEST(IdentifyInterruptedStory, ToCancelAnEvaluationIsNotToWaitForIt) {
  IdentifyDesk desk;
  QElapsedTimer clock;
  desk.wizard.begin();
  ASSERT_TRUE(desk.wizard.record()) << desk.wizard.run().why().toStdString();
  clock.start();
  ASSERT_TRUE(desk.wizard.comes([&] { return desk.wizard.state() == Wizard::State::Done; }));
  const qint64 whole_ns = clock.nsecsElapsed();
  desk.wizard.press("identify.back");
  desk.wizard.press("identify.back");
  desk.wizard.press("identify.next");
  ASSERT_TRUE(desk.wizard.record()) << desk.wizard.run().why().toStdString();
  ASSERT_EQ(desk.wizard.state(), Wizard::State::Evaluates);
  clock.start();
  desk.wizard.press("identify.cancel");
  // Of one and the same work on one machine; the share seen is a hundredth.
  EXPECT_LT(clock.nsecsElapsed(), whole_ns / 2);
  desk.settle();
  EXPECT_EQ(desk.wizard.state(), Wizard::State::Idle);
  EXPECT_EQ(desk.host().scene().title, "Sphere");
}

TEST(IdentifyInterruptedStory, ARecordingEndsItAndTheServoIsAsItWasBeforeTheWizard) {
  const QString session = lineSession();
  for (const bool servo_runs : {false, true}) {
    IdentifyDesk desk({}, servo_runs);
    const scene::Description before = desk.host().scene();
    desk.wizard.begin();
    desk.run(5000);
    ASSERT_EQ(desk.wizard.state(), Wizard::State::Runs);
    ASSERT_TRUE(desk.perform("replay.open", session));
    expectAWayOn(desk, "A recording was opened");
    EXPECT_EQ(desk.host().running(), servo_runs);
    desk.wizard.press("identify.repeat");
    EXPECT_EQ(desk.wizard.state(), Wizard::State::Idle) << "it is being read";
    EXPECT_TRUE(desk.wizard.text("identify.why").contains("replayed"));
    ASSERT_TRUE(desk.wizard.comes([&] { return desk.window().player().isOpen(); }));
    desk.run(500);
    ASSERT_TRUE(desk.perform("replay.close"));
    desk.run(500);
    EXPECT_EQ(desk.host().running(), servo_runs);
    EXPECT_EQ(desk.snapshot().mode, servo_runs ? servo::Mode::Running : servo::Mode::Idle);
    EXPECT_TRUE(scene::isSame(desk.host().scene(), before));
    desk.wizard.press("identify.repeat");
    desk.run(500);
    EXPECT_EQ(desk.wizard.state(), Wizard::State::Runs);
  }
}

TEST(IdentifyInterruptedStory, GoingOnAsksAgainWhatTheBeginningAsked) {
  IdentifyOnCable desk;
  Wizard& wizard = *desk.wizard;
  wizard.begin();
  ASSERT_EQ(wizard.state(), Wizard::State::Asks);
  ASSERT_TRUE(desk.window.actions().perform("session.hold_to_run", {true}));
  wizard.press("identify.go");
  EXPECT_EQ(wizard.state(), Wizard::State::Stopped);
  EXPECT_TRUE(wizard.text("identify.why").contains("Hold to run"));
  EXPECT_FALSE(desk.host.running()) << "nothing has begun";
  wizard.press("identify.repeat");
  EXPECT_EQ(wizard.state(), Wizard::State::Stopped);
  ASSERT_TRUE(desk.window.actions().perform("session.hold_to_run", {false}));
  wizard.press("identify.repeat");
  desk.run(500);
  EXPECT_EQ(wizard.state(), Wizard::State::Runs);
}

TEST(IdentifyInterruptedStory, AnotherRateStopsItUntilTheOldOneIsBack) {
  IdentifyDesk desk;
  Wizard& wizard = desk.wizard;
  wizard.begin();
  desk.run(3000);
  ASSERT_TRUE(desk.perform("servo.rate", 2000));
  desk.run(100);
  EXPECT_EQ(wizard.state(), Wizard::State::Stopped);
  EXPECT_TRUE(wizard.text("identify.why").contains("1000 Hz"));
  wizard.press("identify.repeat");
  EXPECT_EQ(wizard.state(), Wizard::State::Stopped);
  ASSERT_TRUE(desk.perform("servo.rate", 1000));
  wizard.press("identify.repeat");
  desk.run(500);
  EXPECT_EQ(wizard.state(), Wizard::State::Runs);
}

TEST(IdentifyInterruptedStory, WhatAnotherMeasurementTriesOutIsNotPutBack) {
  IdentifyOnCable desk;
  Wizard& wizard = *desk.wizard;
  Document& document = desk.window.document();
  wizard.begin();
  ASSERT_EQ(wizard.state(), Wizard::State::Asks);
  const scene::Description others = softer(document.scene());
  ASSERT_TRUE(document.tryOut(others).empty());
  wizard.press("identify.go");
  EXPECT_EQ(wizard.state(), Wizard::State::Stopped);
  EXPECT_TRUE(wizard.text("identify.why").contains("Another measurement"));
  wizard.press("identify.cancel");
  EXPECT_TRUE(document.isTryingOut());
  EXPECT_TRUE(scene::isSame(desk.host.scene(), others));
}

TEST(IdentifyInterruptedStory, AStopWhileItAsksStays) {
  IdentifyOnCable desk;
  Wizard& wizard = *desk.wizard;
  wizard.begin();
  wizard.press("identify.go");
  for (int ticks = 0; ticks < kMaxTicks && wizard.state() == Wizard::State::Runs; ticks += 100) desk.run(100);
  ASSERT_EQ(wizard.state(), Wizard::State::Asks);
  EXPECT_TRUE(wizard.text("identify.prompt").startsWith("Hold the stylus"));
  ASSERT_TRUE(desk.window.actions().perform("session.stop"));
  desk.run(500);
  EXPECT_EQ(wizard.state(), Wizard::State::Stopped);
  EXPECT_EQ(desk.host.snapshot().mode, servo::Mode::Idle);
  wizard.press("identify.repeat");
  desk.run(500);
  EXPECT_EQ(wizard.state(), Wizard::State::Runs);
}

TEST(IdentifyInterruptedStory, AServoThatThePersonHasStartedAgainIsLeftRunning) {
  for (const bool by_person : {false, true}) {
    IdentifyOnCable desk;
    Wizard& wizard = *desk.wizard;
    wizard.begin();
    wizard.press("identify.go");
    desk.run(3000);
    ASSERT_EQ(wizard.state(), Wizard::State::Runs);
    if (by_person) {
      ASSERT_TRUE(desk.window.actions().perform("session.stop"));
      desk.run(500);
      ASSERT_TRUE(desk.window.actions().perform("session.start"));
      desk.run(500);
    }
    wizard.press("identify.cancel");
    EXPECT_EQ(desk.host.running(), by_person);
  }
}

TEST(IdentifyInterruptedStory, TheHandKeepsAWishThatCameMeanwhile) {
  IdentifyDesk desk;
  desk.wizard.begin();
  desk.run(5000);
  sim::HandSetpoint setpoint;
  setpoint.p_WT = Vec3(0.0, 0.01, 0.07);
  desk.arm().setSetpoint(setpoint);
  desk.wizard.press("identify.cancel");
  EXPECT_EQ(desk.arm().setpoint().p_WT, setpoint.p_WT);
}

TEST(IdentifyInterruptedStory, OnAnotherArmItAsksThePersonAndAFaultMidwayIsTakenUpAgain) {
  IdentifyOnCable desk;
  Wizard& wizard = *desk.wizard;
  wizard.begin();
  desk.run(500);
  EXPECT_EQ(wizard.state(), Wizard::State::Asks) << "nothing moves before the person says so";
  EXPECT_FALSE(desk.host.running());
  EXPECT_TRUE(wizard.text("identify.prompt").startsWith("Let go"));
  wizard.press("identify.go");
  desk.run(10'000);
  ASSERT_EQ(wizard.state(), Wizard::State::Runs);
  const double share = wizard.run().share();
  desk.plugged_in = false;
  desk.run(100);
  desk.plugged_in = true;
  EXPECT_EQ(wizard.state(), Wizard::State::Stopped);
  const QString why = wizard.text("identify.why"), button = wizard.in("identify.repeat")->text().remove('&');
  EXPECT_TRUE(why.contains("stopped answering")) << why.toStdString();
  EXPECT_TRUE(why.contains("press “" + button + "”")) << "the button that is there: " << why.toStdString();
  wizard.keepPicture("identify_fault");
  wizard.press("identify.repeat");
  desk.run(100);
  EXPECT_EQ(wizard.state(), Wizard::State::Runs);
  EXPECT_LT(wizard.run().share(), share);
  ASSERT_TRUE(wizard.record()) << wizard.run().why().toStdString();
  ASSERT_TRUE(wizard.comes([&] { return wizard.state() == Wizard::State::Done; }));
  auto* const table = wizard.in<QTableWidget>("identify.table");
  expectNear(table, "Mass", 45.0);
  expectNear(table, "Friction", 0.26);
  EXPECT_TRUE(table->isColumnHidden(5)) << "nobody knows what a real arm is made of";
  EXPECT_TRUE(wizard.text("identify.found.what").contains("was not pressed"));
  wizard.press("identify.next");
  EXPECT_FALSE(wizard.shows("identify.use"));
  EXPECT_TRUE(wizard.text("identify.provenance").contains("Arm on a cable"));
  EXPECT_FALSE(desk.host.running()) << "it stood still before, too";
}

}  // namespace underact::gui::test
