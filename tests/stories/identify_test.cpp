#include <gtest/gtest.h>

#include <QApplication>
#include <QComboBox>
#include <QDoubleSpinBox>
#include <QFile>
#include <QLineEdit>
#include <QProgressBar>
#include <cmath>

#include "app/gui/identify/swing_plot.h"
#include "core/scene/edit.h"
#include "tests/stories/identify_desk.h"

namespace underact::gui::test {

TEST(IdentifyStory, TheWizardFindsWhatTheSimulatedArmIsMadeOfAndEndsWithAFile) {
  IdentifyDesk desk;
  const scene::Description before = desk.host().scene();
  const Vec3 setpoint_W = desk.arm().setpoint().p_WT;
  ASSERT_NE(desk.wizard.dialog(), nullptr);
  EXPECT_FALSE(desk.wizard.dialog()->isModal()) << "Esc must stop the arm, whatever is open";
  desk.wizard.keepPicture("identify_intro");
  desk.wizard.press("identify.next");
  desk.wizard.keepPicture("identify_place");
  desk.wizard.press("identify.next");
  EXPECT_EQ(desk.wizard.state(), Wizard::State::Asks);
  desk.run(6000);
  EXPECT_EQ(desk.wizard.state(), Wizard::State::Runs);
  EXPECT_FALSE(desk.wizard.in("identify.next")->isEnabled());
  EXPECT_TRUE(desk.document().isTryingOut());
  EXPECT_GT(desk.wizard.in<QProgressBar>("identify.progress")->value(), 100);
  EXPECT_TRUE(desk.wizard.text("identify.stage").contains("Swings along x"));
  EXPECT_TRUE(desk.wizard.text("identify.prompt").contains("simulated hand"));
  EXPECT_TRUE(desk.wizard.comes([&] { return !desk.wizard.run().picture().fit.empty(); }))
      << "a fit beside the swings while they are made";
  desk.wizard.keepPicture("identify_running");
  ASSERT_TRUE(desk.wizard.record()) << desk.wizard.run().why().toStdString();
  ASSERT_TRUE(desk.wizard.comes([&] { return desk.wizard.state() == Wizard::State::Done; }));
  desk.settle();
  EXPECT_TRUE(desk.wizard.in<QWidget>("identify.found")->isVisible());
  auto* const table = desk.wizard.in<QTableWidget>("identify.table");
  for (const char* axis : {"", " along x", " along y", " along z"}) {
    expectNear(table, QString("Mass") + axis, 45.0);
    expectNear(table, QString("Friction") + axis, 0.26);
  }
  EXPECT_TRUE(cell(table, "Damping", 1).startsWith("below 0.0") ||
              std::abs(cell(table, "Damping", 1).toDouble()) < 0.01);
  expectNear(table, "Counts per turn, turret", 15280.0);
  expectNear(table, "Counts per turn, gimbal 3", 4915.0);
  expectNear(table, "Stiffness in a slow press", 0.5);
  expectNear(table, "Linear up to the clamp, at", 1.76);
  EXPECT_EQ(desk.wizard.in<QComboBox>("identify.which")->count(), 3);
  desk.wizard.keepPicture("identify_found");
  // The scene from before is in effect again, and nothing of it all is an edit.
  EXPECT_TRUE(scene::isSame(desk.host().scene(), before));
  EXPECT_FALSE(desk.document().isTryingOut());
  EXPECT_FALSE(desk.document().modified());
  EXPECT_EQ(desk.arm().setpoint().p_WT, setpoint_W) << "the hand wants what it wanted before";
  desk.run(1000);
  EXPECT_EQ(desk.snapshot().mode, servo::Mode::Running);
  EXPECT_GT(desk.snapshot().report.level, 0.99);

  desk.wizard.press("identify.next");
  desk.wizard.in<QLineEdit>("identify.name")->setText("bench-3");
  desk.wizard.keepPicture("identify_keep");
  const QString path = temporaryFile("bench-3.json"), report = temporaryFile("bench-3.md");
  ASSERT_TRUE(desk.perform("identify.save", path));
  ASSERT_TRUE(desk.perform("identify.report", report));
  EXPECT_FALSE(desk.perform("identify.save", QString("/nowhere/at/all.json")));
  EXPECT_TRUE(desk.wizard.text("identify.told").contains("could not be written"));
  const Result<sim::ArmModelFile> file = sim::readArmModelFile(path.toStdString());
  ASSERT_TRUE(static_cast<bool>(file));
  EXPECT_EQ(file.value().arm.name, "bench-3");
  EXPECT_NEAR(file.value().arm.mass_kg, 0.045, 0.05 * 0.045);
  EXPECT_NEAR(file.value().arm.friction_N, 0.26, 0.05 * 0.26);
  EXPECT_EQ(file.value().provenance.rate_hz, 1000);
  QFile text(report);
  ASSERT_TRUE(text.open(QIODevice::ReadOnly));
  EXPECT_TRUE(text.readAll().contains("| Mass along z |"));
}

TEST(IdentifyStory, AMeasuredArmIsUsedShownRememberedAndGivenBack) {
  const QString path = temporaryFile("heavy.json", R"({"underact_arm_model": 1, "name": "heavy", "title": "Heavy",
    "provenance": {"device": "a bench", "date": "2026-11-22"},
    "mass_kg": 0.2, "friction_N": 0.1, "damping_N_s_per_m": 1.0})");
  {
    IdentifyDesk desk;
    EXPECT_FALSE(desk.window().actions().find("arm.vendor")->isEnabled());
    ASSERT_TRUE(desk.perform("arm.open", path));
    EXPECT_EQ(desk.find<QLabel>("status.device")->text(), "Simulated arm: heavy");
    EXPECT_TRUE(desk.find<QLabel>("status.device")->toolTip().contains("Measured on a bench, on 2026-11-22"));
    desk.wizard.measure();  // it is that arm which is found
    auto* const table = desk.wizard.in<QTableWidget>("identify.table");
    expectNear(table, "Mass", 200.0);
    expectNear(table, "Friction", 0.1);
    expectNear(table, "Damping", 1.0);
    EXPECT_EQ(cell(table, "Mass", 4), "200");
    desk.wizard.press("identify.next");
    desk.wizard.in<QLineEdit>("identify.name")->setText("again");
    desk.wizard.press("identify.use");
    EXPECT_EQ(desk.find<QLabel>("status.device")->text(), "Simulated arm: again");
    EXPECT_TRUE(desk.wizard.text("identify.told").contains("now"));
    desk.wizard.press("identify.finish");
    desk.settle();
    desk.savePicture("identify_arm_in_use");
  }
  Story next("02_sphere", {.first_start = false});
  EXPECT_EQ(next.find<QLabel>("status.device")->text(), "Simulated arm: again");
  ASSERT_TRUE(next.perform("arm.vendor"));
  EXPECT_EQ(next.find<QLabel>("status.device")->text(), "Simulated arm");
  EXPECT_FALSE(next.window().actions().find("arm.vendor")->isEnabled());
  EXPECT_EQ(next.window().findChild<ArmInUse*>()->model().mass_kg, 0.045);
}

TEST(IdentifyStory, AFileThatIsNoArmIsRefusedInWordsAndTheArmStays) {
  Story story("02_sphere");
  const QString path = temporaryFile("no_arm.json", R"({"underact_arm_model": 1, "mass": 2})");
  EXPECT_FALSE(story.perform("arm.open", path));
  story.settle();
  EXPECT_NE(story.window().findChild<QWidget*>("dialog.arm_problems"), nullptr);
  EXPECT_EQ(story.find<QLabel>("status.device")->text(), "Simulated arm");
}

TEST(IdentifyStory, CancellingPutsSceneAndHandBack) {
  IdentifyDesk desk;
  const scene::Description before = desk.host().scene();
  desk.wizard.begin();
  desk.run(9000);
  ASSERT_EQ(desk.wizard.state(), Wizard::State::Runs);
  EXPECT_FALSE(scene::isSame(desk.host().scene(), before));
  desk.wizard.press("identify.cancel");
  desk.settle();
  EXPECT_EQ(desk.wizard.state(), Wizard::State::Idle);
  EXPECT_TRUE(scene::isSame(desk.host().scene(), before));
  desk.run(2000);
  EXPECT_EQ(desk.snapshot().mode, servo::Mode::Running);
  sim::HandSetpoint setpoint;  // the hand holds the stylus again
  setpoint.p_WT = Vec3(0.0, 0.0, 0.07);
  desk.arm().setSetpoint(setpoint);
  desk.run(2000);
  EXPECT_GT(desk.snapshot().report.p_WT.z(), 0.055);
}

TEST(IdentifyStory, ItSaysWhyItCannotBegin) {
  IdentifyDesk desk;
  desk.wizard.press("identify.next");
  desk.wizard.in<QDoubleSpinBox>("identify.place.y")->setValue(190.0);
  desk.wizard.press("identify.next");
  EXPECT_EQ(desk.wizard.state(), Wizard::State::Idle);
  EXPECT_TRUE(desk.wizard.text("identify.why").contains("nearer to the middle"));
  EXPECT_TRUE(desk.wizard.in("identify.repeat")->isVisible());
  desk.wizard.press("identify.back");
  desk.wizard.in<QDoubleSpinBox>("identify.place.y")->setValue(0.0);
  ASSERT_TRUE(desk.perform("session.hold_to_run", true));
  desk.wizard.press("identify.next");
  EXPECT_TRUE(desk.wizard.text("identify.why").contains("Hold to run"));
  ASSERT_TRUE(desk.perform("session.hold_to_run", false));
  desk.wizard.press("identify.repeat");
  desk.run(500);
  EXPECT_EQ(desk.wizard.state(), Wizard::State::Runs);
}

TEST(IdentifyStory, ItLooksRightInDarkOnALargeScreenAndWithLargeText) {
  const QFont default_value = QApplication::font();
  for (const double share : {1.0, 2.0}) {
    QFont font = default_value;
    font.setPointSizeF(share * default_value.pointSizeF());
    QApplication::setFont(font);
    IdentifyDesk desk({.size = share > 1.0 ? QSize(1280, 800) : QSize(1920, 1080)});
    desk.perform("view.theme.dark");
    desk.wizard.measure();
    desk.settle();
    EXPECT_LE(desk.wizard.dialog()->height(), desk.window().height());
    for (const char* name : {"identify.next", "identify.cancel", "identify.table", "identify.which"}) {
      auto* const widget = desk.wizard.in<QWidget>(name);
      const QRect there(widget->mapTo(desk.wizard.dialog(), QPoint()), widget->size());
      EXPECT_TRUE(desk.wizard.dialog()->rect().contains(there)) << name << " at " << share;
      EXPECT_GE(widget->height(), widget->minimumSizeHint().height()) << name << " at " << share;
    }
    EXPECT_LT(desk.wizard.in<SwingPlot>("identify.found.plot")->picture().pixelColor(3, 3).lightness(), 80);
    desk.wizard.keepPicture(share > 1.0 ? "identify_dark_large_text" : "identify_dark");
  }
  QApplication::setFont(default_value);
}

}  // namespace underact::gui::test
