#include <QCheckBox>
#include <QComboBox>
#include <QDoubleSpinBox>
#include <QListWidget>

#include "app/gui/input_devices/axis_bar.h"
#include "app/gui/input_devices/map_store.h"
#include "tests/stories/hands_desk.h"

namespace underact::gui::test {

TEST(HandsStory, AControllerPushesIntoTheSphereAsFastAsItsMapSays) {
  HandsDesk desk;
  const Vec3 before = desk.setpoint();
  desk.pad.push(1, -1.0);  // the left stick away from the person: into the sphere
  desk.hold(100);
  EXPECT_NEAR(desk.setpoint().z(), before.z() - 0.012, 1e-9);  // 120 mm/s for 0.1 s
  EXPECT_EQ(desk.setpoint().x(), before.x());
  desk.pad.rest();
  desk.hold(1500);
  EXPECT_GT(desk.story().force_N(), 0.3);
  EXPECT_LE(desk.story().force_N(), 0.88 + 1e-9);
  EXPECT_GT(desk.story().snapshot().report.force.f_T_W().z(), 0.0);  // outwards: it pushes back
  EXPECT_NEAR(desk.setpoint().z(), before.z() - 0.012, 1e-9);        // nobody moves it any more
}

TEST(HandsStory, WithinTheDeadZoneNothingMovesAndBeyondItBeginsAtZero) {
  HandsDesk desk;
  const Vec3 before = desk.setpoint();
  desk.pad.push(0, 0.12);
  desk.hold(1000);
  EXPECT_EQ(desk.setpoint(), before);
  desk.pad.push(0, 0.13);
  desk.hold(1000);
  EXPECT_GT(desk.setpoint().x(), before.x());
  EXPECT_LT(desk.setpoint().x(), before.x() + 1e-4);
  ASSERT_TRUE(desk.story().perform("hands.set", QString("right.dead_zone"), 0.5));
  desk.pad.rest();
  desk.hold(1);
  const double there = desk.setpoint().x();
  desk.pad.push(0, 0.49);
  desk.hold(1000);
  EXPECT_EQ(desk.setpoint().x(), there);
}

TEST(HandsStory, WhileAnotherWindowHasTheKeyboardNothingMovesAndWhatIsHeldThenMovesNothingAfter) {
  HandsDesk desk;
  const Vec3 before = desk.setpoint();
  QWidget other;
  other.show();
  desk.story().bringToFront(&other);
  ASSERT_TRUE(comes([&] { return !desk.story().window().isActiveWindow(); }));
  desk.pad.push(0, 1.0);
  desk.hold(500);
  EXPECT_EQ(desk.setpoint(), before);
  desk.story().bringToFront(&desk.story().window());
  ASSERT_TRUE(comes([&] { return desk.story().window().isActiveWindow(); }));
  desk.hold(500);
  EXPECT_EQ(desk.setpoint(), before);  // held from before
  desk.pad.rest();
  desk.hold(1);
  desk.pad.push(0, 1.0);
  desk.hold(100);
  EXPECT_NEAR(desk.setpoint().x(), before.x() + 0.012, 1e-9);
}

TEST(HandsStory, AMappingIsLearntKeptAndThereInTheNextWindow) {
  {
    HandsDesk desk;
    desk.story().click(desk.story().find("panel.hands.way.up"));
    desk.story().click(desk.story().find("panel.hands.learn"));
    EXPECT_TRUE(desk.label("panel.hands.asked").contains("moves the stylus up"));
    const Vec3 before = desk.setpoint();
    desk.pad.push(3, -0.9);  // the right stick away
    desk.hold(250);
    EXPECT_EQ(desk.setpoint(), before);  // it is looked at, not moved by
    EXPECT_FALSE(desk.story().arm().setpoint().turns);
    EXPECT_EQ(desk.map().motions[1].source, (Source{SourceKind::Axis, 3, -1}));
    EXPECT_TRUE(desk.map().motions[1].inverted);
    EXPECT_FALSE(desk.story().find("panel.hands.asked")->isVisible());
    EXPECT_EQ(desk.story().find<QComboBox>("panel.hands.source")->currentText(), "right stick, down");
    desk.story().run(250);
    EXPECT_EQ(desk.setpoint(), before);  // still held from before
    desk.pad.rest();
    desk.hold(1);
    desk.pad.push(3, -1.0);
    desk.hold(100);
    EXPECT_NEAR(desk.setpoint().y(), before.y() + 0.012, 1e-9);
  }
  HandsDesk desk(false);
  EXPECT_EQ(desk.map().motions[1].source, (Source{SourceKind::Axis, 3, -1}));
  EXPECT_TRUE(desk.map().motions[1].inverted);
  ASSERT_TRUE(desk.story().perform("hands.reset"));
  EXPECT_EQ(desk.map(), desk.pad.pad.default_value);
  EXPECT_TRUE(comes([] { return QDir(mapFolder()).entryList(QDir::Files).isEmpty(); }));  // as usual: no file
}

TEST(HandsStory, APairOfButtonsIsLearntOneAfterTheOtherAndAButtonForStop) {
  HandsDesk desk;
  ASSERT_TRUE(desk.story().perform("hands.learn", QString("right")));
  desk.pad.press(1U << 14U);
  desk.hold(1);
  EXPECT_TRUE(desk.label("panel.hands.asked").contains("the opposite direction"));
  desk.pad.press(0);
  desk.hold(1);
  desk.pad.press(1U << 12U);
  desk.hold(1);
  EXPECT_EQ(desk.map().motions[0].source, (Source{SourceKind::Buttons, 14, 12}));
  EXPECT_EQ(desk.hands().learning(), "");
  desk.pad.rest();
  desk.hold(1);
  ASSERT_TRUE(desk.story().perform("hands.learn", QString("stop")));
  desk.pad.press(1U << 6U);
  desk.hold(1);
  EXPECT_EQ(desk.map().presses[2], 6);
  ASSERT_TRUE(desk.story().perform("hands.undo"));
  EXPECT_EQ(desk.map().presses[2], 1);
  ASSERT_TRUE(desk.story().perform("hands.undo"));  // both buttons were one change
  EXPECT_EQ(desk.map(), desk.pad.pad.default_value);
  ASSERT_TRUE(desk.story().perform("hands.redo"));
  EXPECT_EQ(desk.map().motions[0].source, (Source{SourceKind::Buttons, 14, 12}));
}

TEST(HandsStory, TheEditorChangesWhatItSays) {
  HandsDesk desk;
  auto& story = desk.story();
  story.type(story.find<QDoubleSpinBox>("panel.hands.dead_zone.number"), "30");
  EXPECT_NEAR(desk.map().motions[0].dead_zone, 0.30, 1e-12);
  story.type(story.find<QDoubleSpinBox>("panel.hands.fine.number"), "0");
  EXPECT_EQ(desk.map().motions[0].exponent, 1.0);
  story.type(story.find<QDoubleSpinBox>("panel.hands.speed.number"), "50");
  EXPECT_NEAR(desk.map().motions[0].top, 0.05, 1e-12);
  story.find<QCheckBox>("panel.hands.inverted")->click();
  EXPECT_TRUE(desk.map().motions[0].inverted);
  EXPECT_FALSE(story.perform("hands.set", QString("right.dead_zone"), 1.5));
  EXPECT_FALSE(story.perform("hands.set", QString("right.source"), QString("axis 77")));
  EXPECT_FALSE(story.perform("hands.set", QString("left.inverted"), true));
  const Vec3 before = desk.setpoint();
  desk.hold(1);            // at rest once, since its map is another
  desk.pad.push(0, 0.65);  // half of what is left of its way
  desk.hold(200);
  EXPECT_NEAR(desk.setpoint().x(), before.x() - 0.005, 1e-9);
  EXPECT_NEAR(story.find<AxisBar>("panel.hands.bar.right")->share(), -0.5, 1e-12);
  story.click(story.find("panel.hands.undo"));
  EXPECT_FALSE(desk.map().motions[0].inverted);
}

TEST(HandsStory, UnpluggedInTheMidstOfAPushTheHandRests) {
  HandsDesk desk;
  desk.pad.push(1, -1.0);
  desk.hold(80);
  desk.pad.is_plugged = false;
  desk.hold(1);
  const Vec3 left = desk.setpoint();
  desk.hold(2000);
  EXPECT_EQ(desk.setpoint(), left);
  EXPECT_LE(desk.story().force_N(), 0.88 + 1e-9);
  EXPECT_EQ(desk.story().find<QListWidget>("panel.hands.list")->count(), 1);
  desk.pad.is_plugged = true;  // with the stick where it was
  desk.hold(1000);
  EXPECT_EQ(desk.setpoint(), left);
  desk.pad.rest();
  desk.hold(1);
  desk.pad.push(1, 1.0);
  desk.hold(100);
  EXPECT_GT(desk.setpoint().z(), left.z());
}

TEST(HandsStory, OneThatIsSwitchedOffMovesNothingAndStaysSo) {
  {
    HandsDesk desk;
    auto* list = desk.story().find<QListWidget>("panel.hands.list");
    ASSERT_EQ(list->count(), 2);
    list->item(1)->setCheckState(Qt::Unchecked);
    const Vec3 before = desk.setpoint();
    desk.pad.push(0, 1.0);
    desk.hold(500);
    EXPECT_EQ(desk.setpoint(), before);
    EXPECT_TRUE(list->item(1)->text().endsWith("switched off")) << list->item(1)->text().toStdString();
  }
  HandsDesk desk(false);
  EXPECT_FALSE(desk.hands().find(kPad)->used);
  desk.story().perform("hands.use", QString(kPad), true);
  desk.hold(1);  // at rest once, since it was switched off
  const Vec3 before = desk.setpoint();
  desk.pad.push(0, 1.0);
  desk.hold(100);
  EXPECT_GT(desk.setpoint().x(), before.x());
}

TEST(HandsStory, ItsButtonsAreTheStylusButtonsAndOneStopsAndNoneStarts) {
  HandsDesk desk;
  desk.pad.press(0b101);  // A and X
  desk.hold(2);
  desk.hold(1);
  EXPECT_EQ(desk.story().snapshot().report.sample.buttons, 3U);
  desk.pad.press(0b10);  // B
  desk.hold(1);
  desk.hold(300);
  EXPECT_EQ(desk.story().snapshot().mode, servo::Mode::Idle);
  EXPECT_EQ(desk.story().snapshot().report.sample.buttons, 0U);
  for (unsigned button = 0; button < 15; ++button) {
    desk.pad.press(1U << button);
    desk.hold(20);
  }
  EXPECT_EQ(desk.story().snapshot().mode, servo::Mode::Idle);
  desk.story().perform("session.start");
  desk.hold(100);
  EXPECT_EQ(desk.story().snapshot().mode, servo::Mode::Running);
  ASSERT_TRUE(desk.story().perform("hands.use", QString(kPad), false));
  desk.pad.press(0b10);  // stops even so
  desk.hold(300);
  EXPECT_EQ(desk.story().snapshot().mode, servo::Mode::Idle);
}

TEST(HandsStory, AMapThatCannotBeReadIsSaidAndLeftAlone) {
  QDir(mapFolder()).removeRecursively();
  QDir().mkpath(mapFolder());
  const QString path = MapStore().pathOf(kPad);
  QFile file(path);
  ASSERT_TRUE(file.open(QIODevice::WriteOnly));
  file.write("{\"underact_hand_map\": 1, \"id\": \"x\", \"ways\": {\"rihgt\": {}}}");
  file.close();
  HandsDesk desk(false);
  EXPECT_EQ(desk.map(), desk.pad.pad.default_value);
  EXPECT_TRUE(desk.label("panel.hands.trouble").contains("Did you mean \"right\"?"))
      << desk.label("panel.hands.trouble").toStdString();
  desk.story_.reset();
  ASSERT_TRUE(file.open(QIODevice::ReadOnly));
  EXPECT_TRUE(file.readAll().contains("rihgt"));
  QDir(mapFolder()).removeRecursively();
}

TEST(HandsStory, EverythingHasANameAndIsReachedByTheKeyboard) {
  HandsDesk desk;
  for (const char* name : {"list", "way.right", "way.turn_z", "source", "learn", "inverted", "press.stop", "learn.stop",
                           "undo", "redo", "reset"}) {
    auto* widget = desk.story().find(QString("panel.hands.%1").arg(name));
    ASSERT_NE(widget, nullptr);
    EXPECT_FALSE(widget->accessibleName().isEmpty()) << name;
    EXPECT_FALSE(widget->toolTip().isEmpty()) << name;
    EXPECT_TRUE(widget->focusPolicy() & Qt::TabFocus) << name;
  }
  desk.pad.push(0, 0.7);
  desk.pad.push(1, -0.3);
  desk.hold(20);
  desk.story().savePicture("hands");
}

}  // namespace underact::gui::test
