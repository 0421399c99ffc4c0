#include "device/input/learn.h"

#include <gtest/gtest.h>

namespace underact::device::input {
namespace {

Readings readings(std::initializer_list<double> values, std::uint64_t pressed = 0) {
  Readings made;
  for (const double value : values) made.axis[static_cast<std::size_t>(made.axes++)] = value;
  made.buttons = 15;
  made.pressed = pressed;
  return made;
}

const Readings kRest = readings({0.02, -0.03, 0.0, 0.0, -1.0, -1.0});

}  // namespace

TEST(HandLearn, TheStickThatMovedFurthestIsMeant) {
  EXPECT_FALSE(learn(kRest, kRest));
  EXPECT_FALSE(learn(kRest, readings({0.4, 0.0, 0.0, 0.0, -1.0, -1.0})));  // not yet
  const auto found = learn(kRest, readings({0.6, 0.0, 0.9, 0.0, -1.0, -1.0}));
  ASSERT_TRUE(found);
  EXPECT_EQ(found->source, (Source{SourceKind::Axis, 2, -1}));
  EXPECT_FALSE(found->inverted);
}

TEST(HandLearn, AStickThatWentDownIsInverted) {
  const auto found = learn(kRest, readings({0.0, -1.0, 0.0, 0.0, -1.0, -1.0}));
  ASSERT_TRUE(found);
  EXPECT_EQ(found->source, (Source{SourceKind::Axis, 1, -1}));
  EXPECT_TRUE(found->inverted);
}

TEST(HandLearn, WhatRestedAtItsEndIsATriggerAndTheOtherOneGoesBack) {
  const auto found = learn(kRest, readings({0.0, 0.0, 0.0, 0.0, 0.3, -1.0}));
  ASSERT_TRUE(found);
  EXPECT_EQ(found->source, (Source{SourceKind::Triggers, 4, 5}));
  const auto alone = learn(readings({0.0, -1.0}), readings({0.0, 1.0}));
  EXPECT_EQ(alone->source, (Source{SourceKind::Triggers, 1, -1}));
}

TEST(HandLearn, AButtonIsMeantWhereItWasNotPressedBefore) {
  const auto found = learn(readings({0.0}, 0b100), readings({0.1}, 0b1100));
  ASSERT_TRUE(found);
  EXPECT_EQ(found->source, (Source{SourceKind::Buttons, 3, -1}));
  EXPECT_EQ(learnButton(readings({}, 1), readings({}, 1)), std::nullopt);
  EXPECT_EQ(learnButton(readings({}, 0), readings({}, 1)), 0);
}

}  // namespace underact::device::input
