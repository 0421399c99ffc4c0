#include <gtest/gtest.h>

#include <QLabel>
#include <QPushButton>
#include <QSettings>
#include <QSignalSpy>
#include <QTest>

#include "app/gui/visitor/shown_scenes.h"
#include "app/gui/visitor/title_card.h"
#include "app/gui/visitor/visitor_settings.h"
#include "tests/gui/desk.h"

namespace underact::gui::test {

TEST(VisitorSettings, AreKeptWithinTheirRangesAndFilesThatAreGoneAreLeftOut) {
  QSettings().clear();
  writeVisitorSettings({{shippedScene("05_circle"), "/gone.json"}, 5, 500});
  const VisitorSettings visitor_settings = readVisitorSettings();
  EXPECT_EQ(visitor_settings.scenes, QStringList{shippedScene("05_circle")});
  EXPECT_EQ(visitor_settings.dwell_s, kShortestDwell_s);
  EXPECT_EQ(visitor_settings.force_percent, kMaxForce_percent);
}

TEST(VisitorSettings, WhereNoneIsLeftThereAreSomeThatComeWithTheProgram) {
  QSettings().clear();
  writeVisitorSettings({{"/gone.json"}, 30, 50});
  const VisitorSettings visitor_settings = readVisitorSettings();
  EXPECT_GT(visitor_settings.scenes.size(), 3);
  EXPECT_TRUE(visitor_settings.scenes.first().endsWith("02_sphere.json"));
  EXPECT_EQ(visitor_settings.dwell_s, 30);
}

TEST(TitleCard, WhatIsWrongStandsInPlaceOfWhatToTryAndStartOnlyWhereNothingPushes) {
  TitleCard card(nullptr);
  card.setScene("Sphere", "A ball.", "Press it.");
  const auto hidden = [&card](const char* name) { return card.findChild<QWidget*>(name)->isHidden(); };
  card.setState(true, {});
  EXPECT_FALSE(hidden("visitor.go"));
  EXPECT_FALSE(hidden("visitor.try"));
  EXPECT_TRUE(hidden("visitor.trouble"));
  card.setState(false, "The arm stopped answering.");
  EXPECT_TRUE(hidden("visitor.go"));
  EXPECT_TRUE(hidden("visitor.try"));
  EXPECT_EQ(card.findChild<QLabel*>("visitor.trouble")->text(), QString("The arm stopped answering."));
  QSignalSpy next(&card, &TitleCard::nextAsked);
  card.findChild<QPushButton*>("visitor.next")->click();
  EXPECT_EQ(next.count(), 1);
}

TEST(TitleCard, NextStaysWhereItIsWhateverComesAndGoes) {
  TitleCard card(nullptr);
  card.setScene("Sphere", "A ball.", "Press it.");
  card.fitInto(800);
  card.resize(1280, card.height());
  card.show();
  const auto* const next = card.findChild<QPushButton*>("visitor.next");
  const auto place = [&] {
    QTest::qWait(20);
    return next->geometry();
  };
  card.showWayOut(true);
  const QRect at_first = place();
  card.showWayOut(false);
  EXPECT_EQ(place(), at_first);
  card.setState(true, "The arm stopped answering.");
  EXPECT_EQ(place(), at_first);
  card.setState(true, {});
  card.setScene("Sphere", "A ball.", QString("Press it, and press it again. ").repeated(3));
  EXPECT_EQ(place(), at_first);
}

TEST(ShownScenes, OneThatCannotBeShownIsNamedAndTheOthersAreReadWithTheirWords) {
  const ShownScenes shown = loadShownScenes({shippedScene("05_circle"), "/no/such.json"}, false, {});
  ASSERT_EQ(shown.scenes.size(), 1U);
  EXPECT_FALSE(shown.scenes.front().title.isEmpty() || shown.scenes.front().feel.isEmpty());
  EXPECT_EQ(shown.refused, QStringList{"such.json"});
}

}  // namespace underact::gui::test
