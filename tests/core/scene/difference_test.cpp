#include "core/scene/difference.h"

#include <algorithm>
#include <string>

#include "core/scene/edit.h"
#include "core/scene/read.h"
#include "core/scene/settings.h"
#include "tests/core/scene/scene_support.h"

namespace underact::scene {
namespace {

Description ring() {
  Description scene;
  scene.title = "Ring";
  scene.constraints.push_back({"ring", Circle{Vec3::Zero(), Vec3::UnitZ(), 30}, target::Side::Both, {}, {}});
  return scene;
}

}  // namespace

TEST(Difference, OneSceneHasNoneFromItself) {
  EXPECT_TRUE(differencesBetween(ring(), ring()).empty());
}

TEST(Difference, WordsAboutASceneAreNone) {
  Description other = ring();
  other.title = "Another";
  other.about = "Another text.";
  other.file = "elsewhere.json";
  EXPECT_TRUE(differencesBetween(ring(), other).empty());
}

TEST(Difference, AGainIsNamedAsInTheFile) {
  Description stiff = ring();
  stiff.control.gains.kp_N_per_mm.setConstant(0.75);
  const std::vector<Difference> expected{{"control.kp_N_per_mm", "0.5", "0.75"}};
  EXPECT_EQ(differencesBetween(ring(), stiff), expected);
}

TEST(Difference, WhatAFileLeavesOutOfItsControlIsShownAsItIs) {
  Description other = ring();
  other.control.law = LawType::PID;
  other.control.gains.kp_N_per_mm.setConstant(0.3);
  other.control.gains.kd_N_s_per_mm.setConstant(0.001);
  other.control.gains.ki_N_per_mm_s.setConstant(0.1);
  other.control.anisotropy = Anisotropy::Euclidean;
  other.control.space = tick::Space::Joint;
  other.control.passivity = control::Passivity::Off;
  const std::vector<Difference> differences = differencesBetween(ring(), other);
  ASSERT_EQ(differences.size(), 7u);
  std::string text =
      R"({"underact_scene": 1, "title": "Ring", "constraints": [{"type": "point", "position_mm": [0, 0, 0]}],
                         "control": {)";
  for (const Difference& one : differences) {
    const std::string key = one.key.substr(std::string("control.").size());
    const bool is_number = one.one.find_first_not_of("0123456789.") == std::string::npos;
    text += (text.back() == '{' ? "\"" : ", \"") + key + "\": " + (is_number ? one.one : "\"" + one.one + "\"");
  }
  // The law P takes no rate and no integral: those are looked at with the law that has them.
  text.replace(text.find("\"law\": \"P\""), 10, "\"law\": \"PID\"");
  const Result<Description> read = readScene(text + "}}", "usual.json");
  ASSERT_TRUE(read) << text;
  Control default_value;
  default_value.law = LawType::PID;
  EXPECT_EQ(read.value().control, default_value);
}

TEST(Difference, OfAConstraintItsNameGoesFirst) {
  Description wide = ring();
  std::get<Circle>(wide.constraints[0].shape).radius_mm = 40;
  const std::vector<Difference> expected{{"ring.radius_mm", "30", "40"}};
  EXPECT_EQ(differencesBetween(ring(), wide), expected);
}

TEST(Difference, GoneTheOtherWayTheValuesAreSwapped) {
  Description other = withValue(ring(), "/constraints/0/influence/t", 0.5).value();
  other.control.law = LawType::PD;
  const std::vector<Difference> there = differencesBetween(ring(), other), back = differencesBetween(other, ring());
  ASSERT_GE(there.size(), 2u);
  ASSERT_EQ(there.size(), back.size());
  for (const Difference& one : there) {
    EXPECT_NE(std::find(back.begin(), back.end(), Difference{one.key, one.other, one.one}), back.end()) << one.key;
  }
}

TEST(Difference, AConstraintMoreIsOne) {
  EXPECT_EQ(differencesBetween(ring(), withAdded(ring(), ring().constraints[0])).size(), 1u);
}

}  // namespace underact::scene
