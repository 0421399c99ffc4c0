#include <gtest/gtest.h>

#include <QAction>
#include <QApplication>
#include <QCheckBox>
#include <QLabel>
#include <QVBoxLayout>

#include "app/gui/kit/section.h"
#include "app/gui/plot/lateness_chart.h"
#include "app/gui/servo/sections.h"
#include "app/gui/servo/share_bar.h"
#include "tests/stories/picture_difference.h"
#include "tests/stories/story.h"

namespace underact::gui::test {
namespace {

QString text(Story& story, const QString& name) {
  return story.find<QLabel>(name)->text();
}

void handTo(Story& story, const Vec3& p_W, int ticks) {
  sim::HandSetpoint setpoint;
  setpoint.p_WT = p_W;
  story.arm().setSetpoint(setpoint);
  story.run(ticks);
}

// The servo runs, its panel is open, the hand is on the sphere.
void openPanel(Story& story) {
  story.perform("dock.servo", true);
  story.perform("session.start");
  story.run(500);
  story.settle();
}

}  // namespace

TEST(ServoStory, ALimitIsSeenWhileItActsAndRememberedAfterwards) {
  Story story("02_sphere");
  openPanel(story);
  auto* clamp = story.find<ShareBar>("panel.servo.limit.clamp");
  EXPECT_FALSE(clamp->acts());
  EXPECT_EQ(text(story, "panel.servo.limit.clamp.note"), "not active yet");
  handTo(story, {0.0, 0.0, 0.030}, 1500);  // 20 mm deep: some 10 N asked, 0.88 N sent
  EXPECT_TRUE(clamp->acts());
  EXPECT_TRUE(text(story, "status.force").endsWith("limited: maximum force"));
  EXPECT_TRUE(text(story, "panel.servo.limit.clamp.value").startsWith(QChar(0x2212)));
  handTo(story, {0.0, 0.0, 0.050}, 8000);
  EXPECT_FALSE(clamp->acts());
  EXPECT_EQ(text(story, "panel.servo.limit.clamp.value"), "");
  EXPECT_FALSE(text(story, "status.force").contains("limited"));
  const QString note = text(story, "panel.servo.limit.clamp.note");
  EXPECT_TRUE(note.contains(" s ago, at most ")) << note.toStdString();
  EXPECT_GT(note.section("at most ", 1).section(' ', 0, 0).toDouble(), 5.0) << note.toStdString();
  EXPECT_EQ(text(story, "panel.servo.limit.frozen.note"), "not active yet");
}

TEST(ServoStory, ALimitThatActedForOneTickBetweenTwoFramesIsNotMissed) {
  Story story("02_sphere");
  LimitsSection limits;
  servo::TickRecord record;
  record.tick = 4000;
  record.level = 1.0;
  record.limits = safety::kSlewBit;
  record.cut_N = 0.25;
  limits.add(record);
  record.tick = 5000;
  record.level = 0.0;  // nothing is sent that could be cut
  record.limits = safety::kClampBit;
  record.cut_N = 7.0;
  limits.add(record);
  servo::Snapshot snapshot;
  snapshot.ticks = 7000;
  limits.present(snapshot, 1000);
  EXPECT_EQ(limits.findChild<QLabel*>("panel.servo.limit.slew.note")->text(), "last 3 s ago, at most 0.25 N");
  EXPECT_EQ(limits.findChild<QLabel*>("panel.servo.limit.clamp.note")->text(), "not active yet");
}

TEST(ServoStory, AFrozenSampleIsALimitOnlyWhileTheServoWouldPush) {
  Story story("02_sphere");
  LimitsSection limits;
  servo::Snapshot snapshot;
  snapshot.ticks = 100;
  snapshot.report.cuts.frozen = true;  // and no force is left by then
  limits.present(snapshot, 1000);
  const auto* frozen = limits.findChild<ShareBar*>("panel.servo.limit.frozen");
  EXPECT_FALSE(frozen->acts());
  snapshot.mode = servo::Mode::Running;
  limits.present(snapshot, 1000);
  EXPECT_TRUE(frozen->acts());
  EXPECT_EQ(limits.findChild<QLabel*>("panel.servo.limit.frozen.value")->text(), "released");
}

TEST(ServoStory, ThePanelTellsOfTimeAndScheduling) {
  Story story("02_sphere");
  openPanel(story);
  story.run(2000);
  EXPECT_EQ(text(story, "panel.servo.rate.0"), "1000 Hz");
  EXPECT_EQ(text(story, "panel.servo.rate.1"), "by hand");
  EXPECT_EQ(text(story, "panel.servo.times.1.4"), "0.0");  // time by count is never late
  EXPECT_GT(text(story, "panel.servo.times.3.4").toDouble(), 0.0);
  for (int row = 0; row < 8; ++row) EXPECT_EQ(text(story, QString("panel.servo.late.%1").arg(row)), "0");
  EXPECT_EQ(text(story, "panel.servo.scheduling.name"), "real time: manual");
  EXPECT_TRUE(
      story.find<QLabel>("panel.servo.scheduling.hint")->textInteractionFlags().testFlag(Qt::TextSelectableByMouse));
  for (const char* section : {"time", "scheduling", "limits"}) {
    story.find(QString("panel.servo.%1.fold").arg(section));
  }
}

TEST(ServoStory, HoldToRunPushesOnlyWhileTheSpaceKeyIsHeld) {
  Story story("02_sphere");
  ASSERT_TRUE(story.perform("session.hold_to_run", true));
  story.perform("dock.servo", true);
  EXPECT_TRUE(story.find<QCheckBox>("panel.servo.hold_to_run")->isChecked());
  story.perform("session.start");
  handTo(story, {0.0, 0.0, 0.045}, 1000);
  EXPECT_EQ(story.force_N(), 0.0);
  EXPECT_EQ(text(story, "status.mode"), "Hold the button");
  story.perform("view.focus");
  ASSERT_TRUE(story.view().hasFocus());
  QWindow* window = story.window().windowHandle();
  QTest::keyPress(window, Qt::Key_Space);
  story.run(1000);
  EXPECT_GT(story.force_N(), 0.2);
  EXPECT_TRUE(text(story, "status.mode").startsWith("Running, ")) << "and its rate";
  QKeyEvent again(QEvent::KeyRelease, Qt::Key_Space, {}, " ", true);  // what a held key sends
  QApplication::sendEvent(&story.view(), &again);
  story.run(200);
  EXPECT_GT(story.force_N(), 0.2);
  QTest::keyRelease(window, Qt::Key_Space);
  story.run(200);
  EXPECT_EQ(story.force_N(), 0.0);
  EXPECT_EQ(text(story, "status.mode"), "Hold the button");
}

TEST(ServoStory, TheButtonIsLetGoWhenTheFocusGoesElsewhere) {
  Story story("02_sphere");
  story.perform("session.hold_to_run", true);
  story.perform("session.start");
  story.perform("view.focus");
  sim::HandSetpoint setpoint;
  setpoint.p_WT = {0.0, 0.0, 0.045};
  story.arm().setSetpoint(setpoint);
  QTest::keyPress(story.window().windowHandle(), Qt::Key_Space);
  story.run(1000);
  ASSERT_GT(story.force_N(), 0.2);
  story.find("panel.feel.law")->setFocus(Qt::TabFocusReason);
  story.run(200);
  EXPECT_EQ(story.force_N(), 0.0);
  EXPECT_EQ(story.snapshot().report.sample.buttons, 0U);
}

TEST(ServoStory, SpaceOnAButtonIsThatButtonsAndNotTheStyluss) {
  Story story("02_sphere");
  story.perform("dock.plots", true);
  story.settle();
  auto* energy = story.find<QCheckBox>("panel.plots.energy");
  ASSERT_TRUE(energy->isChecked());
  energy->setFocus(Qt::TabFocusReason);
  QTest::keyPress(story.window().windowHandle(), Qt::Key_Space);
  story.run(10);
  EXPECT_EQ(story.snapshot().report.sample.buttons, 0U);
  QTest::keyRelease(story.window().windowHandle(), Qt::Key_Space);
  EXPECT_FALSE(energy->isChecked());
}

TEST(ServoStory, HoldToRunAndTheEnergyPlotAreRemembered) {
  {
    Story story("02_sphere");
    EXPECT_FALSE(story.host().holdToRun());
    EXPECT_TRUE(story.find<QCheckBox>("panel.plots.energy")->isChecked());
    story.perform("session.hold_to_run", true);
    story.perform("plots.energy", false);
  }
  Story story("02_sphere", {.first_start = false});
  EXPECT_TRUE(story.host().holdToRun());
  EXPECT_TRUE(story.window().actions().find("session.hold_to_run")->isChecked());
  EXPECT_FALSE(story.find<QCheckBox>("panel.plots.energy")->isChecked());
}

TEST(ServoStory, TheServoRestartsWithoutTheProgram) {
  Story story("02_sphere");
  openPanel(story);
  ASSERT_TRUE(story.perform("servo.restart"));
  story.run(200);
  EXPECT_EQ(story.snapshot().mode, servo::Mode::Idle);
  EXPECT_TRUE(story.find("panel.servo.told")->isVisible());
  EXPECT_EQ(story.host().scene().title, "Sphere");
  story.perform("session.start");
  story.run(500);
  EXPECT_EQ(story.snapshot().mode, servo::Mode::Running);
  EXPECT_FALSE(story.find("panel.servo.told")->isVisible());
}

TEST(ServoStory, TheServoThreadRestartsToo) {
  Story story("02_sphere", {.servo = {.clock = servo::Clock::Thread}});
  story.perform("session.start");
  ASSERT_TRUE(QTest::qWaitFor([&] { return story.snapshot().mode == servo::Mode::Running; }));
  ASSERT_TRUE(story.perform("servo.restart"));
  const QAction* start = story.window().actions().find("session.start");
  ASSERT_TRUE(QTest::qWaitFor([&] { return story.snapshot().mode == servo::Mode::Idle && start->isEnabled(); }));
  const std::int64_t before = story.snapshot().ticks;
  story.perform("session.start");
  EXPECT_TRUE(QTest::qWaitFor(
      [&] { return story.snapshot().mode == servo::Mode::Running && story.snapshot().ticks > before; }));
}

TEST(ServoStory, ThePictureOfWhatActsAndOfLateness) {
  Story story("02_sphere");
  for (const Theme& theme : {Theme::light(), Theme::dark_theme()}) {
    QWidget page;
    QFont no_text = page.font();
    no_text.setPixelSize(1);
    page.setFont(no_text);
    page.setPalette(paletteOf(theme));
    auto* column = new QVBoxLayout(&page);
    auto* limits = new LimitsSection(&page);
    auto* chart = new LatenessChart(&page);
    column->addWidget(limits);
    column->addWidget(chart);
    chart->setFixedHeight(120);
    limits->setTheme(theme);
    chart->setTheme(theme);
    servo::Snapshot snapshot;
    snapshot.ticks = 5000;
    snapshot.report.level = 0.75;
    snapshot.report.cuts.speed_N = 0.5;
    snapshot.report.heat = {0.3, 0.95, 0.0};
    limits->present(snapshot, 1000);
    servo::Histogram lateness;
    for (int tick = 0; tick < 5000; ++tick) lateness.add(20'000 + 40 * tick);
    for (int tick = 0; tick < 5; ++tick) lateness.add(3'000'000);
    chart->present(lateness, 1000.0);
    page.setFixedSize(320, 320);
    EXPECT_LT(differenceFromReference(page.grab().toImage(), theme.dark ? "servo_dark" : "servo_light"), kTolerance);
  }
}

// To be looked at by people: build/.../pictures/window_servo_*.png.
TEST(ServoStory, NoTextOfThePanelIsCutAtTheUsualSizeNorAtTwiceIt) {
  const QFont default_value = QApplication::font();
  QFont large = default_value;
  large.setPointSizeF(2.0 * default_value.pointSizeF());
  for (const QFont& font : {default_value, large}) {
    QApplication::setFont(font);
    for (const char* theme : {"light", "dark"}) {
      Story story("02_sphere", {.size = font == default_value ? QSize(1280, 800) : QSize(1920, 1080)});
      story.perform(QString("view.theme.") + theme);
      openPanel(story);
      handTo(story, {0.0, 0.0, 0.030}, 1500);
      for (const QLabel* label : story.find("panel.servo")->findChildren<QLabel*>()) {
        if (label->text().isEmpty() || !label->isVisible() || label->wordWrap()) continue;
        EXPECT_GE(label->width(), label->fontMetrics().horizontalAdvance(label->text()))
            << label->objectName().toStdString() << ": " << label->text().toStdString();
      }
      EXPECT_TRUE(story.picture().save(QString("%1/pictures/window_servo_%2_%3.png")
                                           .arg(UNDERACT_BINARY, theme)
                                           .arg(font == default_value ? 1 : 2)));
    }
  }
  QApplication::setFont(default_value);
}

}  // namespace underact::gui::test
