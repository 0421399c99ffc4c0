#include <gtest/gtest.h>

#include <cmath>
#include <fstream>

#include "tests/cli/session.h"
#include "tests/support/full_disk.h"

namespace underact::test {
namespace {

using cli::Exit;

using json::Value;

Outcome run(std::vector<std::string> more, const std::string& scene = "02_sphere.json") {
  std::vector<std::string> arguments{"run", shipped(scene)};
  arguments.insert(arguments.end(), more.begin(), more.end());
  return runCli(arguments);
}

Value summary(const std::vector<std::string>& more, const std::string& scene = "02_sphere.json") {
  const Outcome outcome = run(more, scene);
  EXPECT_EQ(outcome.exit, Exit::Success) << outcome.err;
  const std::vector<Value> all = lines(outcome.out);
  EXPECT_EQ(all.size(), 1U);
  return all.empty() ? Value{} : all[0];
}

/// The columns of a recording that do not tell of the clock on the wall: all but lateness and tick time.
std::string withoutTiming(const std::string& csv) {
  std::istringstream rows(csv);
  std::string kept;
  for (std::string row; std::getline(rows, row);) {
    std::istringstream fields(row);
    int column = 0;
    for (std::string field; std::getline(fields, field, ','); ++column) {
      if (column > 0 && column != 27 && column != 28) kept += field + ",";  // 0: ticks of the loop, which waits first
    }
    kept += "\n";
  }
  return kept;
}

TEST(Run, ARecordingOfAnInfluencedCircleHasItsAngles) {
  const ScratchPath csv("angles.csv");
  summary({"--hand", "probe", "--seconds", "0.5", "--fast", "--record", csv.path()}, "14_circle_influence.json");
  std::istringstream rows(fileContent(csv.path()));
  std::string row;
  std::getline(rows, row);
  int told = 0;
  double last_rad = 0.0;
  while (std::getline(rows, row)) {
    std::istringstream fields(row);
    std::vector<std::string> field;
    for (std::string one; std::getline(fields, one, ',');) field.push_back(one);
    ASSERT_EQ(field.size(), 34U);
    if (field[24].empty() || field[25].empty()) continue;
    ++told;
    const double alpha_rad = std::stod(field[24]), beta_rad = std::stod(field[25]), theta_rad = std::stod(field[26]);
    const double turn_rad = std::remainder(beta_rad - alpha_rad, 2.0 * M_PI);
    // Between the two, or nearer to the tip within the blend; or on its way there, 2 mm a tick on a rim of 50 mm.
    const double step_rad = std::abs(std::remainder(theta_rad - last_rad, 2.0 * M_PI));
    const double from_tip_rad = std::abs(std::remainder(theta_rad - beta_rad, 2.0 * M_PI));
    ASSERT_TRUE(from_tip_rad <= 0.5 * std::abs(turn_rad) + 0.11 || std::abs(step_rad - 0.04) < 1e-9) << row;
    last_rad = theta_rad;
  }
  EXPECT_GT(told, 400);
}

// A hand that is elsewhere within a millisecond, as no hand is.
constexpr const char* kLeap = R"({"underact_hand": 1,
  "hand": {"mass_kg": 0.001, "damping_N_s_per_m": 10, "stiffness_N_per_m": 1e7},
  "path": [{"t_s": 0, "p_mm": [0, 0, 60]}, {"t_s": 0.5, "p_mm": [0, 0, 60]}, {"t_s": 0.501, "p_mm": [60, 0, 60]}]})";

TEST(Run, AFaultIsInTheSummaryAndInItsFileWithTheTicksBeforeIt) {
  const ScratchFile hand(kLeap, "leap.json"), file("", "fault.json");
  const Outcome outcome =
      run({"--hand", hand.path(), "--seconds", "1", "--fast", "--arm-model", "ideal", "--fault-file", file.path()});
  EXPECT_EQ(outcome.exit, Exit::Fault) << outcome.err;
  const std::vector<Value> all = lines(outcome.out);
  ASSERT_EQ(all.size(), 1U);
  ASSERT_EQ(all[0].find("faults")->items.size(), 1U);
  const Value& told = all[0].find("faults")->items[0];
  EXPECT_EQ(textAt(told, "kind"), "too_fast");
  EXPECT_EQ(textAt(told, "sentence"), textAt(told, "what") + " Force is off. " + textAt(told, "what_to_do"));
  EXPECT_EQ(textAt(told, "what").find(" 0.0 m/s"), std::string::npos) << textAt(told, "what");
  const std::vector<Value> kept = {json::parse(fileContent(file.path()), "fault").value()};
  EXPECT_EQ(textAt(kept[0], "kind"), "too_fast");
  EXPECT_EQ(textAt(kept[0], "what"), textAt(told, "what"));
  const std::size_t rows = kept[0].find("rows")->items.size();
  EXPECT_GT(rows, 499U);  // the servo ran for no longer than that
  EXPECT_LT(rows, 505U);
}

TEST(Run, WithoutAFaultThereIsNoFaultFile) {
  const std::string path = ScratchFile("", "none.json").path();
  EXPECT_EQ(run({"--hand", "still", "--seconds", "0.1", "--fast", "--fault-file", path}).exit, Exit::Success);
  EXPECT_FALSE(std::ifstream(path).good());
}

TEST(Run, AFaultFileThatCannotBeWrittenIsTold) {
  const ScratchFile hand(kLeap, "leap.json");
  const Outcome outcome = run({"--hand", hand.path(), "--seconds", "1", "--fast", "--arm-model", "ideal",
                               "--fault-file", "/dev/null/nowhere/all.json"});
  EXPECT_EQ(outcome.exit, Exit::Fault);
  EXPECT_NE(outcome.err.find("/dev/null/nowhere/all.json"), std::string::npos) << outcome.err;
}

TEST(Run, GivesEveryFigureOfTheContract) {
  const Value all = summary({"--hand", "probe", "--seconds", "2", "--fast", "--seed", "7"});
  EXPECT_EQ(numberAt(all, "ticks"), 2000.0);
  EXPECT_EQ(numberAt(all, "rate_hz"), 1000.0);
  EXPECT_EQ(numberAt(all, "seed"), 7.0);
  EXPECT_GT(numberAt(all, "peak_force_N"), 0.0);
  EXPECT_LE(numberAt(all, "peak_force_N"), 0.88 * (1 + 1e-15));
  EXPECT_GT(numberAt(all, "mean_force_N"), 0.0);
  EXPECT_LE(numberAt(all, "mean_force_N"), numberAt(all, "peak_force_N"));
  EXPECT_GT(numberAt(all, "clamped_ticks"), 0.0);
  EXPECT_GT(numberAt(all, "rms_error_mm"), 0.0);
  EXPECT_TRUE(vectorAt(all, "final_p_mm").allFinite());
  EXPECT_EQ(all.find("faults")->kind, json::JsonKind::Array);
  EXPECT_TRUE(all.find("faults")->items.empty());
  for (const char* percentile : {"p50", "p99", "p99.9", "max"}) {
    EXPECT_TRUE(isNullAt(*all.find("lateness_us"), percentile));
    EXPECT_GT(numberAt(*all.find("tick_us"), percentile), 0.0);
  }
  EXPECT_EQ(textAt(all, "scheduling"), "as fast as possible");
}

TEST(Run, TicksAreSecondsTimesRate) {
  EXPECT_EQ(numberAt(summary({"--hand", "still", "--seconds", "0.25", "--rate", "4000", "--fast"}), "ticks"), 1000.0);
  EXPECT_EQ(numberAt(summary({"--hand", "still", "--seconds", "0.0004", "--fast"}), "ticks"), 1.0);
}

TEST(Run, TheSameSeedGivesTheSameNumbersFastAndInRealTime) {
  const ScratchPath fast("fast.csv"), again("again.csv"), real("real.csv");
  const std::vector<std::string> common{"--hand", "tremor", "--seconds", "0.5", "--seed", "11", "--record"};
  const auto with = [&](const ScratchPath& file, bool is_fast) {
    std::vector<std::string> more = common;
    more.push_back(file.path());
    if (is_fast) more.emplace_back("--fast");
    return summary(more, "12_line_pid.json");
  };
  const Value one = with(fast, true), two = with(again, true), three = with(real, false);
  EXPECT_EQ(withoutTiming(fileContent(fast.path())), withoutTiming(fileContent(again.path())));
  EXPECT_EQ(withoutTiming(fileContent(fast.path())), withoutTiming(fileContent(real.path())));
  for (const char* key : {"peak_force_N", "mean_force_N", "clamped_ticks", "rms_error_mm"}) {
    EXPECT_EQ(numberAt(one, key), numberAt(three, key)) << key;
  }
  EXPECT_EQ(vectorAt(one, "final_p_mm"), vectorAt(three, "final_p_mm"));
  EXPECT_GE(numberAt(*three.find("lateness_us"), "max"), numberAt(*three.find("lateness_us"), "p50"));
  EXPECT_NE(textAt(three, "scheduling"), "as fast as possible");
}

TEST(Run, AnotherSeedGivesAnotherTremor) {
  const std::vector<std::string> common{"--hand", "tremor", "--seconds", "1", "--fast", "--seed"};
  std::vector<std::string> one = common, two = common;
  one.emplace_back("1");
  two.emplace_back("2");
  EXPECT_NE(vectorAt(summary(one), "final_p_mm"), vectorAt(summary(two), "final_p_mm"));
}

TEST(Run, TheFirstTickIsEngaged) {
  const ScratchPath csv("ramp.csv");
  summary({"--hand", "still", "--seconds", "0.4", "--fast", "--record", csv.path()});
  std::istringstream rows(fileContent(csv.path()));
  std::string row;
  std::vector<double> levels;
  for (std::getline(rows, row); std::getline(rows, row);) {
    std::istringstream fields(row);
    std::string field;
    for (int column = 0; column <= 21; ++column) std::getline(fields, field, ',');
    levels.push_back(std::stod(field));
  }
  ASSERT_EQ(levels.size(), 400U);
  EXPECT_EQ(levels[0], 0.0);  // no time has passed
  EXPECT_NEAR(levels[1], 0.001 / 0.3, 1e-12);
  EXPECT_EQ(levels[399], 1.0);
}

TEST(Run, TakesAHandFromAFile) {
  const ScratchFile hand(
      R"({"underact_hand": 1, "path": [{"t_s": 0, "p_mm": [0, 0, 60]}, {"t_s": 0.5, "p_mm": [0, 0, 40]}]})",
      "hand.json");
  const Value all = summary({"--hand", hand.path(), "--seconds", "1.5", "--fast"});
  EXPECT_EQ(numberAt(all, "ticks"), 1500.0);
  EXPECT_GT(numberAt(all, "peak_force_N"), 0.1);
}

TEST(Run, TheIdealArmIsAnotherArm) {
  const std::vector<std::string> common{"--hand", "probe", "--seconds", "1", "--fast"};
  std::vector<std::string> ideal = common;
  ideal.insert(ideal.end(), {"--arm-model", "ideal"});
  EXPECT_NE(vectorAt(summary(common), "final_p_mm"), vectorAt(summary(ideal), "final_p_mm"));
}

TEST(Run, WrongUsageIsToldWithStatus2) {
  const std::vector<std::vector<std::string>> wrong{
      {"--hand", "still"},
      {"--seconds", "1"},
      {"--hand", "stil", "--seconds", "1"},
      {"--hand", "still", "--seconds", "0"},
      {"--hand", "still", "--seconds", "-1"},
      {"--hand", "still", "--seconds", "nan"},
      {"--hand", "still", "--seconds", "inf"},
      {"--hand", "still", "--seconds", "1", "--rate", "99"},
      {"--hand", "still", "--seconds", "1", "--rate", "10001"},
      {"--hand", "still", "--seconds", "1", "--max-late", "0"},
      {"--hand", "still", "--seconds", "1", "--arm-model", "wood"},
      {"--hand", "still", "--seconds", "1", "--seed", "-1"},
      {"--hand", "still", "--seconds", "1", "--frobnicate"},
  };
  for (const std::vector<std::string>& arguments : wrong) {
    const Outcome outcome = run(arguments);
    EXPECT_EQ(outcome.exit, Exit::Usage) << testing::PrintToString(arguments);
    EXPECT_EQ(outcome.out, "");
    EXPECT_NE(outcome.err, "");
  }
}

TEST(Run, AMisspeltHandIsAnsweredWithTheNamesThereAre) {
  EXPECT_NE(run({"--hand", "stil", "--seconds", "1"}).err.find("tremor"), std::string::npos);
}

TEST(Run, FilesThatCannotBeReadOrWrittenGiveStatus4) {
  EXPECT_EQ(run({"--hand", "still", "--seconds", "1", "--fast"}, "no_such_scene.json").exit, Exit::File);
  EXPECT_EQ(run({"--hand", "/dev/null/nowhere/hand.json", "--seconds", "1", "--fast"}).exit, Exit::File);
  EXPECT_EQ(run({"--hand", "still", "--seconds", "1", "--fast", "--record", "/dev/null/nowhere/a.csv"}).exit,
            Exit::File);
  EXPECT_EQ(run({"--hand", "still", "--seconds", "1", "--fast", "--record", "/dev/null/nowhere/a.h5"}).exit,
            Exit::File);
}

TEST(Run, AFullDiskIsToldAtOnceAndInTheExitStatusAndInTheLastLineAndTheRunGoesOnToItsEnd) {
  const test::ScratchFolder folder;
  for (const auto& [name, disk_bytes] : {std::pair{"full.csv", 1U << 16U}, {"full.h5", 600'000U}}) {
    const Outcome outcome = [&, bytes = disk_bytes, file = folder.file(name)] {
      const test::FullDisk full(bytes);
      return run({"--hand", "still", "--seconds", "4", "--fast", "--record", file});
    }();
    EXPECT_EQ(outcome.exit, Exit::File);
    EXPECT_EQ(numberAt(lines(outcome.out).at(0), "ticks"), 4000.0);
    EXPECT_TRUE(lines(outcome.out).at(0).find("faults") != nullptr);
    for (const char* const words : {"The recording stopped", "File too large"})
      EXPECT_NE(outcome.err.find(words), std::string::npos) << outcome.err;
    const std::size_t last = outcome.err.rfind('\n', outcome.err.size() - 2) + 1;
    EXPECT_NE(outcome.err.find("The recording is not whole: it has ", last), std::string::npos) << outcome.err;
    EXPECT_NE(outcome.err.find(" of 4000 ticks.", last), std::string::npos) << outcome.err;
    EXPECT_EQ(outcome.err.find("it has 4000 of", last), std::string::npos) << outcome.err;
  }
  EXPECT_EQ(run({"--hand", "still", "--seconds", "0.1", "--fast", "--record", folder.file("A.CSV")}).exit,
            Exit::Success);
  EXPECT_EQ(fileContent(folder.file("A.CSV")).substr(0, 4), "tick");
}

TEST(Run, ABadSceneOrHandGivesStatus1) {
  const ScratchFile scene("{}"), hand("{}", "hand.json");
  EXPECT_EQ(runCli({"run", scene.path(), "--hand", "still", "--seconds", "1"}).exit, Exit::BadInput);
  EXPECT_EQ(run({"--hand", hand.path(), "--seconds", "1", "--fast"}).exit, Exit::BadInput);
}

TEST(Run, InJointSpaceTheSameHandIsHeldWithOtherForcesAndTheWorkIsTold) {
  const std::vector<std::string> common{"--hand", "sweep", "--seconds", "4", "--fast"};
  std::vector<std::string> joint = common, cartesian = common;
  joint.insert(joint.end(), {"--space", "joint"});
  cartesian.insert(cartesian.end(), {"--space", "cartesian"});
  const Value in_joints = summary(joint), in_space = summary(cartesian), as_written = summary(common);
  EXPECT_EQ(numberAt(in_space, "rms_error_mm"), numberAt(as_written, "rms_error_mm"));
  EXPECT_NE(numberAt(in_joints, "rms_error_mm"), numberAt(in_space, "rms_error_mm"));
  EXPECT_EQ(numberAt(in_joints, "branch_changes"), 0.0);
  EXPECT_EQ(numberAt(in_joints, "out_of_reach_ticks"), 0.0);
  EXPECT_LE(numberAt(in_joints, "work_mJ"), numberAt(in_joints, "most_work_mJ"));
  EXPECT_EQ(run({"--hand", "still", "--seconds", "1", "--fast", "--space", "tool"}).exit, Exit::Usage);
}

TEST(Run, ForTheLeftHandTheSceneIsAsInAMirror) {
  const auto held = [](double x_mm, std::vector<std::string> more) {
    const std::string at = "{\"p_mm\": [" + std::to_string(x_mm) + ", 20, 20], \"t_s\": ";
    const ScratchFile hand("{\"underact_hand\": 1, \"path\": [" + at + "0}, " + at + "2}]}", "hand.json");
    more.insert(more.end(), {"--hand", hand.path(), "--seconds", "2", "--fast"});
    return summary(more, "06_cylinder.json");
  };
  const Value right = held(25.0, {}), left = held(-25.0, {"--left-handed"}), not_mirrored = held(-25.0, {});
  EXPECT_GT(numberAt(right, "peak_force_N"), 0.1);
  EXPECT_NEAR(numberAt(left, "peak_force_N"), numberAt(right, "peak_force_N"), 1e-3);
  EXPECT_NEAR(numberAt(left, "rms_error_mm"), numberAt(right, "rms_error_mm"), 1e-2);
  EXPECT_GT(std::abs(numberAt(not_mirrored, "rms_error_mm") - numberAt(right, "rms_error_mm")), 1.0);
}

}  // namespace
}  // namespace underact::test
