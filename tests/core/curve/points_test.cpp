#include "core/curve/points.h"

#include <gtest/gtest.h>

#include <cstdio>
#include <fstream>
#include <locale>

namespace underact::curve {
namespace {

std::vector<Vec3> pointsOf(std::string_view text) {
  const Result<std::vector<Vec3>> points = parsePoints(text, "path.txt");
  if (points) return points.value();
  for (const Problem& problem : points.problems()) ADD_FAILURE() << describe(problem);
  return {};
}

Problems problemsOf(std::string_view text) {
  const Result<std::vector<Vec3>> points = parsePoints(text, "path.txt");
  return points ? Problems{} : points.problems();
}

/// "LINE: SENTENCE" of the only problem.
std::string problemOf(std::string_view text) {
  const Problems problems = problemsOf(text);
  if (problems.size() != 1) return std::to_string(problems.size()) + " problems";
  return std::to_string(problems[0].place.line) + ": " + problems[0].sentence;
}

const std::vector<Vec3> kTwo{{1, -2.5, 3e-1}, {4, 5, 6}};

TEST(Points, AreReadWhateverSeparatesThem) {
  EXPECT_EQ(pointsOf("1 -2.5 3e-1\n4 5 6\n"), kTwo);
  EXPECT_EQ(pointsOf("1,-2.5,.3\n4,5,6"), kTwo);
  EXPECT_EQ(pointsOf("1;-2.5;0.3\r\n4;5;6\r\n"), kTwo);
  EXPECT_EQ(pointsOf("\t1\t-2.5\t+0.3\t\n4.\t5\t6\n"), kTwo);
  EXPECT_EQ(pointsOf("1 , -2.5 ,\t0.3\r4 ,5, 6 ;\r"), kTwo);
}

TEST(Points, MayHaveCommentsEmptyLinesAHeaderAndTheMarkOfUtf8) {
  EXPECT_EQ(pointsOf("\xEF\xBB\xBF# a path\n\nx_mm, y_mm, z_mm\n1 -2.5 0.3 # the first\n   \n#4 4 4\n4 5 6\n"), kTwo);
  EXPECT_EQ(problemOf("1 2 3\nx y z\n"), "2: \"x\" is not a number.");  // not in the first line: no header
  EXPECT_EQ(problemOf("x 2 3\n4 5 6\n"), "1: \"x\" is not a number.");  // with a number: none either
}

TEST(Points, MayHaveColoursAndTheirNumberBeforeThem) {
  Sentence note;
  for (const char* text : {"1 -2.5 0.3 255 0 10\n4 5 6 0 0 0\n", "2\n1, -2.5, .3, .5, 0, 1\n4,5,6,0,0,0\n",
                           "x\n 2 \n1 -2.5 0.3 -9 255 0 10\n4 5 6"}) {
    EXPECT_EQ(pointsOf(text), kTwo) << text;
    EXPECT_TRUE(parsePoints(text, "", {}, &note) && !note.empty()) << text;
  }
  EXPECT_TRUE(parsePoints("1 2 3\n", "", {}, &note) && note.empty());
  for (const char* text : {"1 2 3 256 0 0", "1 2 3 0.5 2.5 0", "1 2 3 -1 0 0", "1,5 2,5 3,5", "1,5, 2,5, 3,5,"})
    EXPECT_EQ(problemOf(text), "1: A point is three numbers, not 6; use a point for decimals.") << text;
  EXPECT_EQ(problemOf("\n3\n1 2 3\n4 5 6\n"), "2: A point is three numbers, not 1; use a point for decimals.");
}

TEST(Points, EqualToTheOneBeforeAreLeftOut) {
  EXPECT_EQ(pointsOf("1 -2.5 0.3\n1 -2.5 0.3\n4 5 6\n4 5 6\n4 5 6\n"), kTwo);
  EXPECT_EQ(pointsOf("0 0 0\n1 0 0\n0 0 0\n").size(), 3U);  // but not ones that come back
}

TEST(Points, KeepTheirLastBit) {
  EXPECT_EQ(pointsOf("0.1 1e-320 -1e-400\n")[0], Vec3(0.1, 1e-320, -0.0));
  EXPECT_EQ(pointsOf("9007199254740993 0.30000000000000004 1e308\n")[0],
            Vec3(9007199254740992.0, 0.30000000000000004, 1e308));
}

/// Numbers as much of Europe writes them; where the program's locale has them, streams read them so.
class DecimalCommas : public std::numpunct<char> {
  char do_decimal_point() const override { return ','; }
  char do_thousands_sep() const override { return '.'; }
};

TEST(Points, AreReadAlikeInALocaleWithDecimalCommas) {
  const std::locale before = std::locale::global(std::locale(std::locale(), new DecimalCommas));
  const Result<std::vector<Vec3>> points = parsePoints("1 -2.5 0.3\n4 5 6\n", "path.txt");
  std::locale::global(before);
  ASSERT_TRUE(points);
  EXPECT_EQ(points.value(), kTwo);
}

TEST(Points, EachProblemComesWithItsLine) {
  EXPECT_EQ(problemOf("1 2 3\n1 2\n"), "2: A point is three numbers, not 2; use a point for decimals.");
  EXPECT_EQ(problemOf("1,5;2,5;3,5\n"), "1: A point is three numbers, not 6; use a point for decimals.");
  EXPECT_EQ(problemOf("\n\r\n1,,2,3\n"), "3: There is nothing between two separators; a point is three numbers.");
  EXPECT_EQ(problemOf("1 2 3\n,1,2,3\n"), "2: There is nothing between two separators; a point is three numbers.");
  EXPECT_EQ(problemOf("1 2 3\n1 2 0x10\n"), "2: \"0x10\" is not a number.");
  EXPECT_EQ(problemOf("1 2 +-3\n"), "1: \"+-3\" is not a number.");
  EXPECT_EQ(problemOf("1 2 1e999\n"), "1: \"1e999\" is not a finite number.");
  EXPECT_EQ(problemOf("1 nan 3\n"), "1: \"nan\" is not a finite number.");
  EXPECT_EQ(problemOf("# nothing\nx y z\n"), "0: The file has no points.");
  EXPECT_EQ(problemOf(""), "0: The file has no points.");
}

TEST(Points, AtMostTenProblemsAreSaid) {
  std::string text;
  for (int i = 0; i < 50; ++i) text += "1 2\n";
  ASSERT_EQ(problemsOf(text).size(), kMaxProblems);
  EXPECT_EQ(problemsOf(text).back().place.line, 10);
}

TEST(Points, AreAMillionAtMost) {
  std::string text;
  for (std::size_t i = 0; i < kMaxPoints; ++i) text += i % 2 == 0 ? "0 0 0\n" : "1 0 0\n";
  EXPECT_EQ(pointsOf(text).size(), kMaxPoints);
  EXPECT_EQ(problemOf(text + "0 0 1\n"), "1000001: The file has more than 1000000 points; remove every second one.");
}

TEST(Points, ReadingCanBeWatchedAndCancelled) {
  std::string text;
  for (int i = 0; i < 100'000; ++i) text += std::to_string(i) + " 0 0\n";
  std::atomic<bool> cancelled = false;
  std::vector<double> shares;
  TaskMonitor monitor;
  monitor.cancelled = &cancelled;
  monitor.progress = [&](const char*, double share) {
    shares.push_back(share);
    if (shares.size() == 3) cancelled = true;
  };
  const Result<std::vector<Vec3>> points = parsePoints(text, "path.txt", monitor);
  ASSERT_FALSE(points);
  EXPECT_EQ(points.problems()[0].sentence, "Reading was cancelled.");
  ASSERT_EQ(shares.size(), 3U);
  EXPECT_TRUE(shares[0] == 0.0 && shares[0] < shares[1] && shares[1] < shares[2] && shares[2] < 1.0);
}

TEST(Points, OfAFileHaveItsNameInTheirProblems) {
  const std::string path = testing::TempDir() + "underact_points_test.txt";
  std::ofstream(path) << "1 2 3\n4 5\n";
  const Result<std::vector<Vec3>> points = readPoints(path);
  ASSERT_FALSE(points);
  EXPECT_EQ(describe(points.problems()[0]).substr(0, path.size() + 3), path + ":2:");
  EXPECT_FALSE(readPoints(path + ".none"));
  std::ofstream(path) << "1 -2.5 0.3\n4 5 6\n";
  EXPECT_EQ(readPoints(path).value(), kTwo);
  std::remove(path.c_str());
}

TEST(Points, OfTheScenesPathsAreWhatTheirHeadsSay) {
  const std::string folder = std::string(UNDERACT_SOURCE) + "/scenes/paths/";
  const std::vector<Vec3> loop = readPoints(folder + "trefoil.txt").value();
  ASSERT_EQ(loop.size(), 60U);
  for (std::size_t i = 0; i < loop.size(); ++i) {
    const double a = 2.0 * std::acos(-1.0) * static_cast<double>(i) / 60.0;
    const Vec3 p_mm(13.0 * (std::sin(a) + 2.0 * std::sin(2.0 * a)), 13.0 * (std::cos(a) - 2.0 * std::cos(2.0 * a)),
                    -15.0 * std::sin(3.0 * a));
    ASSERT_LT((loop[i] - p_mm).cwiseAbs().maxCoeff(), 0.0051) << i;  // written to 0.01 mm
  }
  const std::vector<Vec3> stroke = readPoints(folder + "signature.txt").value();
  EXPECT_EQ(stroke.size(), 40U);
  for (const Vec3& p_mm : stroke) EXPECT_LT(p_mm.cwiseAbs().maxCoeff(), 60.0);
}

}  // namespace
}  // namespace underact::curve
