#include "app/gui/input_devices/input_words.h"

#include <gtest/gtest.h>

#include "app/gui/input_devices/map_store.h"

namespace underact::gui::test {

namespace input = device::input;

TEST(HandWords, AFieldIsSetByItsNameAndWhatIsOutOfRangeOrUnknownIsNone) {
  const input::Map map;
  const auto inverted = withField(map, "right.inverted", true);
  ASSERT_TRUE(inverted.has_value());
  EXPECT_TRUE(inverted->motions[0].inverted);
  EXPECT_DOUBLE_EQ(withField(map, "right.dead_zone", 0.2)->motions[0].dead_zone, 0.2);
  EXPECT_FALSE(withField(map, "right.dead_zone", 2.0));
  EXPECT_FALSE(withField(map, "right.exponent", 0.5)) << "coarser than even";
  EXPECT_FALSE(withField(map, "right.top", "fast"));
  EXPECT_FALSE(withField(map, "sideways.top", 0.1));
  EXPECT_FALSE(withField(map, "right.source", QString("elbow")));
  const auto stop = withField(map, "stop", 3);
  ASSERT_TRUE(stop.has_value());
  EXPECT_EQ(stop->presses[static_cast<std::size_t>(input::ButtonRole::Stop)], 3);
  EXPECT_FALSE(withField(map, "stop", -2));
}

TEST(HandWords, APartHasTheDevicesOwnNameOrItsNumberFromOne) {
  input::DeviceState seen;
  seen.axis_names = {Sentence("left stick, right")};
  seen.button_names = {Sentence("A")};
  EXPECT_EQ(axisText(seen, 0), QString("left stick, right"));
  EXPECT_EQ(axisText(seen, 2), QString("axis 3"));
  EXPECT_EQ(axisText(seen, -1), QString("nothing"));
  EXPECT_EQ(sourceTitle(seen, {input::SourceKind::Buttons, 0, 4}), QString("A / button 5"));
}

TEST(HandWords, WhatMovesAWayNowIsAmongWhatCanMoveItEvenIfItIsGone) {
  input::DeviceState seen;
  seen.readings.axes = 2;
  const input::Source gone{input::SourceKind::Axis, 5, -1};
  const std::vector<input::Source> sources = sourcesFor(seen, gone);
  ASSERT_EQ(sources.size(), 4U);  // nothing, two axes, the one that is gone
  EXPECT_EQ(sources.back(), gone);
  EXPECT_EQ(sourcesFor(seen, {input::SourceKind::Axis, 1, -1}).size(), 3U);
}

TEST(MapStore, AMapIsThereAgainUntilItIsForgotten) {
  const MapStore store;
  input::MapFile file;
  file.id = "045e-028e";
  file.map = *withField(input::Map(), "up.dead_zone", 0.25);
  ASSERT_TRUE(store.save(file).empty());
  const auto read = MapStore().load(file.id);
  ASSERT_TRUE(read && read.value());
  EXPECT_DOUBLE_EQ(read.value()->motions[1].dead_zone, 0.25);
  store.forget(file.id);
  const auto again = store.load(file.id);
  EXPECT_TRUE(again && !again.value());
}

}  // namespace underact::gui::test
