#include <gtest/gtest.h>

#include <array>
#include <filesystem>
#include <fstream>
#include <iterator>

#include "app/page/page.h"
#include "tests/support/mutate.h"
#include "tests/support/property.h"

namespace underact::page {
namespace {

std::vector<std::string> theGuide() {
  std::vector<std::string> texts{
      "# A\n\n$$\\frac{a}{\\sqrt{b}}=\\begin{bmatrix}1&2\\\\3&4\\end{bmatrix}^T\\vec{v}$$\n\n- a $x_1^2$\n- "
      "[b](c.md)\n",
      "$$\\left[\\frac{\\dot q}{2}\\right]_0^1 \\begin{cases} 0 & x<0 \\\\ 1 \\end{cases}$$ | a | b |\n|--|:-:|\n| $a$ "
      "| c |"};
  for (const auto& file : std::filesystem::directory_iterator(std::string(UNDERACT_SOURCE) + "/resources/guide")) {
    std::ifstream in(file.path(), std::ios::binary);
    if (file.path().extension() == ".md")
      texts.emplace_back(std::istreambuf_iterator<char>(in), std::istreambuf_iterator<char>());
  }
  return texts;
}

/// Whether every element that is opened is closed, in its order; and nothing stands there that readPage() does not
/// make.
bool isWellFormed(const std::string& html) {
  std::vector<std::string> open;
  for (std::size_t at = html.find('<'); at != std::string::npos; at = html.find('<', at + 1)) {
    const std::size_t end = html.find('>', at);
    if (end == std::string::npos) return false;
    const std::string tag = html.substr(at + 1, html.find_first_of(" >", at + 1) - at - 1);
    if (tag == "br" || tag == "hr" || tag == "img") continue;
    if (tag.empty() || tag[0] != '/') {
      open.push_back(tag);
      continue;
    }
    if (open.empty() || open.back() != tag.substr(1)) return false;
    open.pop_back();
  }
  return open.empty();
}

TEST(PageMutations, EachIsAPageOfMatchingElementsOfBoundedLength) {
  static const std::array<const char*, 28> kTokens{"$",
                                                   "$$",
                                                   "\\",
                                                   "{",
                                                   "}",
                                                   "_",
                                                   "^",
                                                   "&",
                                                   "\\\\",
                                                   "\\frac",
                                                   "\\begin{bmatrix}",
                                                   "\\end{bmatrix}",
                                                   "\\left(",
                                                   "\\right",
                                                   "\\sqrt",
                                                   "|",
                                                   "\n\n",
                                                   "\n",
                                                   "- ",
                                                   "> ",
                                                   "1. ",
                                                   "# ",
                                                   "`",
                                                   "```\n",
                                                   "[",
                                                   "](",
                                                   "![",
                                                   "\xF0"};
  test::Random random(test::Seed{20070701});
  const std::vector<std::string> texts = theGuide();
  const int count = test::sweep(4000, 400'000);
  int with_formula = 0;
  for (int i = 0; i < count; ++i) {
    std::string text = texts[i % 2 == 0 ? random.below(2) : random.below(texts.size())];
    const std::size_t from = random.below(text.size());
    text = test::mutated(random, text.substr(from > 600 ? from : 0, 3000), kTokens);
    const Page page = readPage(text, "mutated");
    ASSERT_LE(page.html.size(), 2000 + 200 * text.size()) << text;
    ASSERT_TRUE(!page.problems.empty() || isWellFormed(page.html)) << text << "\n" << page.html;
    with_formula += page.html.find("class=\"formula\"") != std::string::npos ? 1 : 0;
  }
  EXPECT_GT(with_formula, count / 10) << "the mutator leaves nothing whole";
}

TEST(PageMutations, ReadsLargePagesInTime) {
  for (const char* part : {"$", "$$x$$", "[", "](", "*", "_", "`", "> ", "- ", "\n", "|", "![", "&amp;", "<", "\\("}) {
    std::string text;
    while (text.size() < 100'000) text += part;
    readPage(text, "large");
  }
}

}  // namespace
}  // namespace underact::page
