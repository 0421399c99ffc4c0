#include <gtest/gtest.h>

#include <QComboBox>
#include <QLabel>

#include "app/gui/model/settings.h"
#include "app/gui/servo/sections.h"
#include "app/gui/servo/share_bar.h"
#include "tests/stories/story.h"

namespace underact::gui::test {

TEST(ServoRateStory, IsChosenInThePanelAndRemembered) {
  {
    Story story("02_sphere");
    story.perform("dock.servo", true);
    story.perform("session.start");
    story.run(500);
    auto* choice = story.find<QComboBox>("panel.servo.rate_choice");
    EXPECT_EQ(choice->currentText(), "1000 Hz");
    EXPECT_EQ(choice->count(), 7);
    ASSERT_TRUE(story.perform("servo.rate", 4000));
    EXPECT_EQ(story.host().rateHz(), 4000);
    EXPECT_EQ(choice->currentText(), "4000 Hz");
    EXPECT_TRUE(story.host().running());
    story.run(2000);
    story.settle();
    EXPECT_EQ(story.find<QLabel>("panel.servo.rate.0")->text(), "4000 Hz");
    EXPECT_EQ(story.find<QLabel>("status.rate")->text(), "4000 Hz");
    ASSERT_TRUE(story.perform("servo.rate", 300));
    EXPECT_EQ(choice->count(), 8) << "the present one beside the usual ones";
    EXPECT_EQ(choice->currentText(), "300 Hz");
  }
  EXPECT_EQ(readSettings().servo_rate_hz, 300);
  { Story again("02_sphere", {.first_start = false}); }  // at 1000 Hz, as a command line may say
  EXPECT_EQ(readSettings().servo_rate_hz, 300) << "nobody chose another";
}

TEST(ServoRateStory, ARefusalIsSaidAndTheChooserShowsWhatHolds) {
  Story story("02_sphere");
  story.perform("dock.servo", true);
  story.settle();
  EXPECT_FALSE(story.perform("servo.rate", 50));
  EXPECT_TRUE(story.find<QLabel>("panel.servo.told")->text().contains("100 to 10000"));
  story.host().record(std::make_shared<servo::Tap>(1'000'000));
  EXPECT_FALSE(story.perform("servo.rate", 2000));
  EXPECT_TRUE(story.find<QLabel>("panel.servo.told")->text().contains("Stop the recording"));
  EXPECT_EQ(story.find<QComboBox>("panel.servo.rate_choice")->currentText(), "1000 Hz");
  story.host().endRecord();
  EXPECT_TRUE(story.perform("servo.rate", 2000));
  EXPECT_FALSE(story.find("panel.servo.told")->isVisible());
}

TEST(ServoRateStory, WhatWasMeasuredOfAStepAtAnotherRateIsGone) {
  Story story("01_point");
  story.perform("dock.step", true);
  ASSERT_TRUE(story.perform("step.measure"));
  EXPECT_NE(story.find<QLabel>("panel.step.table.2.2")->text(), "");
  ASSERT_TRUE(story.perform("servo.rate", 500));
  EXPECT_EQ(story.find<QLabel>("panel.step.table.2.2")->text(), "");
}

TEST(ServoRateStory, WhenALimitActedStaysTheSameTimeAgo) {
  Story story("02_sphere");
  LimitsSection limits;
  servo::TickRecord record;
  record.tick = 4000;
  record.level = 1.0;
  record.limits = safety::kSlewBit;
  record.cut_N = 0.25;
  limits.add(record);
  servo::Snapshot snapshot;
  snapshot.ticks = 7000;
  const auto note = [&limits] { return limits.findChild<QLabel*>("panel.servo.limit.slew.note")->text(); };
  limits.present(snapshot, 1000);
  EXPECT_EQ(note(), "last 3 s ago, at most 0.25 N");
  limits.setRate(7000, 1000, 4000);
  limits.present(snapshot, 4000);
  EXPECT_EQ(note(), "last 3 s ago, at most 0.25 N");
}

}  // namespace underact::gui::test
