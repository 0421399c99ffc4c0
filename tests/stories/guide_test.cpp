#include <gtest/gtest.h>

#include <QCheckBox>
#include <QLabel>
#include <QSlider>

#include "app/gui/model/document.h"
#include "tests/stories/mesh_desk.h"

namespace underact::gui::test {
namespace {

const std::optional<scene::CurveGuidance>& guideOf(Story& story) {
  return std::get<scene::Curve>(story.host().scene().constraints[0].shape).guide;
}

/// A straight path along x, 80 mm long, so that everybody knows where along it the target is.
QString pathScene() {
  static const QString kPath = [] {
    temporaryFile("straight.txt", "# a straight path\n-40 0 0\n0 0 0\n40 0 0\n");
    return temporaryFile("straight_scene.json", R"({"underact_scene": 1, "title": "Straight", "constraints": [
      {"type": "curve", "file": "straight.txt", "kind": "polyline", "guide": {"speed_mm_per_s": 40, "lead_mm": 8}}]})");
  }();
  return kPath;
}

void openPath(Story& story) {
  ASSERT_TRUE(story.perform("scene.open", pathScene()));
  ASSERT_TRUE(waitForMeshes(story));
  sim::HandSetpoint setpoint;
  setpoint.p_WT = Vec3(-0.02, 0.001, 0.0);
  story.arm().setSetpoint(setpoint);
  story.run(1500);  // it is there
  story.perform("session.start");
}

/// How far the target is ahead of the tip, mm.
double ahead_mm(Story& story) {
  const tick::TickReport report = story.snapshot().report;
  return 1e3 * (report.held[0].p_WP - report.p_WT).x();
}

}  // namespace

TEST(GuideStory, ItLeadsTheHandAndWaitsForIt) {
  Story story("02_sphere");
  openPath(story);
  const double began_m = story.snapshot().report.p_WT.x();
  EXPECT_NEAR(began_m, -0.02, 1e-3);
  story.run(3000);  // two seconds past the ramp: 40 mm/s would be far past the lead
  EXPECT_NEAR(ahead_mm(story), 8.0, 1e-6);
  EXPECT_GT(story.snapshot().report.p_WT.x(), began_m + 1e-3);  // the hand gave way
  EXPECT_GT(story.force_N(), 0.5);
}

TEST(GuideStory, SwitchedOffNobodyLeadsAndUndoBringsItBack) {
  Story story("02_sphere");
  openPath(story);
  story.run(3000);
  auto* const box = story.find<QCheckBox>("panel.guide.on");
  ASSERT_TRUE(box->isVisibleTo(&story.window()));
  ASSERT_TRUE(box->isChecked());
  ASSERT_TRUE(story.perform("guide.on", false));
  story.run(3000);
  EXPECT_FALSE(guideOf(story));
  EXPECT_NEAR(ahead_mm(story), 0.0, 1e-6);
  ASSERT_TRUE(story.perform("edit.undo"));
  story.run(3000);
  ASSERT_TRUE(guideOf(story));
  EXPECT_EQ(guideOf(story)->speed_mm_per_s, 40.0);
  EXPECT_NEAR(ahead_mm(story), 8.0, 1e-6);
}

TEST(GuideStory, TheRowsSetSpeedWayLeadAndT) {
  Story story("02_sphere");
  openPath(story);
  story.run(1000);
  auto* const t = story.find<QSlider>("panel.guide.t.slider");
  t->setFocus();
  QTest::keyClick(t, Qt::Key_Right);  // a hundredth
  EXPECT_NEAR(guideOf(story)->t, 0.01, 1e-12);
  auto* const backwards = story.find<QCheckBox>("panel.guide.backwards");
  backwards->setChecked(true);
  EXPECT_EQ(guideOf(story)->speed_mm_per_s, -40.0);
  ASSERT_TRUE(story.perform("guide.set", 0.5, -40.0, 4.0));
  story.run(3000);
  EXPECT_NEAR(ahead_mm(story), -2.0, 1e-6);  // half of the lead, the other way
  ASSERT_TRUE(story.perform("gains.reset"));
  EXPECT_EQ(guideOf(story)->speed_mm_per_s, 40.0);
  EXPECT_EQ(guideOf(story)->t, 0.0);
  EXPECT_FALSE(story.perform("guide.set", 2.0, 40.0, 4.0));  // refused, and said
}

TEST(GuideStory, ACurveHasNoGuideSectionElsewhere) {
  Story story("02_sphere");
  EXPECT_FALSE(story.find<QCheckBox>("panel.guide.on")->isVisibleTo(&story.window()));
}

TEST(GuideStory, TheShippedCurvesAreDrawn) {
  for (const char* name : {"28_trefoil_path", "29_signature"}) {
    Story story(name);
    ASSERT_TRUE(waitForMeshes(story));
    story.run(100);
    EXPECT_EQ(story.host().scene().constraints[0].shape.index(), scene::Shape(scene::Curve{}).index());
    story.window().grab().save(QString(UNDERACT_BINARY) + "/pictures/" + name + ".png");
  }
}

}  // namespace underact::gui::test
