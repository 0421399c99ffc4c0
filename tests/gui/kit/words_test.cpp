#include "app/gui/kit/words.h"

#include <gtest/gtest.h>

namespace underact::gui::test {

TEST(Words, NumbersHaveARealMinusAndNoNegativeZero) {
  EXPECT_EQ(numberText(-1.24, 1), QString(QChar(0x2212)) + "1.2");
  EXPECT_EQ(numberText(-0.04, 1), "0.0");
  EXPECT_EQ(numberText(kNotANumber, 1), QString(QChar(0x2013)));
  EXPECT_EQ(directionText({0, 0, -2}), QString("0.000, 0.000, ") + QChar(0x2212) + "1.000");
}

}  // namespace underact::gui::test
