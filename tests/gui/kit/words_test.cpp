#include "app/gui/kit/words.h"

#include <gtest/gtest.h>

namespace underact::gui::test {

TEST(Words, NumbersHaveARealMinusAndNoNegativeZero) {
  EXPECT_EQ(numberText(-1.24, 1), QString(QChar(0x2212)) + "1.2");
  EXPECT_EQ(numberText(-0.04, 1), "0.0");
  EXPECT_EQ(numberText(kNotANumber, 1), QString(QChar(0x2013)));
  EXPECT_EQ(directionText({0, 0, -2}), QString("0.000, 0.000, ") + QChar(0x2212) + "1.000");
}

TEST(Words, AFileNameKeepsTheLettersOfEveryScriptAndNothingElse) {
  EXPECT_EQ(fileNameOf(" Émilie  du Châtelet "), "Émilie-du-Châtelet");
  EXPECT_EQ(fileNameOf("李明"), "李明");
  EXPECT_EQ(fileNameOf("../../etc/passwd"), "etc-passwd");
  EXPECT_EQ(fileNameOf("C:\\a|b?*\n\x1b"), "C-a-b");
  EXPECT_EQ(fileNameOf(QString::fromUtf8("a\u202Eb")), "a-b");
  EXPECT_EQ(fileNameOf("..."), "");
  EXPECT_EQ(fileNameOf(QString(500, QChar(0x674e))).size(), 60);
}

}  // namespace underact::gui::test
