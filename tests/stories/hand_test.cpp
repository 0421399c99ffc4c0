#include <gtest/gtest.h>

#include "tests/stories/story.h"

namespace underact::gui::test {

TEST(HandStory, DraggingTheStylusIntoTheSphereRaisesTheForce) {
  Story story("02_sphere");
  story.perform("view.top");  // z of W, towards the hand, lies in the screen
  story.settle(400);
  ASSERT_TRUE(story.perform("session.start"));
  story.run(500);
  story.dragHandTo({0.0, 0.0, 0.050});
  story.run(1500);
  const double at_the_surface_N = story.force_N();
  EXPECT_NEAR(story.arm().setpoint().p_WT.z(), 0.050, 0.001);
  story.dragHandTo({0.0, 0.0, 0.044});
  story.run(1500);
  EXPECT_GT(story.force_N(), at_the_surface_N + 0.3);
  EXPECT_LE(story.force_N(), 0.88 + 1e-9);
  EXPECT_GT(story.snapshot().report.force.f_T_W().z(), 0.0);  // outwards: it pushes back
}

TEST(HandStory, TheArrowKeysMoveTheHand) {
  Story story("02_sphere");
  story.perform("view.front");
  story.settle(400);
  story.perform("view.focus");
  const Vec3 before = story.arm().setpoint().p_WT;
  story.key(Qt::Key_Right);
  story.key(Qt::Key_Up, Qt::ShiftModifier);
  const Vec3 moved = story.arm().setpoint().p_WT - before;
  EXPECT_NEAR(moved.x(), 0.002, 1e-9);
  EXPECT_NEAR(moved.y(), 0.010, 1e-9);
}

}  // namespace underact::gui::test
