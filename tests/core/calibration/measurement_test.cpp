#include "core/calibration/measurement.h"

#include <gtest/gtest.h>

#include <cmath>
#include <sstream>

namespace underact::calibration {
namespace {

Beam other(Beam beam) {
  return beam == Beam::Left ? Beam::Right : Beam::Left;
}

/// Answers as measured, one letter each: r right, w wrong.
Measurement measured(const char* answers, std::uint64_t seed = 3) {
  Measurement run = beginMeasurement(0.03, seed);
  for (const char* answer = answers; *answer != '\0'; ++answer) {
    run = answered(std::move(run), *answer == 'r' ? run.trial.stiffer : other(run.trial.stiffer));
  }
  return run;
}

}  // namespace

TEST(Measurement, KeepsEveryTrialAndMarksWhereTheWayTurned) {
  const Measurement run = measured("rrrrwrr");
  ASSERT_EQ(run.answers.size(), 7u);
  std::string turns, rights;
  for (const Answered& one : run.answers) {
    turns += one.turned ? 't' : '-';
    rights += one.isRight() ? 'r' : 'w';
  }
  EXPECT_EQ(rights, "rrrrwrr");
  EXPECT_EQ(turns, "----t-t");
  EXPECT_EQ(run.answers[4].trial.difference, 0.125);
  EXPECT_EQ(run.trial.difference, run.staircase.difference);
}

TEST(Measurement, TheSameSeedDrawsTheSameSidesAndAnotherOneOthers) {
  const auto sides = [](std::uint64_t seed) {
    std::string all;
    for (const Answered& one : measured("rrrrrrrrrrrrrrrrrrrr", seed).answers) all += name(one.trial.stiffer);
    return all;
  };
  EXPECT_EQ(sides(3), sides(3));
  EXPECT_NE(sides(3), sides(4));
}

// The thresholds that the staircase is tested to find: expm1(0.5450 s), where s scatters the ratio of two presses.
TEST(Measurement, TheScatterIsThatOfOnePress) {
  for (const double share : {0.05, 0.15, 0.4}) {
    const double ratio = share * std::sqrt(2.0);
    EXPECT_NEAR(scatterOf(std::expm1(0.5450 * ratio)), share, 1e-12);
  }
}

TEST(Measurement, WritesALineATrialUnderALineThatSumsItUp) {
  const Measurement run = measured("rrwrrwrrwrrwrrwrr");
  ASSERT_TRUE(isDone(run));
  std::istringstream csv(csvOf(run, "a person", 3));
  std::string line;
  std::getline(csv, line);
  EXPECT_EQ(line.rfind("# just-noticeable difference 0.42257", 0), 0u) << line;  // of 0.5 and 0.5 / 1.4
  EXPECT_NE(line.find("reference 0.03 N/mm; trials 17; answered by a person; seed 3"), std::string::npos) << line;
  std::getline(csv, line);
  EXPECT_EQ(line, "trial,difference,stiffer,answer,right");
  std::size_t rows = 0;
  while (std::getline(csv, line)) {
    const Answered& one = run.answers.at(rows);
    std::ostringstream wanted;
    wanted << ++rows << ',';
    ASSERT_EQ(line.rfind(wanted.str(), 0), 0u) << line;
    EXPECT_EQ(std::stod(line.substr(wanted.str().size())), one.trial.difference);
    EXPECT_EQ(line.back(), one.isRight() ? '1' : '0');
  }
  EXPECT_EQ(rows, run.answers.size());
  EXPECT_EQ(csvOf(measured("rr"), "a person", 3).rfind("# just-noticeable difference none;", 0), 0u);
}

}  // namespace underact::calibration
