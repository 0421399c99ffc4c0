#include "app/gui/second_arm/second_arm_panel.h"

#include <gtest/gtest.h>

#include <QAction>
#include <QCheckBox>
#include <QComboBox>
#include <QTest>

#include "app/gui/arms/second_arm.h"
#include "tests/gui/desk.h"

namespace underact::gui {
FeatureRow secondArmFeature();
}

namespace underact::gui::test {

TEST(SecondArmPanel, TheBoxSwitchesItOnAndOnlyThenItsChoicesCanBeMadeAndTheWindowIsBusy) {
  Desk desk(secondArmFeature());
  SecondArmPanel& panel = desk.panel<SecondArmPanel>();
  EXPECT_FALSE(desk.find("panel.second.scene")->isEnabled());
  EXPECT_EQ(panel.busyReason(), QString());
  desk.find<QCheckBox>("panel.second.on")->setChecked(true);
  EXPECT_TRUE(desk.services().second->isOn());
  EXPECT_TRUE(desk.actions().find("second.on")->isChecked());
  EXPECT_TRUE(desk.find("panel.second.scene")->isEnabled());
  EXPECT_EQ(panel.busyReason(), QString("The second arm is on. Switch it off first."));
  desk.perform("second.on", false);
  EXPECT_FALSE(desk.find<QCheckBox>("panel.second.on")->isChecked());
}

TEST(SecondArmPanel, SideAndMirrorAreShownAsTheyAre) {
  Desk desk(secondArmFeature());
  desk.perform("second.on", true);
  desk.perform("second.side", true);
  EXPECT_EQ(desk.services().second->side(), SecondArm::Side::Left);
  EXPECT_EQ(desk.find<QComboBox>("panel.second.side")->currentIndex(), 0);
  desk.perform("second.mirror", false);
  EXPECT_FALSE(desk.find<QCheckBox>("panel.second.mirror")->isChecked());
}

TEST(SecondArmPanel, AnArmThatIsNoneIsRefusedInASentence) {
  Desk desk(secondArmFeature());
  EXPECT_FALSE(desk.perform("second.use", QString("no such arm"))) << "it is off";
  desk.perform("second.on", true);
  desk.perform("second.use", QString("no such arm"));
  EXPECT_TRUE(QTest::qWaitFor([&desk] { return !desk.find("panel.second.told")->isHidden(); }));
  EXPECT_TRUE(desk.label("panel.second.told").contains("no such arm"));
}

}  // namespace underact::gui::test
