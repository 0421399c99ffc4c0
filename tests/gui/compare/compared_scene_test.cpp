#include "app/gui/compare/compared_scene.h"

#include <gtest/gtest.h>

#include <QAction>

#include "app/gui/compare/compare_tool.h"
#include "core/scene/edit.h"
#include "tests/gui/desk.h"

namespace underact::gui {
FeatureRow compareFeature();
}

namespace underact::gui::test {

TEST(ComparedScene, ASceneOfAnotherArmIsRefusedInASentence) {
  Desk desk(compareFeature());
  ComparedScene beside(desk.host());
  scene::Description other = desk.scene();
  other.arm = "another";
  const Problems problems = beside.setScene(other);
  ASSERT_FALSE(problems.empty());
  EXPECT_FALSE(problems.front().sentence.empty());
  EXPECT_FALSE(beside.isOn());
}

TEST(ComparedScene, OneThatTakesTooLongEndsAndSaysSo) {
  Desk desk(compareFeature());
  ComparedScene beside(desk.host(), 1e-9);
  ASSERT_TRUE(beside.setScene(desk.scene()).empty());
  Problems problems;
  desk.host().run(3000);
  desk.host().drain([&](const servo::TickRecord& record) {
    if (problems.empty() && beside.isOn()) problems = beside.add(record);
  });
  EXPECT_FALSE(problems.empty());
  EXPECT_FALSE(beside.isOn());
}

TEST(CompareTool, SwappedTheOtherIsInEffectAsAStepBackAndWhatWasFeltStandsBeside) {
  Desk desk(compareFeature());
  CompareTool& tool = desk.listener<CompareTool>();
  EXPECT_FALSE(desk.actions().find("compare.swap")->isEnabled());
  tool.setOn(true);
  const scene::Description first = desk.scene();
  scene::Control softer = scene::controlOf(first, 0);
  softer.gains.kp_N_per_mm.setConstant(0.05);
  ASSERT_TRUE(
      desk.document().edit(scene::withControl(first, 0, softer), "softer", desk.document().newGesture()).empty());
  const scene::Description second = desk.scene();
  ASSERT_TRUE(desk.perform("compare.swap"));
  EXPECT_TRUE(scene::isSame(desk.scene(), first));
  EXPECT_TRUE(scene::isSame(tool.beside().scene(), second));
  EXPECT_EQ(desk.undoText(), QString("swap of compared scenes"));
  desk.perform("compare.on", false);
  EXPECT_FALSE(tool.beside().isOn());
}

}  // namespace underact::gui::test
