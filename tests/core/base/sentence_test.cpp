#include "core/base/sentence.h"

#include <gtest/gtest.h>

#include <cmath>

namespace underact {
namespace {

TEST(Sentence, IsItsEnglishAndKnowsWhatItWasMadeFrom) {
  const Sentence sentence = phrase("%2 is not %1.", {phrase("a number"), "kp"});
  EXPECT_EQ(sentence, "kp is not a number.");
  EXPECT_EQ(sentence.pattern(), "%2 is not %1.");
  ASSERT_EQ(sentence.places().size(), 2U);
  EXPECT_EQ(sentence.places()[0].pattern(), "a number");
  EXPECT_EQ(sentence.places()[1].pattern(), "") << "a name is the same in every language";
}

TEST(Sentence, IsPlainOnceItWasTakenApart) {
  const Sentence sentence = phrase("Nothing is there.");
  const Sentence more = sentence + " Really.";
  EXPECT_EQ(more, "Nothing is there. Really.");
  EXPECT_EQ(more.pattern(), "");
}

TEST(Sentence, NumbersAreToldFromOtherDigits) {
  EXPECT_TRUE(shownNumber("0.5").isNumber());
  EXPECT_FALSE(Sentence("0.5").isNumber());
  EXPECT_EQ(phrase("%1 mm", {shownNumber("0.5")}), "0.5 mm");
  EXPECT_TRUE(shownNumber(0.5, 1).isNumber());
}

TEST(Sentence, NumbersHaveTheDecimalsAskedForAndNoMinusBeforeZero) {
  EXPECT_EQ(shownNumber(-12.345, 2), "-12.35");
  EXPECT_EQ(shownNumber(-0.004, 2), "0.00");
  EXPECT_EQ(shownNumber(HUGE_VAL, 2), "–");
}

TEST(Sentence, SeveralStandOneAfterAnother) {
  const Sentence both = oneAfterAnother({"", phrase("One."), "", phrase("Two."), "Three."});
  EXPECT_EQ(both, "One. Two. Three.");
  EXPECT_EQ(both.places().size(), 2U);
  EXPECT_EQ(oneAfterAnother({"", phrase("One.")}).pattern(), "One.");
  EXPECT_TRUE(oneAfterAnother({}).empty());
}

TEST(Filled, LeavesAloneWhatIsNoPlaceAndWhatAWordHolds) {
  EXPECT_EQ(filled("%1 of 50 % and %3 at %", {"%2", "b"}), "%2 of 50 % and %3 at %");
  EXPECT_EQ(filled("%2%1", {"a", "b"}), "ba");
  EXPECT_EQ(filled("", {"a"}), "");
}

}  // namespace
}  // namespace underact
