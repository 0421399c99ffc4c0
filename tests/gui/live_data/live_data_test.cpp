#include "app/gui/live_data/live_data.h"

#include <gtest/gtest.h>

#include <QAction>
#include <QLineEdit>
#include <QPushButton>
#include <QSignalSpy>

#include "app/gui/live_data/address_dialog.h"
#include "tests/gui/desk.h"

namespace underact::gui {
FeatureRow liveDataFeature();
}

namespace underact::gui::test {

TEST(LiveData, AnAddressIsWrittenAsItIsRead) {
  EXPECT_EQ(addressText({.host = "127.0.0.1", .port = 9870}), QString("127.0.0.1:9870"));
  EXPECT_EQ(addressText({.host = "::1", .port = 9870}), QString("[::1]:9870"));
  const auto read = stream::readAddress(addressText({.host = "::1", .port = 1234}).toStdString());
  ASSERT_TRUE(read);
  EXPECT_EQ(read.value().port, 1234);
}

TEST(LiveData, IsOffAtFirstAndSaysWhereItSendsWhileItIsOn) {
  Desk desk(liveDataFeature());
  LiveData& live = desk.listener<LiveData>();
  EXPECT_FALSE(live.isSending());
  EXPECT_EQ(live.where(), QString());
  ASSERT_TRUE(desk.perform("live.address", QString("127.0.0.1:9871")));
  EXPECT_EQ(live.where(), QString("live data to 127.0.0.1:9871"));
  EXPECT_TRUE(desk.actions().find("live.send")->isChecked());
  ASSERT_TRUE(desk.perform("live.send", false));
  EXPECT_EQ(live.where(), QString());
}

TEST(AddressDialog, WarnsOfAnotherMachineAndRefusesWhatIsNoAddress) {
  AddressDialog dialog("127.0.0.1:9870", nullptr);
  auto* warning = dialog.findChild<QLabel*>("dialog.live.warning");
  auto* refusal = dialog.findChild<QLabel*>("dialog.live.refusal");
  auto* address = dialog.findChild<QLineEdit*>("dialog.live.address");
  QSignalSpy chosen(&dialog, &AddressDialog::chosen);
  EXPECT_TRUE(warning->isHidden());
  address->setText("192.168.1.20");
  EXPECT_FALSE(warning->isHidden());
  EXPECT_TRUE(warning->text().startsWith("192.168.1.20 is not this computer."));
  address->setText("nowhere at all");
  EXPECT_TRUE(warning->isHidden());
  dialog.findChild<QPushButton*>("dialog.live.send")->click();
  EXPECT_FALSE(refusal->isHidden());
  EXPECT_EQ(chosen.count(), 0);
  address->setText("9870");
  EXPECT_TRUE(refusal->isHidden());
  dialog.findChild<QPushButton*>("dialog.live.send")->click();
  EXPECT_EQ(chosen.count(), 1);
}

}  // namespace underact::gui::test
