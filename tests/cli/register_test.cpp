#include <gtest/gtest.h>

#include <cstdlib>

#include "core/registration/registration_file.h"
#include "core/registration/registration_store.h"
#include "tests/cli/session.h"
#include "tests/support/scratch_folder.h"

namespace underact::test {
namespace {

using cli::Exit;
using json::Value;

// An arm that stands straight, its W at 60, 50 and 30 mm (right, up, away) from mark 1.
const char* const kPoints = "x,y,z\n-60,-50,30\n60,-50,30\n-60,-50,-50\n";
const char* const kExchanged = "60,-50,30\n-60,-50,30\n-60,-50,-50\n";

Outcome runRegistration(const std::string& points, std::vector<std::string> more = {}) {
  const ScratchFile file(points, "points.csv");
  std::vector<std::string> arguments{"register", "--points", file.path()};
  arguments.insert(arguments.end(), more.begin(), more.end());
  return runCli(arguments);
}

TEST(Register, PointsOfTheSheetGiveThePoseOfTheArm) {
  const Outcome outcome = runRegistration(kPoints, {"--json"});
  ASSERT_EQ(outcome.exit, Exit::Success) << outcome.err;
  const Value result = lines(outcome.out).at(0);
  const double expected[4][4] = {{1, 0, 0, 60}, {0, 1, 0, 50}, {0, 0, 1, -30}, {0, 0, 0, 1}};
  for (std::size_t row = 0; row < 4; ++row) {
    for (std::size_t column = 0; column < 4; ++column)
      EXPECT_NEAR(result.find("X_DW")->items.at(row).items.at(column).number, expected[row][column], 1e-12);
  }
  EXPECT_LT(numberAt(result, "rms_mm"), 1e-12);
  EXPECT_EQ(result.find("residuals_mm")->items.size(), 3U);
  EXPECT_TRUE(result.find("warnings")->items.empty());
  EXPECT_TRUE(isNullAt(result, "arm"));
  EXPECT_TRUE(outcome.err.empty()) << outcome.err;
}

TEST(Register, ResidualsAndTheExpectedErrorAreATable) {
  const Outcome outcome = runRegistration("-60,-50,31\n60,-50,30\n-60,-50,-50\n");
  ASSERT_EQ(outcome.exit, Exit::Success) << outcome.err;
  EXPECT_NE(outcome.out.find("residual_mm"), std::string::npos) << outcome.out;
  EXPECT_NE(outcome.out.find("Distance of the points from their reference points: 0."), std::string::npos)
      << outcome.out;
  EXPECT_NE(outcome.out.find("Expected error in the middle of the workspace: "), std::string::npos);
}

TEST(Register, MarksInExchangeAreNamedAndNothingIsKept) {
  const ScratchFolder scratch;
  const Outcome outcome = runRegistration(kExchanged, {"--json", "--out", scratch.file("r.json")});
  EXPECT_EQ(outcome.exit, Exit::BadInput);
  EXPECT_NE(outcome.err.find("The reference points 1 and 2 were probably swapped"), std::string::npos) << outcome.err;
  EXPECT_NE(outcome.err.find("It was not saved."), std::string::npos);
  const Value warning = lines(outcome.out).at(0).find("warnings")->items.at(0);
  EXPECT_EQ(textAt(warning, "kind"), "order");
  EXPECT_EQ(warning.find("marks")->items.at(1).number, 2.0);
  EXPECT_FALSE(std::filesystem::exists(scratch.file("r.json")));
}

TEST(Register, ItIsKeptForItsArmAndReadAgain) {
  const ScratchFolder scratch;
  setenv("UNDERACT_REGISTRATION_DIR", scratch.file("kept").c_str(), 1);
  EXPECT_EQ(runRegistration(kPoints, {"--keep"}).exit, Exit::Usage);  // of which arm?
  ASSERT_EQ(runRegistration(kPoints, {"--keep", "--of", "wooden:0042", "--out", scratch.file("r.json")}).exit,
            Exit::Success);
  const auto kept = registration::loadRegistration("wooden:0042", scratch.file("kept"));
  ASSERT_TRUE(kept && kept.value());
  EXPECT_EQ(kept.value()->touches.size(), 3U);
  EXPECT_EQ(kept.value()->date.size(), 10U);
  const Outcome again = runCli({"register", "--points", scratch.file("r.json"), "--json"});
  ASSERT_EQ(again.exit, Exit::Success) << again.err;
  EXPECT_EQ(textAt(lines(again.out).at(0), "arm"), "wooden:0042");
  unsetenv("UNDERACT_REGISTRATION_DIR");
}

TEST(Register, OwnMarksComeFromAFile) {
  const ScratchFile marks("# right away up\n0 0 0\n200 0 0\n0 150 0\n100 50 40\n", "marks.txt");
  const Outcome outcome =
      runRegistration("0 0 0\n200 0 0\n0 0 -150\n100 40 -50\n", {"--marks", marks.path(), "--json"});
  ASSERT_EQ(outcome.exit, Exit::Success) << outcome.err;
  EXPECT_LT(numberAt(lines(outcome.out).at(0), "rms_mm"), 1e-12);
}

TEST(Register, NamesEachErrorWithItsExitStatus) {
  EXPECT_EQ(runCli({"register"}).exit, Exit::Usage);
  EXPECT_EQ(runCli({"register", "--points", "a.csv", "--device", "simulated"}).exit, Exit::Usage);
  EXPECT_EQ(runCli({"register", "--points", "/nowhere/a.csv"}).exit, Exit::File);
  EXPECT_EQ(runCli({"register", "--points", "/nowhere/a.json"}).exit, Exit::File);
  const Outcome few = runRegistration("0 0 0\n1 2 3\n");
  EXPECT_EQ(few.exit, Exit::BadInput);
  EXPECT_NE(few.err.find("3 reference points and 2 touched points"), std::string::npos) << few.err;
  const Outcome line = runRegistration("0 0 0\n100 0 0\n200 0 0\n");
  EXPECT_EQ(line.exit, Exit::BadInput);
  EXPECT_NE(line.err.find("one line"), std::string::npos) << line.err;
  EXPECT_EQ(runRegistration("0 0 zero\n").exit, Exit::BadInput);
  EXPECT_EQ(runRegistration(kPoints, {"--out", "/nowhere/r.json"}).exit, Exit::File);
  EXPECT_EQ(runRegistration(kPoints, {"--marks", "9"}).exit, Exit::File);  // no file of that name
}

TEST(Register, AnArmThatNobodyTouchesWithIsSaid) {
  EXPECT_EQ(runCli({"register", "--device", "toaster"}).exit, Exit::Fault);
  const Outcome nobody = runCli({"register", "--device", "simulated", "--wait_s", "0.2"});
  EXPECT_EQ(nobody.exit, Exit::Fault);
  EXPECT_NE(nobody.err.find("No force is sent."), std::string::npos) << nobody.err;
  EXPECT_NE(nobody.err.find("Nobody pressed"), std::string::npos) << nobody.err;
}

TEST(Register, TheAccuracyIsThatOfTheFormulaAndTheSameForTheSameSeed) {
  const Outcome outcome = runCli({"register", "--accuracy", "--draws", "3000", "--json"});
  ASSERT_EQ(outcome.exit, Exit::Success);
  const std::vector<Value> rows = lines(outcome.out);
  ASSERT_EQ(rows.size(), 16U);
  for (const Value& row : rows) {
    EXPECT_NEAR(numberAt(row, "seen_mm") / numberAt(row, "expected_mm"), 1.0, 0.06);
    EXPECT_LT(numberAt(row, "left_mm"), numberAt(row, "touching_mm"));
  }
  EXPECT_EQ(runCli({"register", "--accuracy", "--draws", "3000", "--json"}).out, outcome.out);
}

}  // namespace
}  // namespace underact::test
