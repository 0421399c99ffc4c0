#include <gtest/gtest.h>

#include <cmath>
#include <fstream>
#include <sstream>

#include "core/json/text.h"
#include "tests/cli/session.h"

namespace underact::test {
namespace {

using cli::Exit;
using json::Value;

Outcome step(std::vector<std::string> more) {
  std::vector<std::string> arguments{"lab", "step"};
  arguments.insert(arguments.end(), more.begin(), more.end());
  return runCli(std::move(arguments));
}

/// The rows of a CSV file below its head.
std::vector<std::vector<std::string>> rowsOf(const std::string& path, const std::string& head) {
  std::ifstream file(path);
  std::string line;
  std::getline(file, line);
  EXPECT_EQ(line, head);
  std::vector<std::vector<std::string>> rows;
  while (std::getline(file, line)) {
    rows.emplace_back();
    std::stringstream cells(line + ',');
    for (std::string cell; std::getline(cells, cell, ',');) rows.back().push_back(cell);
  }
  return rows;
}

TEST(LabStep, PrintsExactlyTheFiveKeysOfTheStepOfAFunction) {
  const Outcome outcome = step({"--num", "1", "--den", "1,0.8,1", "--json"});
  ASSERT_EQ(outcome.exit, Exit::Success) << outcome.err;
  EXPECT_TRUE(outcome.err.empty());
  const Value result = lines(outcome.out).at(0);
  EXPECT_EQ(result.keys, (std::vector<std::string>{"final_value", "rise_10_90_s", "settling_2pct_s", "peak_time_s",
                                                   "overshoot_fraction"}));
  EXPECT_NEAR(numberAt(result, "peak_time_s"), 3.4277586042362875, 1e-12);  // golden, zeta 0.4
  EXPECT_NEAR(numberAt(result, "settling_2pct_s"), 8.409319627664274, 1e-11);
  EXPECT_NEAR(numberAt(result, "overshoot_fraction"), 0.2538267219801087, 1e-13);
}

TEST(LabStep, GivesNullWithTheReasonWhereNothingSettles) {
  const Outcome swings = step({"--num", "1", "--den", "1,0,1", "--json"});
  EXPECT_EQ(swings.exit, Exit::Success);
  EXPECT_TRUE(isNullAt(lines(swings.out).at(0), "settling_2pct_s"));
  EXPECT_NEAR(numberAt(lines(swings.out).at(0), "rise_10_90_s"), 1.0196020938370745, 1e-12);
  EXPECT_NE(swings.err.find("no damping"), std::string::npos);
  const Outcome grows = step({"--num", "1", "--den", "1,-1", "--json"});
  EXPECT_EQ(grows.exit, Exit::Success);
  EXPECT_TRUE(isNullAt(lines(grows.out).at(0), "final_value"));
  EXPECT_NE(grows.err.find("grows"), std::string::npos);
  EXPECT_NE(step({"--den", "1,0"}).err.find("integrator"), std::string::npos);
}

TEST(LabStep, ATableIsForPeople) {
  const Outcome outcome = step({"--num", "1", "--den", "1,0.8,1"});
  EXPECT_NE(outcome.out.find("overshoot         25.3827 %"), std::string::npos) << outcome.out;
  EXPECT_NE(outcome.out.find("-0.4 +- 0.916515i rad/s"), std::string::npos) << outcome.out;
}

TEST(LabStep, WrongUsageIsToldInWords) {
  EXPECT_EQ(step({}).exit, Exit::Usage);
  EXPECT_NE(step({}).err.find("--scene"), std::string::npos);
  EXPECT_EQ(step({"--num", "1"}).exit, Exit::Usage);
  EXPECT_EQ(step({"--num", "one", "--den", "1,1"}).exit, Exit::Usage);
  const Outcome improper = step({"--num", "1,0,0", "--den", "1,1"});
  EXPECT_EQ(improper.exit, Exit::Usage);
  EXPECT_TRUE(improper.out.empty());
  EXPECT_NE(improper.err.find("higher order"), std::string::npos);
  EXPECT_EQ(step({"--den", "1,1", "--scene", shipped("01_point.json")}).exit, Exit::Usage);
  EXPECT_EQ(step({"--den", "1,1", "--axis", "x"}).exit, Exit::Usage);
  EXPECT_EQ(runCli({"lab"}).exit, Exit::Usage);
}

TEST(LabStep, TheCurveOfAFunctionGoesIntoAFile) {
  const ScratchPath file("step.csv");
  ASSERT_EQ(step({"--den", "1,1", "--seconds", "5", "--csv", file.path()}).exit, Exit::Success);
  const auto rows = rowsOf(file.path(), "t_s,y");
  ASSERT_EQ(rows.size(), 1001U);
  for (const auto& row : rows) EXPECT_NEAR(std::stod(row.at(1)), -std::expm1(-std::stod(row.at(0))), 1e-14);
  EXPECT_EQ(rows.back().at(0), "5");
  EXPECT_EQ(step({"--den", "1,1", "--csv", "/dev/null/nowhere/all.csv"}).exit, Exit::File);
}

TEST(LabStep, TheArmUnderASceneIsMeasuredBesideItsFitAndItsModel) {
  const ScratchPath file("arm.csv");
  const std::vector<std::string> arguments{"--scene",         shipped("01_point.json"),
                                           "--law",           "PD",
                                           "--kd_N_s_per_mm", "0.004",
                                           "--no-limits",     "--csv",
                                           file.path(),       "--json"};
  const Outcome outcome = step(arguments);
  ASSERT_EQ(outcome.exit, Exit::Success) << outcome.err;
  EXPECT_TRUE(outcome.err.empty()) << outcome.err;
  const Value result = lines(outcome.out).at(0);
  EXPECT_EQ(textAt(result, "axis"), "x");
  EXPECT_EQ(textAt(result, "law"), "PD");
  EXPECT_EQ(numberAt(result, "step_mm"), 10.0);
  const Value& model = *result.find("model");
  EXPECT_NEAR(numberAt(model, "omega_n_rad_per_s"), std::sqrt(500.0 / 0.045), 1e-9);
  EXPECT_NEAR(numberAt(model, "zeta"), 4.0 / (2.0 * std::sqrt(500.0 * 0.045)), 1e-9);
  EXPECT_EQ(model.find("poles_rad_per_s")->items.size(), 2U);
  // Friction stops the tip anywhere within 0.26 N / 0.5 N/mm, and damps besides.
  EXPECT_LE(std::abs(numberAt(result, "steady_error_mm")), 0.55);
  EXPECT_GT(numberAt(*result.find("fit"), "zeta"), numberAt(model, "zeta"));
  EXPECT_LT(numberAt(*result.find("fit"), "residual_mm"), 0.1);
  const auto rows = rowsOf(file.path(), "t_s,measured_mm,fit_mm,analytic_mm");
  ASSERT_GT(rows.size(), 400U);
  EXPECT_EQ(rows.front(), (std::vector<std::string>{"0", "0", "0", "0"}));
  EXPECT_NEAR(std::stod(rows.back().at(1)), numberAt(result, "final_mm"), 0.1);
  EXPECT_NEAR(std::stod(rows.back().at(3)), 10.0, 1e-6);
  EXPECT_EQ(step(arguments).out, outcome.out);
}

TEST(LabStep, NamesWhatTheArmCannotShow) {
  const std::string point = shipped("01_point.json");
  EXPECT_NE(step({"--scene", point}).err.find("reduced the force"), std::string::npos);
  const Outcome stuck = step({"--scene", point, "--step_mm", "0.4", "--json"});
  EXPECT_EQ(stuck.exit, Exit::Success);
  EXPECT_TRUE(isNullAt(lines(stuck.out).at(0), "fit"));
  EXPECT_TRUE(isNullAt(lines(stuck.out).at(0), "rise_10_90_s"));
  EXPECT_EQ(numberAt(lines(stuck.out).at(0), "steady_error_mm"), 0.4);
  EXPECT_NE(stuck.err.find("friction"), std::string::npos);
}

TEST(LabStep, AStepThatCannotBeMeasuredIsRefused) {
  const auto refusal = [](std::vector<std::string> more) {
    const Outcome outcome = step(std::move(more));
    EXPECT_EQ(outcome.exit, Exit::BadInput);
    EXPECT_TRUE(outcome.out.empty());
    return outcome.err;
  };
  EXPECT_NE(refusal({"--scene", shipped("09_wall.json")}).find("wall"), std::string::npos);
  EXPECT_NE(refusal({"--scene", shipped("10_two_spheres_nearest.json")}).find("\"left\""), std::string::npos);
  EXPECT_NE(refusal({"--scene", shipped("01_point.json"), "--constraint", "dot"}).find("no constraint"),
            std::string::npos);
  EXPECT_NE(refusal({"--scene", shipped("03_line.json"), "--axis", "x"}).find("another axis"), std::string::npos);
  EXPECT_NE(refusal({"--scene", shipped("01_point.json"), "--step_mm", "400"}).find("reach"), std::string::npos);
  EXPECT_NE(refusal({"--scene", shipped("01_point.json"), "--arm-model", "ideal"}).find("neither mass"),
            std::string::npos);
  EXPECT_EQ(step({"--scene", "nowhere.json"}).exit, Exit::File);
}

}  // namespace
}  // namespace underact::test
