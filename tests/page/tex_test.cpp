#include "app/page/tex.h"

#include <gtest/gtest.h>

namespace underact::page {
namespace {

Result<std::string> htmlOf(const std::string& tex, bool display, const SourceLocation& place) {
  const Result<TexNode> tree = parseTex(tex, place);
  return tree ? Result<std::string>(texToHtml(tree.value(), display)) : tree.problems();
}

std::string line(const std::string& tex) {
  const Result<std::string> made = htmlOf(tex, false, {});
  if (!made) return "! " + made.problems().front().sentence;
  const std::string start = "<span class=\"formula\">", end = "</span>";
  return made.value().substr(start.size(), made.value().size() - start.size() - end.size());
}

std::string display(const std::string& tex) {
  const Result<std::string> made = htmlOf(tex, true, {});
  return made ? made.value() : "! " + made.problems().front().sentence;
}

std::size_t countOf(const std::string& what, const std::string& text) {
  std::size_t count = 0;
  for (std::size_t at = text.find(what); at != std::string::npos; at = text.find(what, at + 1)) ++count;
  return count;
}

TEST(TexLine, LettersSlantNumbersAndFunctionsStand) {
  EXPECT_EQ(line("x"), "<i>x</i>");
  EXPECT_EQ(line("12.5"), "12.5");
  EXPECT_EQ(line("\\theta"), "<i>θ</i>");
  EXPECT_EQ(line("\\sin\\theta"), "sin\u2009<i>θ</i>");
  EXPECT_EQ(line("\\Delta t"), "Δ<i>t</i>");
}

TEST(TexLine, ScriptsTakeOneAtomOrAGroup) {
  EXPECT_EQ(line("x^2_i"), "<i>x</i><sub><i>i</i></sub><sup>2</sup>");
  EXPECT_EQ(line("x_{12}^T"), "<i>x</i><sub>12</sub><sup><i>T</i></sup>");
  EXPECT_EQ(line("J^\\top f"), "<i>J</i><sup>T</sup><i>f</i>");
  EXPECT_EQ(line("q_{i-1}"), "<i>q</i><sub><i>i</i>−1</sub>");
}

TEST(TexLine, AMinusAtTheStartIsASignAndBetweenTwoAnOperator) {
  EXPECT_EQ(line("-x"), "−<i>x</i>");
  EXPECT_EQ(line("a-b"), "<i>a</i> − <i>b</i>");
  EXPECT_EQ(line("a = -b"), "<i>a</i> = −<i>b</i>");
  EXPECT_EQ(line("(-b)"), "(−<i>b</i>)");
}

TEST(TexLine, FractionsStandOnALineWithBracketsWhereNeeded) {
  EXPECT_EQ(line("\\frac{1}{2}"), "1/2");
  EXPECT_EQ(line("\\frac{a+b}{c}"), "(<i>a</i> + <i>b</i>)/<i>c</i>");
}

TEST(TexLine, RootsAccentsBoldAndWords) {
  EXPECT_EQ(line("\\sqrt{x}"), "√<i>x</i>");
  EXPECT_EQ(line("\\sqrt{a+b}"), "√(<i>a</i> + <i>b</i>)");
  EXPECT_EQ(line("\\vec{v}"), "<i>v\u20d7</i>");
  EXPECT_EQ(line("\\dot x"), "<i>x\u0307</i>");
  EXPECT_EQ(line("\\mathbf{J}"), "<b><i>J</i></b>");
  EXPECT_EQ(line("5\\,\\text{N/mm}"), "5\u2009N/mm");
}

TEST(TexLine, AMatrixStandsInBracketsRowByRow) {
  EXPECT_EQ(line("\\begin{bmatrix}1&2\\\\3&4\\end{bmatrix}"), "[1, 2; 3, 4]");
}

TEST(TexLine, WhatHtmlTakesForItsOwnIsEscaped) {
  EXPECT_EQ(line("a < b"), "<i>a</i> &lt; <i>b</i>");
  EXPECT_EQ(line("\\text{<b>}"), "&lt;b&gt;");
}

TEST(TexDisplay, AFractionIsATableWithALine) {
  const std::string made = display("x = \\frac{a}{b}");
  EXPECT_EQ(countOf("<table", made), 2u) << made;
  EXPECT_EQ(countOf("class=\"over\"", made), 1u);
  EXPECT_EQ(countOf("class=\"under\"", made), 1u);
}

TEST(TexDisplay, AMatrixHasACellForEachEntryAndForMissingOnes) {
  const std::string made = display("\\begin{bmatrix} a & b & c \\\\ d \\end{bmatrix}^T");
  EXPECT_EQ(countOf("class=\"entry\"", made), 6u) << made;
  EXPECT_EQ(countOf("class=\"open\"", made), 1u);
  EXPECT_EQ(countOf("class=\"close\"", made), 1u);
  EXPECT_NE(made.find("valign=\"top\""), std::string::npos) << "of the T";
}

TEST(TexDisplay, TagsMatch) {
  for (const char* tex :
       {"x", "\\frac{\\frac{a}{b}}{\\sqrt{\\frac{c}{d}}}", "\\left[\\frac{a}{b}\\right)_2^3",
        "\\begin{cases} 0 & x < 0 \\\\ 1 & \\text{else} \\end{cases}",
        "\\begin{aligned} a &= b \\\\ &= \\frac{c}{d} \\end{aligned}", "\\begin{vmatrix}a\\end{vmatrix}"}) {
    const std::string made = display(tex);
    ASSERT_NE(made.front(), '!') << tex << made;
    for (const char* tag : {"table", "tr", "td", "i", "small", "span"})
      EXPECT_EQ(countOf(std::string("<") + tag + ">", made) + countOf(std::string("<") + tag + " ", made),
                countOf(std::string("</") + tag + ">", made))
          << tag << " of " << tex << ": " << made;
  }
}

TEST(TexProblems, AnUnknownCommandIsNamedWithTheOneMeant) {
  EXPECT_EQ(line("\\thetta"), "! \\thetta is not a command that formulas support. Is \\theta meant?");
  const Result<std::string> two = htmlOf("\\foo + \\bar{x} + \\baz", false, {"page", 7, 0, {}});
  ASSERT_FALSE(two);
  EXPECT_EQ(two.problems().size(), 2u) << "both, and not \\bar";
  EXPECT_EQ(two.problems().front().place.line, 7);
}

TEST(TexProblems, NamesWhatDoesNotMatch) {
  for (const char* tex : {"{", "}", "a & b", "\\frac{a}", "x^", "x_1_2", "\\left(", "\\begin{bmatrix} a", "\\text",
                          "\\", "\\begin{foo}a\\end{foo}", "\\begin{bmatrix}a\\end{pmatrix}", "\\sqrt", "\\right)"})
    EXPECT_EQ(line(tex).substr(0, 2), "! ") << tex << ": " << line(tex);
}

TEST(TexProblems, DepthAndLengthAreBounded) {
  std::string deep;
  for (int i = 0; i < 100; ++i) deep += "\\sqrt";
  EXPECT_EQ(line(deep + "x"), "! A formula is nested more than 24 deep.");
  EXPECT_EQ(line(std::string(100, '{') + std::string(100, '}')), "! A formula is nested more than 24 deep.");
  EXPECT_EQ(line(std::string(5000, 'x')), "! A formula is at most 4000 bytes long.");
  std::string grid = "\\begin{matrix}" + std::string(40, '&');
  for (int row = 0; row < 40; ++row) grid += "\\\\";
  grid += "a\\end{matrix}";  // 41 x 41 cells of 150 bytes
  EXPECT_NE(line(grid + grid).substr(0, 2), "! ");
  EXPECT_EQ(line(grid + grid + grid), "! A matrix has too many cells.") << "together, too";
}

}  // namespace
}  // namespace underact::page
