#include <gtest/gtest.h>
#include <unistd.h>

#include <cstdio>
#include <fstream>
#include <string>

#include "core/sim/hand_script.h"

namespace underact::sim {
namespace {

/// Each problem as "LINE:COLUMN KEY".
std::vector<std::string> placesIn(const std::string& text) {
  const Result<HandScript> script = readHand(text, "hand.json");
  std::vector<std::string> places;
  if (script) return places;
  for (const Problem& problem : script.problems()) {
    EXPECT_EQ(problem.place.file, "hand.json");
    EXPECT_FALSE(problem.sentence.empty());
    places.push_back(std::to_string(problem.place.line) + ":" + std::to_string(problem.place.column) + " " +
                     problem.place.key);
  }
  return places;
}

using Places = std::vector<std::string>;

const char* const kContract = R"({"underact_hand": 1,
  "hand": {"mass_kg": 0.2, "damping_N_s_per_m": 5, "stiffness_N_per_m": 250},
  "path": [{"t_s": 0, "p_mm": [10, 20, 30]},
           {"t_s": 1.5, "p_mm": [-10, 0, 40], "R_WT": [[0, -1, 0], [1, 0, 0], [0, 0, 1]]},
           {"t_s": 2, "p_mm": [0, 0, 50]}]})";

TEST(HandFile, IsReadAsTheContractWritesIt) {
  const Result<HandScript> script = readHand(kContract, "hand.json");
  ASSERT_TRUE(script) << describe(script.problems().front());
  EXPECT_EQ(script.value().hand.mass_kg, 0.2);
  EXPECT_EQ(script.value().hand.damping_N_s_per_m, 5.0);
  EXPECT_EQ(script.value().hand.stiffness_N_per_m, 250.0);
  ASSERT_EQ(script.value().path.size(), 3U);
  EXPECT_EQ(script.value().path[1].t_s, 1.5);
  EXPECT_EQ(script.value().path[1].p_WT, 1e-3 * Vec3(-10.0, 0.0, 40.0));
  EXPECT_EQ(script.value().repeat_s, 0.0);
  EXPECT_EQ(script.value().tremor_m, 0.0);
}

TEST(HandFile, APointWithoutATurnKeepsTheOneBefore) {
  const HandScript script = readHand(kContract, "hand.json").value();
  Mat3 quarter;
  quarter << 0, -1, 0, 1, 0, 0, 0, 0, 1;
  for (const HandPoint& point : script.path) {
    EXPECT_TRUE(point.turns);
    EXPECT_LE((point.R_WT - quarter).cwiseAbs().maxCoeff(), 1e-15);  // made whole: a few roundings of 1
  }
  const HandScript none = readHand(R"({"underact_hand": 1, "path": [{"t_s": 0, "p_mm": [0, 0, 0]}]})", "").value();
  EXPECT_FALSE(none.path.front().turns);
  EXPECT_EQ(none.hand.mass_kg, HandModel{}.mass_kg);  // a hand that is not described is the demo's
}

TEST(HandFile, EveryProblemIsNamedAtOnceWithItsPlace) {
  EXPECT_EQ(
      placesIn(R"({"underact_hand": 2,
 "hand": {"mass_kg": 0, "damping_N_s_per_m": -1, "stiffness_N_per_m": "x", "mas_kg": 1},
 "path": [{"t_s": 1, "p_mm": [0, 2e6, 0]},
  {"t_s": 1, "p_mm": [0, 0]},
  {"p_mm": [0, 0, 0], "R_WT": [[1, 0, 0], [0, 1, 0], [0, 0, -1]]},
  {"t_s": 0.5, "p_mm": [0, null, 0]}, 7],
 "speed": 1})"),
      (Places{"1:19 underact_hand", "2:22 hand.mass_kg", "2:46 hand.damping_N_s_per_m", "2:71 hand.stiffness_N_per_m",
              "2:76 hand.mas_kg", "3:30 path[0].p_mm", "4:11 path[1].t_s", "4:22 path[1].p_mm", "5:3 path[2].t_s",
              "5:31 path[2].R_WT", "6:11 path[3].t_s", "6:28 path[3].p_mm[1]", "6:39 path[4]", "7:2 speed"}));
}

TEST(HandFile, NamesMissingKeys) {
  EXPECT_EQ(placesIn("{}"), (Places{"1:1 underact_hand", "1:1 path"}));
  EXPECT_EQ(placesIn(R"({"underact_hand": 1, "path": []})"), (Places{"1:30 path"}));
  EXPECT_EQ(placesIn("[]"), (Places{"1:1 "}));
  EXPECT_EQ(placesIn(R"({"underact_hand": 1, "path": {}, "path": []})"), (Places{"1:30 path", "1:34 path"}));
}

TEST(HandFile, NumbersBeyondADoubleAreRefused) {
  EXPECT_EQ(placesIn(R"({"underact_hand": 1, "hand": {"mass_kg": 1e999},
 "path": [{"t_s": 1e999, "p_mm": [1e999, 0, 0], "R_WT": [[1e999, 0, 0], [0, 1, 0], [0, 0, 1]]}]})"),
            (Places{"1:42 hand.mass_kg", "2:19 path[0].t_s", "2:34 path[0].p_mm", "2:57 path[0].R_WT"}));
}

TEST(HandFile, ARotationWrittenWithSevenDigitsIsMadeWhole) {
  const HandScript script = readHand(R"({"underact_hand": 1, "path": [{"t_s": 0, "p_mm": [0, 0, 0],
    "R_WT": [[0.8660254, -0.5, 0], [0.5, 0.8660254, 0], [0, 0, 1]]}]})",
                                     "")
                                .value();
  const Mat3& R_WT = script.path.front().R_WT;
  EXPECT_LE((R_WT * R_WT.transpose() - Mat3::Identity()).cwiseAbs().maxCoeff(), 1e-15);  // a few roundings of 1
  EXPECT_NEAR(R_WT(0, 0), 0.8660254, 1e-7);
}

TEST(HandFile, RefusesAMissingFileAndAFileThatIsNoJson) {
  EXPECT_EQ(readHand("{", "hand.json").problems().size(), 1U);
  EXPECT_EQ(readHandFile("/no/such/hand.json").problems().front().place.file, "/no/such/hand.json");
  EXPECT_EQ(readHandFile(UNDERACT_TEST_DATA).problems().size(), 1U);  // a folder
  const std::string path = testing::TempDir() + "hand_file_test." + std::to_string(::getpid());
  std::ofstream(path) << kContract;
  EXPECT_TRUE(readHandFile(path));
  std::ofstream(path) << std::string((std::size_t{16} << 20) + 1, ' ');
  const Result<HandScript> large = readHandFile(path);
  ASSERT_FALSE(large);
  EXPECT_NE(large.problems().front().sentence.find("16 MiB"), std::string::npos);
  std::remove(path.c_str());
}

}  // namespace
}  // namespace underact::sim
