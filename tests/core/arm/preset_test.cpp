#include "core/arm/preset.h"

#include <gtest/gtest.h>

namespace underact::arm {
namespace {

TEST(Preset, IsFoundByItsNameAlone) {
  for (const Preset& preset : presets()) EXPECT_EQ(findPreset(preset.name), &preset);
  EXPECT_EQ(findPreset("omni"), nullptr);
  EXPECT_NE(findPreset(kDefaultArm), nullptr);
}

TEST(Preset, SaysWhereItComesFromAndCanBeUsed) {
  for (const Preset& preset : presets()) {
    EXPECT_NE(preset.provenance, "");
    EXPECT_GT(preset.continuous_force_N, 0.0);
    for (std::size_t joint = 0; joint < 6; ++joint) {
      EXPECT_LT(preset.limits.min_rad[joint], preset.limits.max_rad[joint]);
      EXPECT_GT(preset.counts_per_turn[joint], 0.0);
    }
  }
}

}  // namespace
}  // namespace underact::arm
