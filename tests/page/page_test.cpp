#include "app/page/page.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace underact::page {
namespace {

bool has(const Page& page, const std::string& html) {
  return page.html.find(html) != std::string::npos;
}

TEST(Page, HeadingsHaveAnchorsAsGitHubMakesThem) {
  const Page page = readPage("# The tick\n\ntext\n\n## Loop rate, in `Hz`\n\n## Loop rate, in Hz\n", "a.md");
  EXPECT_EQ(page.title, "The tick");
  ASSERT_EQ(page.headings.size(), 3u);
  EXPECT_EQ(page.headings[1].anchor, "loop-rate-in-hz");
  EXPECT_EQ(page.headings[1].level, 2);
  EXPECT_EQ(page.headings[2].anchor, "loop-rate-in-hz-1");
  EXPECT_TRUE(
      has(page, "<h2 id=\"loop-rate-in-hz\"><a name=\"loop-rate-in-hz\"></a>Loop rate, in <code>Hz</code></h2>"))
      << page.html;
  EXPECT_TRUE(page.problems.empty());
}

TEST(Page, SectionsHoldTheTextBetweenHeadings) {
  const Page page =
      readPage("before\n\n# One\n\nfirst *word*\nsecond\n\n- item\n\n# Two\n\n| a | b |\n|---|---|\n| c | d |\n", "");
  ASSERT_EQ(page.sections.size(), 3u);
  EXPECT_EQ(page.sections[1].title, "One");
  EXPECT_EQ(page.sections[1].text, "first word second\nitem\n\n") << "a word is none with its neighbour";
  EXPECT_NE(page.sections[2].text.find("c\nd"), std::string::npos);
}

TEST(Page, ASearchFindsAFormulaAsItIsReadAndNotAsTex) {
  const Page page = readPage("# T\n\nThe torque $\\tau = J_p^T f$, and $\\frac{K T}{2} < b$.\n", "");
  const std::string& text = page.sections.back().text;
  EXPECT_EQ(text.find('\\'), std::string::npos) << text;
  EXPECT_EQ(text.find('{'), std::string::npos) << text;
  EXPECT_NE(text.find("τ"), std::string::npos) << text;
  EXPECT_NE(text.find("JpT"), std::string::npos) << text;
  EXPECT_NE(text.find("<"), std::string::npos) << text;
}

TEST(Page, LinksAndPicturesAreListedWithTheirLines) {
  const Page page =
      readPage("a\n\n[b](c.md#d) and\n![e](f.png)\n", "x.md", [](const std::string& to) { return "made/" + to; });
  ASSERT_EQ(page.links.size(), 2u);
  EXPECT_EQ(page.links[0].to, "c.md#d");
  EXPECT_FALSE(page.links[0].is_picture);
  EXPECT_TRUE(page.links[1].is_picture);
  EXPECT_TRUE(has(page, "<a href=\"made/c.md#d\">b</a>")) << page.html;
  EXPECT_TRUE(has(page, "<img src=\"made/f.png\" alt=\"e\">")) << page.html;
}

TEST(Page, FormulasBecomeHtmlAndTheirProblemsHaveALine) {
  const Page page = readPage("An $x_1$ here.\n\nTwo\n\n$$\\frac{a}{b}$$\n\nand $\\nothing$\n", "x.md");
  EXPECT_TRUE(has(page, "<span class=\"formula\"><i>x</i><sub>1</sub></span>")) << page.html;
  EXPECT_TRUE(has(page, "<table class=\"formula\"")) << page.html;
  EXPECT_FALSE(has(page, "<p></p>")) << page.html;
  EXPECT_FALSE(has(page, "<p><table")) << page.html;
  ASSERT_EQ(page.problems.size(), 1u);
  EXPECT_EQ(page.problems[0].place.line, 7);
  EXPECT_TRUE(has(page, "<code class=\"wrong\">\\nothing</code>")) << "as it was written";
}

TEST(Page, ADollarThatIsMoneyOrAShellIsNone) {
  const Page page = readPage("    $ underact-cli fk\n\nIt costs 5 $ here, $HOME is `$HOME`.\n", "x.md");
  EXPECT_TRUE(page.problems.empty());
  EXPECT_FALSE(has(page, "formula")) << page.html;
}

TEST(Page, SpansThatCrossAreClosedInTheirOrder) {
  const Page page = readPage("**[a](*[b:c)**, **[d e](f:g)** and **$$x$$**\n\n# H $$y$$\n", "x.md");
  EXPECT_EQ(page.html.find("<table"), std::string::npos) << "a formula in something bold stays in its line";
  for (const char* tag : {"strong", "em", "a"}) {
    const auto count = [&](const std::string& what) {
      std::size_t found = 0;
      for (std::size_t at = page.html.find(what); at != std::string::npos; at = page.html.find(what, at + 1)) ++found;
      return found;
    };
    const std::string name = tag;
    EXPECT_EQ(count("<" + name + ">") + count("<" + name + " "), count("</" + name + ">")) << page.html;
  }
}

TEST(Page, HtmlOfItsOwnIsText) {
  const Page page = readPage("<script>x</script>\n\na <b>c</b> [l](javascript:x)\n", "x.md");
  EXPECT_FALSE(has(page, "<script")) << page.html;
  EXPECT_FALSE(has(page, "<b>")) << page.html;
}

TEST(Page, CutsWhatIsTooLargeOrTooDeepAndSaysSo) {
  const Page large = readPage(std::string((1U << 20U) + 1, 'x'), "x.md");
  EXPECT_EQ(large.cut, "The text is cut here: it is longer than 1024 KiB.");
  EXPECT_EQ(large.html, "<p>" + std::string(1U << 20U, 'x') + "</p>\n");
  const Page deep = readPage("before\n\n" + std::string(5000, '>') + " x", "x.md");
  EXPECT_EQ(deep.cut, "The text is cut here: it is nested more than 60 deep.");
  EXPECT_EQ(deep.html.find("<p>before</p>"), 0u);
  EXPECT_EQ(deep.problems.size(), 1u);
}

std::string repeated(const std::string& text, std::size_t bytes) {
  std::string all;
  while (all.size() < bytes) all += text;
  return all;
}

// What Qt lays out is counted, not its seconds: 330 kB of paragraphs took 5.4 s, 1 MB of formulas three minutes, and a
// fraction in a fraction, 11 deep, a quarter of an hour.
TEST(Page, AStrangersTextIsCutBeforeItsWorkIsDone) {
  std::string deep = "1";
  for (int level = 0; level < 11; ++level) deep = "\\frac{1}{" + deep + "}";
  const std::string head = "|" + repeated("a|", 200) + "\n|" + repeated("---|", 400) + "\n";
  for (const std::string& text :
       {repeated("a\n\n", 330'000), repeated("$\\frac{a}{b}$ ", 1'000'000), repeated("$\\nothing$ ", 1'000'000),
        repeated("*a* ", 100'000), head + repeated("a\n", 5000), repeated("- a\n", 9000), "$$" + deep + "$$",
        repeated("![](a)", 15'000), repeated("http://a.b/((", 1'000'000), repeated("ä", 20'000)}) {
    const Page page = readPage(text, "about", {}, kStrangersPage);
    EXPECT_EQ(page.cut.find("The text is cut here: it "), 0u) << text.substr(0, 40);
    EXPECT_LE(std::count(page.html.begin(), page.html.end(), '<'), 4000) << text.substr(0, 40);
    EXPECT_LE(page.html.size(), 100'000u) << text.substr(0, 40);
    EXPECT_LE(page.problems.size(), 101u) << text.substr(0, 40);
  }
}

TEST(Page, OnlyTheFirstHundredWrongFormulasAreLookedAt) {
  const Page page = readPage(repeated("$\\nothing$ ", 900'000), "x.md");
  EXPECT_EQ(page.problems.size(), 100u) << "each looks for the command that was meant among all there are";
  EXPECT_TRUE(page.cut.empty());
}

}  // namespace
}  // namespace underact::page
