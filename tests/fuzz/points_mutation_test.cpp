#include <array>
#include <fstream>
#include <iterator>
#include <string>
#include <utility>
#include <vector>

#include "tests/fuzz/points_judge.h"
#include "tests/support/mutate.h"
#include "tests/support/property.h"

namespace underact::test {
namespace {

std::string pathsFile(const std::string& name) {
  std::ifstream file(std::string(UNDERACT_SOURCE) + "/scenes/paths/" + name, std::ios::binary);
  return {std::istreambuf_iterator<char>(file), {}};
}

std::vector<std::string> thePointFiles() {
  return {pathsFile("trefoil.txt"), pathsFile("signature.txt"), "0 0 0\r\n1,2,3\r\n4;5;6\r\n",
          "x\ty\tz\n1e-3\t.5\t+2\n0\t0\t0\n"};
}

/// One text made of others by a seed: bytes, tokens, cuts and spans that come again.
std::string mutatedPoints(Random& random, const std::vector<std::string>& texts) {
  static const std::array<const char*, 24> kTokens{
      "1e308", "-1e999", "1e-400", "nan", "inf",          "0x1p3", "+",         "-",
      ",",     ";",      ",,",     "#",   "\r",           "\n",    "\r\n",      "\t",
      "1e6",   "0",      "1.",     "1,5", "\xEF\xBB\xBF", "\xC3",  "999999999", "e"};
  std::string text = texts[random.below(texts.size())];
  text.resize(std::min(text.size(), 40 + random.below(400)));
  return test::mutated(random, std::move(text), kTokens);
}

TEST(PointsMutations, EachIsRefusedWithLinesOrMakesCurves) {
  Random random(Seed{20070630});
  const std::vector<std::string> texts = thePointFiles();
  const int count = sweep(20'000, 400'000);
  int accepted = 0;
  for (int i = 0; i < count; ++i) {
    const std::string text = mutatedPoints(random, texts);
    ASSERT_EQ(judgePoints(text), "") << "mutation " << i << ":\n" << text;
    accepted += arePoints(text) ? 1 : 0;
  }
  // A mutator that only makes rubbish, or nothing new, would prove nothing.
  EXPECT_GT(accepted, count / 20);
  EXPECT_LT(accepted, count * 3 / 4);
}

TEST(PointsMutations, EveryPrefixIsWell) {
  for (const std::string& text : thePointFiles()) {
    for (std::size_t length = 0; length <= text.size(); ++length) {
      ASSERT_EQ(judgePoints(std::string_view(text).substr(0, length)), "") << length;
    }
  }
}

TEST(PointsMutations, ReadsLargeFilesInTime) {
  const std::size_t large = 1U << 22U;
  for (const char byte : {'1', ',', ' ', '\n', '\r', '#', 'x', '\0', '-', '.', 'e'}) {
    EXPECT_EQ(judgePoints(std::string(large, byte)), "") << static_cast<int>(byte);
  }
}

}  // namespace
}  // namespace underact::test
