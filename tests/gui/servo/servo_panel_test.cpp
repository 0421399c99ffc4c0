#include "app/gui/servo/servo_panel.h"

#include <gtest/gtest.h>

#include <QCheckBox>
#include <QComboBox>
#include <QSignalSpy>

#include "app/gui/model/limit_names.h"
#include "app/gui/servo/rate_chooser.h"
#include "app/gui/servo/sections.h"
#include "app/gui/servo/share_bar.h"
#include "tests/gui/desk.h"

namespace underact::gui {
FeatureRow servoFeature();
}

namespace underact::gui::test {

TEST(RateChooser, HasTheUsualRatesAndThePresentOneAmongThem) {
  RateChooser chooser;
  chooser.present(1000);
  auto* box = chooser.findChild<QComboBox*>();
  const int default_value = box->count();
  QSignalSpy asked(&chooser, &RateChooser::asked);
  chooser.present(1500);
  EXPECT_EQ(box->count(), default_value + 1);
  EXPECT_EQ(box->currentText(), QString("1500 Hz"));
  EXPECT_EQ(box->itemText(box->currentIndex() + 1), QString("2000 Hz"));
  EXPECT_EQ(asked.count(), 0) << "to show a rate asks for none";
  emit box->activated(0);
  ASSERT_EQ(asked.count(), 1);
  EXPECT_EQ(asked.first().first().toInt(), 250);
}

TEST(LimitsSection, ALimitActsWhileItCutsAndSaysAfterwardsWhenAndHowMuch) {
  LimitsSection section;
  servo::Snapshot snapshot;
  snapshot.mode = servo::Mode::Running;
  snapshot.report.level = 1.0;
  snapshot.ticks = 1000;
  section.present(snapshot, 1000);
  const auto note = [&section](const char* key) {
    QString notes;
    for (const QLabel* label :
         section.findChild<ShareBar*>(QString("panel.servo.limit.%1").arg(key))->findChildren<QLabel*>())
      notes += label->text() + "|";
    return notes;
  };
  EXPECT_TRUE(note("speed").contains("not active yet"));
  snapshot.report.cuts.speed_N = 0.25;
  section.present(snapshot, 1000);
  EXPECT_TRUE(section.findChild<ShareBar*>("panel.servo.limit.speed")->acts());
  snapshot.report.cuts.speed_N = 0.0;
  snapshot.ticks = 6000;
  section.present(snapshot, 1000);
  EXPECT_FALSE(section.findChild<ShareBar*>("panel.servo.limit.speed")->acts());
  EXPECT_TRUE(note("speed").contains("last 5 s ago, at most 0.25 N")) << note("speed").toStdString();
}

TEST(ServoPanel, ARateThatCannotBeIsRefusedInASentenceAndTheChooserShowsWhatHolds) {
  Desk desk(servoFeature());
  EXPECT_FALSE(desk.perform("servo.rate", 50));
  EXPECT_TRUE(desk.label("panel.servo.told").startsWith("The rate was not changed. "));
  EXPECT_EQ(desk.host().rateHz(), 1000);
  EXPECT_EQ(desk.find<QComboBox>("panel.servo.rate_choice")->currentText(), QString("1000 Hz"));
  EXPECT_TRUE(desk.perform("servo.rate", 2000));
  EXPECT_EQ(desk.find<QComboBox>("panel.servo.rate_choice")->currentText(), QString("2000 Hz"));
  EXPECT_TRUE(desk.find("panel.servo.told")->isHidden());
}

TEST(ServoPanel, HoldToRunIsAsItWasLeftAndTheBoxSwitchesIt) {
  Settings before;
  before.hold_to_run = true;
  Desk desk(servoFeature(), "02_sphere", before);
  EXPECT_TRUE(desk.host().holdToRun());
  desk.find<QCheckBox>("panel.servo.hold_to_run")->setChecked(false);
  EXPECT_FALSE(desk.host().holdToRun());
  Settings after = before;
  desk.panel<ServoPanel>().remember(after);
  EXPECT_FALSE(after.hold_to_run);
}

}  // namespace underact::gui::test
