#include <gtest/gtest.h>

#include <cmath>

#include "app/gui/identify/identify_run.h"
#include "app/gui/identify/swing_picture.h"
#include "tests/gui/desk.h"

namespace underact::gui {
FeatureRow identifyFeature();
}

namespace underact::gui::test {
namespace {

IdentifyParts partsOf(Desk& desk) {
  Services& services = desk.services();
  return {desk.host(),      ServoControl(desk.host()), desk.document(), desk.view(),
          *services.player, *services.arm_in_use,      *services.arms};
}

}  // namespace

TEST(IdentifyRun, NamesWhatPreventsItFromBeginning) {
  Desk closed(identifyFeature(), "");
  IdentifyRun nothing(partsOf(closed), nullptr);
  ASSERT_EQ(nothing.begin({}).size(), 1U);
  EXPECT_FALSE(nothing.isRunning());
  Desk desk(identifyFeature());
  desk.host().setHoldToRun(true);
  IdentifyRun held(partsOf(desk), nullptr);
  const Problems problems = held.begin({});
  ASSERT_EQ(problems.size(), 1U);
  EXPECT_NE(problems.front().sentence.find("Hold to run is on"), std::string::npos);
}

TEST(IdentifyRun, AnotherSceneEndsItWithASentenceAndTheServoIsLeftAsItWas) {
  Desk desk(identifyFeature());
  IdentifyRun run(partsOf(desk), nullptr);
  ASSERT_TRUE(run.begin({}).empty());
  EXPECT_EQ(run.state(), IdentifyRun::State::Asks);
  EXPECT_FALSE(run.prompt().isEmpty());
  run.resume();
  EXPECT_TRUE(desk.document().isTryingOut());
  desk.open("05_circle");
  EXPECT_EQ(run.why(), QString("Another scene was opened, so the measurement was ended."));
  EXPECT_FALSE(run.isRunning());
  EXPECT_FALSE(desk.document().isTryingOut());
  EXPECT_FALSE(desk.host().running());
}

TEST(SwingPicture, WaysAreInMillimetresWithAGapAfterEachWindow) {
  std::vector<identify::Window> windows(2);
  windows[0].period_s = windows[1].period_s = 0.001;
  windows[1].first_row = 1000;
  const std::vector<SwingPoint> points = pointsOf(windows, {{0.001, 0.002}, {0.003}});
  ASSERT_EQ(points.size(), 5U);
  EXPECT_DOUBLE_EQ(points[1].travel_mm, 2.0);
  EXPECT_TRUE(std::isnan(points[2].travel_mm));
  EXPECT_DOUBLE_EQ(points[3].travel_mm, 3.0);
  EXPECT_DOUBLE_EQ(points[3].t_s, 1.0);
}

}  // namespace underact::gui::test
