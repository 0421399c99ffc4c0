#include <gtest/gtest.h>

#include <QAction>
#include <QLabel>
#include <QPushButton>
#include <cmath>
#include <vector>

#include "app/gui/compare/compare_tool.h"
#include "app/gui/compare/two_views.h"
#include "core/arm/forward.h"
#include "core/arm/preset.h"
#include "tests/stories/story.h"

namespace underact::gui::test {
namespace {

QString sceneOfAnotherArm() {
  return temporaryFile("other_arm.json", R"({"underact_scene": 1, "title": "Touch", "arm": "touch-measured",
      "constraints": [{"name": "p", "type": "point", "position_mm": [0, 0, 0]}]})");
}

/// The sphere, felt, with itself beside it; the hand pushes 2 mm into it.
struct CompareDesk {
  explicit CompareDesk(const QString& scene = "02_sphere")
      : story(scene), tool(*story.window().findChild<CompareTool*>()) {
    story.arm().setSetpoint({.p_WT = Vec3(0.0, 0.0, 0.048)});
    story.perform("session.start");
    story.run(1000);
    EXPECT_TRUE(story.perform("compare.on", true));
    story.run(1000);
  }
  double feltForce_N() { return story.force_N(); }
  double besideForce_N() { return tool.beside().snapshot().report.force.f_T_W().norm(); }
  QString text(const char* name) { return story.find<QLabel>(name)->text(); }
  SceneView& right() { return *story.window().findChild<SceneView*>("view.beside"); }
  /// That file stands beside, in a while.
  bool comes(const char* file) {
    return QTest::qWaitFor(
        [&] {
          story.run(20);
          return QString::fromStdString(tool.beside().scene().file).endsWith(file);
        },
        60'000);
  }
  void feel(double kp_N_per_mm) {
    Document& document = story.window().document();
    scene::Description edited = document.scene();
    edited.control.gains.kp_N_per_mm.setConstant(kp_N_per_mm);
    EXPECT_TRUE(document.edit(edited, "stiffness", document.newGesture()).empty());
  }

  Story story;
  CompareTool& tool;
};

}  // namespace

TEST(CompareStory, TheSameSceneGivesTheSameForceToTheLastBit) {
  CompareDesk desk;
  ASSERT_TRUE(desk.tool.isOn());
  EXPECT_GT(desk.feltForce_N(), 0.2);
  EXPECT_EQ(desk.tool.beside().snapshot().report.force.f_T_W(), desk.story.snapshot().report.force.f_T_W());
  EXPECT_EQ(desk.tool.beside().snapshot().report.p_WT, desk.story.snapshot().report.p_WT);
  EXPECT_TRUE(desk.text("compare.difference").startsWith("The two scenes are the same"));
}

TEST(CompareStory, BothHalvesShowTheWholeArmAlsoWhereTheViewHadBeenMovedAndItIsPutBack) {
  Story story("02_sphere");
  story.run(100);
  story.press(&story.view(), QPoint(30, 30));  // beside the arm: it turns the view
  story.moveTo(&story.view(), QPoint(50, 30));
  story.release(&story.view(), QPoint(50, 30));
  ASSERT_FALSE(story.view().viewpoint().fits);
  const OrbitCamera before = story.view().viewpoint().camera;
  ASSERT_TRUE(story.perform("compare.on", true));
  for (int frame = 0; frame < 5; ++frame) story.run(20), story.settle();
  const arm::Skeleton arm =
      arm::skeleton(arm::findPreset(arm::kDefaultArm)->geometry, story.snapshot().report.sample.q_rad);
  std::vector<Vec3> points{arm.p_WShoulder, arm.p_WElbow, arm.p_WTip};
  for (int axis = 0; axis < 3; ++axis) {
    for (const double side_m : {-0.05, 0.05}) points.push_back(side_m * Vec3::Unit(axis));  // of the sphere
    for (const double side_m : {-0.07, 0.07}) points.push_back(arm.p_WShoulder + side_m * Vec3::Unit(axis));
  }
  for (SceneView* view : {&story.view(), story.window().findChild<SceneView*>("view.beside")}) {
    for (const Vec3& p_W : points) {
      EXPECT_TRUE(QRectF(view->rect()).contains(view->screenOf(p_W)))
          << view->objectName().toStdString() << ' ' << p_W.transpose();
    }
  }
  ASSERT_TRUE(story.perform("compare.on", false));
  story.settle();
  EXPECT_TRUE(story.view().viewpoint().camera == before);
}

TEST(CompareStory, OtherGainsActOnTheSameMotion) {
  CompareDesk desk;
  desk.feel(0.25);
  desk.story.run(2000);
  const servo::Snapshot& beside = desk.tool.beside().snapshot();
  EXPECT_EQ(beside.report.p_WT, desk.story.snapshot().report.p_WT);
  EXPECT_LT(desk.besideForce_N(), 0.8) << "a clamped force is not twice another";
  // Half the stiffness on the same error: half the force, but for what is left of the fading of the old one.
  EXPECT_NEAR(desk.besideForce_N(), 2.0 * desk.feltForce_N(), 1e-3);
  EXPECT_TRUE(desk.text("compare.difference").contains("stiffness: felt 0.25 N/mm, other 0.5 N/mm"))
      << desk.text("compare.difference").toStdString();
  EXPECT_TRUE(desk.text("compare.figures").contains("Other scene:")) << desk.text("compare.figures").toStdString();
}

TEST(CompareStory, SwappedTheOtherOneIsFeltAndUndoGivesItBack) {
  CompareDesk desk;
  Document& document = desk.story.window().document();
  desk.feel(0.25);
  desk.story.run(1000);
  desk.story.click(desk.story.find("compare.button.swap"));
  desk.story.run(2000);
  EXPECT_EQ(document.scene().control.gains.kp_N_per_mm.x(), 0.5);
  EXPECT_EQ(desk.tool.beside().scene().control.gains.kp_N_per_mm.x(), 0.25);
  EXPECT_LT(desk.besideForce_N(), desk.feltForce_N());
  desk.story.perform("edit.undo");
  EXPECT_EQ(document.scene().control.gains.kp_N_per_mm.x(), 0.25);
}

TEST(CompareStory, SameAsFeltTakesTheEditsOver) {
  CompareDesk desk;
  desk.feel(0.25);
  ASSERT_TRUE(desk.story.perform("compare.same"));
  desk.story.run(2000);
  EXPECT_TRUE(desk.text("compare.difference").startsWith("The two scenes are the same"));
  EXPECT_NEAR(desk.besideForce_N(), desk.feltForce_N(), 1e-6);
}

TEST(CompareStory, AnotherSceneStandsBesideAndIsOpenedBySwapping) {
  CompareDesk desk;
  ASSERT_TRUE(desk.story.perform("compare.open", shippedScene("01_point")));
  ASSERT_TRUE(desk.comes("01_point.json"));
  EXPECT_TRUE(desk.text("compare.right").endsWith(QString::fromStdString(desk.tool.beside().scene().title)));
  EXPECT_NE(desk.tool.beside().scene().file, desk.story.window().document().scene().file);
  ASSERT_TRUE(desk.story.perform("compare.swap"));
  desk.story.run(500);
  EXPECT_EQ(desk.story.window().document().path(), shippedScene("01_point"));
  EXPECT_TRUE(QString::fromStdString(desk.tool.beside().scene().file).endsWith("02_sphere.json"));
}

TEST(CompareStory, ASceneWithAMeshIsLoadedMeanwhile) {
  CompareDesk desk;
  ASSERT_TRUE(desk.story.perform("compare.open", shippedScene("26_bumpy_sphere")));
  EXPECT_TRUE(desk.comes("26_bumpy_sphere.json"));
  desk.story.run(200);
  EXPECT_GT(desk.right().trianglesDrawn(), 1000u);
}

TEST(CompareStory, NamesWhatCannotBeCompared) {
  CompareDesk desk;
  EXPECT_FALSE(desk.story.perform("compare.open", temporaryFile("no_scene.json", "{")));
  EXPECT_FALSE(desk.text("compare.told").isEmpty());
  EXPECT_FALSE(desk.story.find("compare.told")->isHidden());
  desk.story.perform("compare.open", sceneOfAnotherArm());
  const auto isGiven = [&] { return desk.story.run(20), desk.text("compare.told").contains("different arms"); };
  EXPECT_TRUE(QTest::qWaitFor(isGiven, 10'000)) << desk.text("compare.told").toStdString();
  desk.story.run(200);
  EXPECT_NEAR(desk.besideForce_N(), desk.feltForce_N(), 1e-6);  // the one before stays
}

TEST(CompareStory, WhenTheFeltSceneIsForAnotherArmNothingStandsBesideIt) {
  CompareDesk desk;
  ASSERT_TRUE(desk.story.perform("scene.open", sceneOfAnotherArm()));
  const auto isGiven = [&] { return desk.story.run(20), desk.text("compare.told").contains("different arms"); };
  EXPECT_TRUE(QTest::qWaitFor(isGiven, kLong_ms)) << desk.text("compare.told").toStdString();
  EXPECT_FALSE(desk.tool.beside().isOn());
}

TEST(CompareStory, WhoMovesOneCameraMovesTheOther) {
  CompareDesk desk;
  desk.story.perform("view.top");
  desk.story.settle(400);
  desk.story.run(40);
  EXPECT_EQ(desk.right().viewpoint().camera, desk.story.view().viewpoint().camera);
  desk.story.press(&desk.right(), QPoint(30, 60));
  desk.story.moveTo(&desk.right(), QPoint(90, 100));
  desk.story.release(&desk.right(), QPoint(90, 100));
  desk.story.run(40);
  EXPECT_EQ(desk.story.view().viewpoint().camera, desk.right().viewpoint().camera);
  desk.story.perform("layer.arm", false);
  desk.story.run(40);
  EXPECT_FALSE(desk.right().layers().arm);
}

TEST(CompareStory, ClosedThereIsOneViewAgain) {
  CompareDesk desk;
  const int half = desk.story.view().width();
  desk.story.click(desk.story.find("compare.button.on"));
  desk.story.settle();
  EXPECT_FALSE(desk.tool.isOn());
  EXPECT_FALSE(desk.right().isVisible());
  EXPECT_FALSE(desk.story.window().actions().find("compare.swap")->isEnabled());
  EXPECT_GT(desk.story.view().width(), 3 * half / 2);
  EXPECT_FALSE(desk.story.perform("compare.swap"));
}

TEST(CompareStory, ItStopsAndStartsWithWhatIsFelt) {
  CompareDesk desk;
  desk.feel(0.1);
  desk.story.perform("session.stop");
  desk.story.run(500);
  EXPECT_EQ(desk.feltForce_N(), 0.0);
  EXPECT_EQ(desk.besideForce_N(), 0.0);
  desk.story.perform("session.start");
  desk.story.run(1000);
  EXPECT_GT(desk.besideForce_N(), desk.feltForce_N());
}

TEST(CompareStory, OneThatTakesTooLongEndsAndSaysSo) {
  CompareDesk desk;
  ComparedScene beside(desk.story.host(), 0.0);  // no time at all
  ASSERT_TRUE(beside.setScene(desk.story.window().document().scene()).empty());
  Problems problems;
  int ticks = 0;
  for (servo::TickRecord record; problems.empty() && ticks < 5000; ++ticks) {
    record.time_ns = 1'000'000LL * ticks;
    problems = beside.add(record);
  }
  EXPECT_EQ(ticks, 1000);
  ASSERT_EQ(problems.size(), 1u);
  EXPECT_FALSE(beside.isOn());
}

TEST(CompareStory, PicturesOfIt) {
  for (const char* theme : {"light", "dark"}) {
    CompareDesk desk;
    desk.story.perform(QString("view.theme.") + theme);
    desk.feel(0.2);
    desk.story.run(2000);
    desk.story.savePicture(QString("compare_") + theme);
    desk.story.perform("view.projector", true);
    desk.story.run(200);
    desk.story.settle(300);
    desk.story.savePicture(QString("compare_projector_") + theme);
  }
}

TEST(CompareStory, BothViewsHaveOneScaleWhateverTheirHeadsSay) {
  CompareDesk desk;
  desk.story.window().resize(900, 700);
  ASSERT_TRUE(desk.story.perform("compare.open", shippedScene("16_one_joint_robot")));
  desk.story.settle(300);
  desk.story.run(2);
  desk.story.settle(100);
  const auto scale_px = [](const SceneView& view) {
    const QPointF offset = view.screenOf({0.02, 0.0, 0.0}) - view.screenOf({0.0, 0.0, 0.0});
    return std::hypot(offset.x(), offset.y());
  };
  auto* right = desk.story.find<SceneView>("view.beside");
  EXPECT_EQ(right->height(), desk.story.view().height());
  EXPECT_NEAR(scale_px(*right), scale_px(desk.story.view()), 0.01 * scale_px(*right));
}

}  // namespace underact::gui::test
