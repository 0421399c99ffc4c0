#include "device/input/map_file.h"

#include <gtest/gtest.h>

#include "core/base/units.h"
#include "device/input/default_maps.h"

namespace underact::device::input {
namespace {

std::string problemsOf(const std::string& text) {
  const Result<MapFile> read = readMap(text, "hand.json");
  std::string all;
  if (read) return all;
  for (const Problem& problem : read.problems()) all += describe(problem) + "\n";
  return all;
}

std::string withMotions(const std::string& motions) {
  return R"({"underact_hand_map": 1, "id": "x", "ways": {)" + motions + "}}";
}

}  // namespace

TEST(HandMapFile, WhatIsWrittenReadsBack) {
  DeviceState seen;
  describeController(seen);
  const MapFile file{"A \"pad\"\n", "03000000", seen.default_value};
  const Result<MapFile> read = readMap(mapText(file), "hand.json");
  ASSERT_TRUE(read) << problemsOf(mapText(file));
  EXPECT_EQ(read.value().device, file.device);
  EXPECT_EQ(read.value().id, file.id);
  EXPECT_EQ(read.value().map.presses, file.map.presses);
  for (std::size_t motion = 0; motion < kMotionAxes; ++motion) {
    const AxisMap &back = read.value().map.motions[motion], &one = file.map.motions[motion];
    EXPECT_EQ(back.source, one.source) << motion;
    EXPECT_EQ(back.inverted, one.inverted) << motion;
    EXPECT_EQ(back.dead_zone, one.dead_zone) << motion;
    EXPECT_EQ(back.exponent, one.exponent) << motion;
    EXPECT_NEAR(back.top, one.top, 1e-15) << motion;
  }
  EXPECT_EQ(mapText(read.value()), mapText(file));  // and no further: a map does not creep
}

TEST(HandMapFile, AMapByHand) {
  const Result<MapFile> read =
      readMap(withMotions(R"("up": {"triggers": [5, null], "top_mm_per_s": 50, "dead_zone": 0.3},
      "turn_z": {"buttons": [4, 5], "inverted": true, "top_deg_per_s": 90})"),
              "hand.json");
  ASSERT_TRUE(read);
  const Map& map = read.value().map;
  EXPECT_EQ(map.motions[1].source, (Source{SourceKind::Triggers, 5, -1}));
  EXPECT_NEAR(map.motions[1].top, 0.05, 1e-15);
  EXPECT_EQ(map.motions[1].dead_zone, 0.3);
  EXPECT_EQ(map.motions[5].source, (Source{SourceKind::Buttons, 4, 5}));
  EXPECT_NEAR(map.motions[5].top, 0.5 * kPi, 1e-15);
  EXPECT_TRUE(map.motions[5].inverted);
  EXPECT_EQ(map.motions[0].source.kind, SourceKind::None);
  EXPECT_EQ(map.presses[2], -1);
}

TEST(HandMapFile, EveryProblemIsASentenceWithItsPlace) {
  const std::string all = problemsOf(
      withMotions("\n\"right\": {\"axis\": 99, \"dead_zone\": 2, \"top_mm_per_s\": 1e9, \"exponent\": \"much\"},\n"
                  "\"up\": {\"axis\": 0.5, \"buttons\": [1]},\n\"rihgt\": {}"));
  for (const char* part : {"hand.json:2", "ways.right.axis: This must be a whole number from 0 to 15",
                           "between 0 and 0.9", "between 0 and 500", "ways.right.exponent", "hand.json:3",
                           "a list of two", "Give only one of \"axis\"", "Did you mean \"right\"?"}) {
    EXPECT_NE(all.find(part), std::string::npos) << part << "\n" << all;
  }
  EXPECT_NE(problemsOf(R"({"underact_hand_map": 2, "id": "x", "ways": {}})").find("version 1 only"), std::string::npos);
  EXPECT_NE(problemsOf("{}").find("\"id\" is missing"), std::string::npos);
  EXPECT_NE(problemsOf("[1]").find("an object"), std::string::npos);
  EXPECT_NE(problemsOf("no").size(), 0U);
}

TEST(HandMapFile, ASourceIsATextAndBack) {
  for (const Source& source : {Source{}, Source{SourceKind::Axis, 3, -1}, Source{SourceKind::Buttons, 4, -1},
                               Source{SourceKind::Triggers, 5, 4}}) {
    const std::optional<Source> read = sourceOf(sourceText(source));
    ASSERT_TRUE(read) << sourceText(source);
    EXPECT_EQ(*read, source);
  }
  for (const char* text : {"", "axis", "axis x", "axis -1", "axis 16", "axis 3 4", "buttons 4", "buttons 64 1",
                           "buttons 1 2 3", "triggers 16 0", "stick 1", "axis 99999999999"})
    EXPECT_FALSE(sourceOf(text)) << text;
}

}  // namespace underact::device::input
