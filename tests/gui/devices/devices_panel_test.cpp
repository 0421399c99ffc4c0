#include "app/gui/devices/devices_panel.h"

#include <gtest/gtest.h>

#include <QAction>
#include <QLineEdit>
#include <QPushButton>
#include <QTest>

#include "app/gui/kit/remark.h"
#include "app/gui/model/arm_choice.h"
#include "tests/gui/desk.h"

namespace underact::gui {
FeatureRow devicesFeature();
}

namespace underact::gui::test {

TEST(DevicesPanel, SaysWhichArmIsInUseAndOffersNotToUseItAgain) {
  Desk desk(devicesFeature());
  EXPECT_EQ(desk.label("panel.devices.in_use"), QString("In use: %1.").arg(sentenceText(desk.host().device().title)));
  EXPECT_FALSE(desk.actions().find("devices.simulated")->isEnabled());
}

TEST(DevicesPanel, ANameThatIsNoneIsRefusedInASentenceAndTheArmStays) {
  Desk desk(devicesFeature());
  EXPECT_TRUE(desk.find("panel.devices.told")->isHidden());
  desk.find<QLineEdit>("panel.devices.other")->setText(" no such arm ");
  desk.find<QPushButton>("panel.devices.open")->click();
  EXPECT_TRUE(QTest::qWaitFor([&desk] { return !desk.find("panel.devices.told")->isHidden(); }));
  EXPECT_TRUE(desk.label("panel.devices.told").startsWith("“no such arm” could not be opened. "));
  EXPECT_EQ(desk.services().arms->name(), QString("simulated"));
}

TEST(DevicesPanel, WhileAMeasurementIsAtWorkTheArmStaysAndItIsSaidWhy) {
  Desk desk(devicesFeature());
  ASSERT_TRUE(desk.document().tryOut(desk.scene()).empty());
  EXPECT_FALSE(desk.perform("devices.use", QString("wooden")));
  EXPECT_TRUE(desk.label("panel.devices.told").startsWith("The arm was not changed. A measurement is running"));
}

TEST(DevicesPanel, WhereTheArmStandsIsWhatTheRemarkSays) {
  Desk desk(devicesFeature());
  desk.services().where_it_stands->say("Registered with 0.1 mm.");
  EXPECT_EQ(desk.label("panel.devices.registration"), QString("Registered with 0.1 mm."));
}

}  // namespace underact::gui::test
