#include "core/stability/maps.h"

#include <gtest/gtest.h>

#include <set>

namespace underact::stability {
namespace {

TEST(WallMaps, AskEachThingThatMovesTheLimitAndNameEachVariantOnce) {
  std::set<std::string> keys;
  for (const WallMap& map : wallMaps()) {
    keys.insert(map.key);
    std::set<std::string> names;
    for (const Variant& variant : map.variants) names.insert(variant.name);
    EXPECT_EQ(names.size(), map.variants.size()) << map.key;
    EXPECT_GE(names.size(), 3U) << map.key;
  }
  EXPECT_EQ(keys, (std::set<std::string>{"rate", "delay", "hand", "filter", "quantization", "friction"}));
}

TEST(WallMaps, ACellSaysWhereTheLimitIsByEveryWayThereIs) {
  SampledWall wall = wallMaps()[0].variants[2].wall;  // 1000 Hz
  ASSERT_EQ(wall.period_ns, 1'000'000);
  const Limits limits = limitsOf(wall);
  EXPECT_NEAR(limits.simulated_N_per_m, 200.0, 2.0);
  EXPECT_NEAR(limits.exact_N_per_m.value(), 200.0, 0.1);
  EXPECT_NEAR(limits.passive_N_per_m, 200.0, 1e-3);
  EXPECT_NEAR(limits.colgate_schenkel_N_per_m, 200.0, 1e-9);
  EXPECT_NEAR(limits.gil_hulin_N_per_m, 200.0, 1e-9);
}

TEST(WallMaps, LabelsFollowTheLimit) {
  SampledWall wall;
  wall.kd_N_s_per_m = 0.5;  // limit 1187 N/m
  EXPECT_EQ(labelOf(wall, limitsOf(wall), 1000.0).trial.behaviour, Behaviour::Rest);
  EXPECT_EQ(labelOf(wall, limitsOf(wall), 1400.0).trial.behaviour, Behaviour::Grows);
  EXPECT_FALSE(
      labelOf(wall, limitsOf(wall), 1000.0).is_passive);  // calm by itself; a hand there is with which it is not
  wall.kd_N_s_per_m = 0.0;
  EXPECT_TRUE(labelOf(wall, limitsOf(wall), 100.0).is_passive);
}

}  // namespace
}  // namespace underact::stability
