#include "app/gui/ghost/ghost_drawing.h"

#include <gtest/gtest.h>

namespace underact::gui {
namespace {

/// 2 s along x, 100 mm, with a gap after the first second.
ghost::Trajectory trajectory() {
  const auto at = [](double x_m) { return ghost::StylusPose{{x_m, 0.0, 0.0}, Vec3::UnitY()}; };
  ghost::Trajectory made;
  made.rows = {{0.0, at(0.0)}, {1.0, at(0.050)}, {1.1, at(0.080), true}, {2.0, at(0.100)}};
  return made;
}

ghost::State stateAt(double time_s, const Vec3& p_WT) {
  ghost::Options at_once;
  at_once.begins_near = at_once.waits = false;
  ghost::State state;
  state.time_s = time_s;
  return ghost::advanced(trajectory(), at_once, state, 0, p_WT);
}

TEST(GhostDrawing, HasItsStylusTheWayAheadUpToTheGapAndTheDistance) {
  const Vec3 p_WT(0.025, 0.012, 0.0);
  const Drawing drawing = ghostDrawing(trajectory(), stateAt(0.5, p_WT), p_WT);
  ASSERT_EQ(drawing.styluses.size(), 1U);
  EXPECT_NEAR(drawing.styluses.front().p_W.x(), 0.025, 1e-12);
  EXPECT_EQ(drawing.styluses.front().axis_W, Vec3::UnitY());
  ASSERT_EQ(drawing.words.size(), 1U);
  EXPECT_EQ(drawing.words.front().text, "12 mm");
  EXPECT_NEAR(drawing.words.front().p_W.y(), 0.006, 1e-12);
  ASSERT_GT(drawing.links.size(), 10U);
  EXPECT_TRUE(drawing.links.back().dashed);
  EXPECT_EQ(drawing.links.back().from_W, p_WT);
  for (std::size_t index = 0; index + 2 < drawing.links.size(); ++index) {
    EXPECT_LE(drawing.links[index].to_W.x(), 0.050 + 1e-12) << "not across the gap";
    EXPECT_GT(drawing.links[index].strength, drawing.links[index + 1].strength);
  }
}

TEST(GhostDrawing, AtTheEndThereIsNoWayAhead) {
  const Drawing drawing = ghostDrawing(trajectory(), stateAt(2.0, Vec3::Zero()), Vec3::Zero());
  EXPECT_EQ(drawing.links.size(), 1U);
}

}  // namespace
}  // namespace underact::gui
