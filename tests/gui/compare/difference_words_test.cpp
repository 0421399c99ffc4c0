#include "app/gui/compare/difference_words.h"

#include <gtest/gtest.h>

namespace underact::gui::test {

TEST(DifferenceWords, ASettingIsNamedAsInItsPanelWithItsUnit) {
  const DifferenceWords words = differenceWords({"control.kp_N_per_mm", "0.25", "0.5"});
  EXPECT_EQ(words.what, "stiffness");
  EXPECT_EQ(words.one, "0.25 N/mm");
  EXPECT_EQ(words.other, "0.5 N/mm");
}

TEST(DifferenceWords, AChoiceIsWrittenAsInItsList) {
  EXPECT_TRUE(differenceWords({"control.law", "P", "PD"}).other.startsWith("PD,"));
}

TEST(DifferenceWords, WhatBelongsToAConstraintNamesItAndNoKeyIsLeft) {
  const DifferenceWords words = differenceWords({"ball.radius_mm", "50", "40"});
  EXPECT_EQ(words.what, QString::fromUtf8("radius of “ball”"));
  EXPECT_EQ(words.other, "40 mm");
  EXPECT_EQ(differenceWords({"ball.friction.static", "", "0.4"}).what, QString::fromUtf8("static friction of “ball”"));
  EXPECT_EQ(differenceWords({"ball.friction.static", "", "0.4"}).one, "not set");
}

}  // namespace underact::gui::test
