#include "core/helper/sentence_codec.h"

#include <gtest/gtest.h>

#include <chrono>

namespace underact::helper {
namespace {

TEST(Words, ComeThroughWithTheirPatterns) {
  const Sentence sentence =
      phrase("It holds %1, and is too short.", {phrase("%1 and %2", {"2 corners", phrase("%1 faces", {"12"})})});
  const std::optional<Sentence> come = decodeSentence(encodeSentence(sentence));
  ASSERT_TRUE(come);
  EXPECT_EQ(*come, sentence);
  EXPECT_EQ(come->pattern(), sentence.pattern());
  EXPECT_EQ(come->places().at(0).places().at(1).pattern(), "%1 faces");
}

TEST(Words, ReadAnEmptyTextAsNoSentence) {
  EXPECT_EQ(decodeSentence(""), Sentence());
  for (const char* letters : {"0", "0no end of the line", "1%1 of nothing\n", "0one\n0two\n", "xnumber\n", "\n"})
    EXPECT_FALSE(decodeSentence(letters)) << letters;
}

// A pattern of eight places, each filled with one of eight places: 8^20 words of a file of 500 letters.
TEST(Words, DoNotGrowWithoutBound) {
  std::string letters;
  for (int nested = 0; nested < 20; ++nested) letters += "1%1%1%1%1%1%1%1%1\n";
  const auto start = std::chrono::steady_clock::now();
  EXPECT_FALSE(decodeSentence(letters + "0x\n"));
  EXPECT_FALSE(decodeSentence("1%1%1%1%1%1%1%1%1\n1%1%1%1%1%1%1%1%1\n1%1%1%1%1%1%1%1%1\n1%1%1%1\n0xx\n")) << "too long";
  EXPECT_LT(std::chrono::steady_clock::now() - start, std::chrono::seconds(1));
  std::string deep;
  for (int nested = 0; nested < 100; ++nested) deep += "1%1\n";
  EXPECT_FALSE(decodeSentence(deep + "0x\n"));
}

TEST(Words, ThatAreTooManyAreCutAndPlain) {
  const std::optional<Sentence> come = decodeSentence(encodeSentence(phrase("It says %1.", {std::string(2000, 'x')})));
  ASSERT_TRUE(come);
  EXPECT_EQ(come->substr(0, 12), "It says xxxx");
  EXPECT_LE(come->size(), kMaxLetters);
}

}  // namespace
}  // namespace underact::helper
