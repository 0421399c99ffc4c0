#include <gtest/gtest.h>

#include <QAction>
#include <QPushButton>

#include "app/gui/compare/compare_tool.h"
#include "app/gui/model/player.h"
#include "core/record/recorder.h"
#include "core/scene/edit.h"
#include "core/scene/mirror.h"
#include "core/scene/read.h"
#include "core/scene/write.h"
#include "tests/stories/mesh_desk.h"
#include "tests/stories/picture_difference.h"
#include "tests/stories/visitor_desk.h"

namespace underact::gui::test {
namespace {

constexpr const char* kAction = "scene.left_handed";

/// A ball at the right, to be pushed from outside.
QString rightBallScene() {
  return temporaryFile("right_ball.json", R"({
  "underact_scene": 1,
  "title": "Ball at the right",
  "constraints": [{"type": "sphere", "center_mm": [30, 10, 0], "radius_mm": 25, "side": "outside"}]
})");
}

double middleOfBall_mm(Story& story) {
  return std::get<scene::Sphere>(story.host().scene().constraints.at(0).shape).center_mm.x();
}

bool isOn(Story& story) {
  return story.window().actions().find(kAction)->isChecked();
}

std::string written(const QString& path) {
  return scene::writeScene(scene::readSceneFile(path.toStdString()).value());
}

/// What is felt with the tip at p_WT.
Vec3 felt(Story& story, const Vec3& p_WT) {
  handTo(story, p_WT);
  return story.snapshot().report.force.f_T_W();
}

Vec3 seen(const Vec3& v) {
  return {-v.x(), v.y(), v.z()};
}

// Both arms' encoders round, each to its own side: 0.06 mm of 0.5 N/mm, and what friction holds of it.
constexpr double kSame_N = 0.06;

}  // namespace

TEST(LeftHandStory, TheMousePushesTheBallWhereTheMirrorHasIt) {
  Story story(rightBallScene());
  story.perform("session.start");
  story.perform("view.side");  // the mouse moves the hand across the view
  story.settle(300);
  handTo(story, {-0.030, 0.010, 0.045});
  story.dragHandTo({-0.030, 0.010, 0.015}, true);
  EXPECT_LT(story.force_N(), 0.02) << "the ball is at the right";
  ASSERT_TRUE(story.perform(kAction, true));
  EXPECT_EQ(middleOfBall_mm(story), -30.0);
  EXPECT_EQ(story.window().windowTitle(), "Ball at the right (mirrored)[*] – Underact");
  story.run(1000);
  EXPECT_GT(story.force_N(), 0.1);
  story.release(&story.view(), story.view().rect().center());
  ASSERT_TRUE(story.perform(kAction, false));
  EXPECT_EQ(middleOfBall_mm(story), 30.0);
  EXPECT_EQ(story.window().windowTitle(), "Ball at the right[*] – Underact");
}

TEST(LeftHandStory, ItIsAStepToUndoAndNoEditThatAsksToBeSaved) {
  Story story(rightBallScene());
  story.perform("gains.set", "kp", "x", 0.7);
  ASSERT_TRUE(story.perform("scene.save_as", temporaryFile("right_ball_tuned.json")));
  ASSERT_TRUE(story.perform(kAction, true));
  EXPECT_FALSE(story.window().isWindowModified());
  story.perform("gains.set", "kp", "x", 0.3);
  EXPECT_TRUE(story.window().isWindowModified());
  ASSERT_TRUE(story.perform("edit.undo"));
  EXPECT_FALSE(story.window().isWindowModified());
  EXPECT_EQ(middleOfBall_mm(story), -30.0);
  ASSERT_TRUE(story.perform("edit.undo"));
  EXPECT_EQ(middleOfBall_mm(story), 30.0);
  EXPECT_FALSE(isOn(story)) << "the mark says what holds";
  ASSERT_TRUE(story.perform("edit.undo"));  // of the gain, from before
  EXPECT_DOUBLE_EQ(story.host().scene().control.gains.kp_N_per_mm.x(), 0.5);
  for (int step = 0; step < 3; ++step) ASSERT_TRUE(story.perform("edit.redo"));
  EXPECT_TRUE(isOn(story));
  EXPECT_EQ(middleOfBall_mm(story), -30.0);
  EXPECT_DOUBLE_EQ(story.host().scene().control.gains.kp_N_per_mm.x(), 0.3);
}

TEST(LeftHandStory, AMeshIsFeltInTheMirrorAndTheFileStaysAsItWas) {
  const QString path = temporaryFile("left_bracket.json"), bracket = shippedScene("27_bracket");
  Story story(bracket);
  ASSERT_TRUE(waitForMeshes(story));
  story.perform("session.start");
  // Into the foot from above, out again, and into the wall.
  const std::vector<Vec3> places{
      {0.010, 0.020, 0.010}, {0.010, 0.020, -0.022}, {-0.030, 0.020, 0.010}, {-0.043, -0.010, 0.010}};
  std::vector<Vec3> right;
  for (const Vec3& p_WT : places) right.push_back(felt(story, p_WT));
  ASSERT_TRUE(story.perform(kAction, true));
  EXPECT_LT(meshOf(story).scale_mm_per_unit, 0.0);
  double max_N = 0.0;
  for (std::size_t index = 0; index < places.size(); ++index) {
    const Vec3 left = felt(story, seen(places[index]));
    EXPECT_LT((seen(left) - right[index]).norm(), kSame_N) << index;
    max_N = std::max(max_N, left.norm());
  }
  EXPECT_GT(max_N, 0.1);
  ASSERT_TRUE(story.perform("scene.save_as", path));
  const scene::Description saved = scene::readSceneFile(path.toStdString()).value();
  scene::Description original = scene::readSceneFile(bracket.toStdString()).value();
  std::get<scene::Mesh>(original.constraints[0].shape).file =
      std::get<scene::Mesh>(saved.constraints[0].shape).file;  // as seen from the other folder
  EXPECT_EQ(scene::writeScene(saved), scene::writeScene(original));
  EXPECT_LT(meshOf(story).scale_mm_per_unit, 0.0) << "what is felt stays";
}

TEST(LeftHandStory, EveryShippedSceneIsSavedAsItWasOpened) {
  Story story("");
  ASSERT_TRUE(story.perform(kAction, true));
  for (const char* name : {"04_plane", "07_box_outside", "14_circle_influence", "19_four_bar", "21_puma_560"}) {
    const QString path = temporaryFile("left_saved.json");
    ASSERT_TRUE(story.perform("scene.open", shippedScene(name)));
    EXPECT_TRUE(story.window().document().isMirrored());
    ASSERT_TRUE(story.perform("scene.save_as", path));
    EXPECT_EQ(written(path), written(shippedScene(name))) << name;
  }
}

TEST(LeftHandStory, ItIsRememberedAndTheLastSceneOpensInTheMirror) {
  {
    Story story(rightBallScene());
    story.perform(kAction, true);
  }
  Story story(rightBallScene(), {.first_start = false});
  EXPECT_TRUE(isOn(story));
  EXPECT_EQ(middleOfBall_mm(story), -30.0);
  EXPECT_FALSE(story.window().document().undoStack().canUndo());
}

TEST(LeftHandStory, AMeshThatIsAddedIsMirroredWithTheRest) {
  Story story(rightBallScene());
  story.perform(kAction, true);
  drop(story, temporaryFile("left_box.stl", boxStl({10, 10, 10}, false)));
  ASSERT_TRUE(waitForMeshes(story));
  story.find<QPushButton>("dialog.mesh.add")->click();
  story.settle();
  EXPECT_EQ(meshOf(story, 1).scale_mm_per_unit, -1.0);
  const QString path = temporaryFile("left_added.json");
  ASSERT_TRUE(story.perform("scene.save_as", path));
  const scene::Description saved = scene::readSceneFile(path.toStdString()).value();
  EXPECT_EQ(std::get<scene::Mesh>(saved.constraints.at(1).shape).scale_mm_per_unit, 1.0);
  EXPECT_EQ(std::get<scene::Sphere>(saved.constraints.at(0).shape).center_mm.x(), 30.0);
}

TEST(LeftHandStory, ALessonStaysAsItsTextSaysAndTheSceneComesBackMirrored) {
  Story story(rightBallScene());
  story.perform(kAction, true);
  ASSERT_TRUE(story.perform("lesson.start", "09_constraints"));
  Document& document = story.window().document();
  EXPECT_FALSE(document.isMirrored());
  EXPECT_TRUE(document.isLeftHanded());
  EXPECT_TRUE(scene::isSame(document.scene(), scene::readSceneFile(document.path().toStdString()).value()));
  ASSERT_TRUE(story.perform("lesson.leave"));
  EXPECT_TRUE(document.isMirrored());
  EXPECT_EQ(middleOfBall_mm(story), -30.0);
}

TEST(LeftHandStory, ARecordingIsReplayedWhereTheArmWas) {
  const QString path = temporaryFile("left_push.h5");
  Story story(rightBallScene());
  story.perform(kAction, true);
  story.perform("session.start");
  auto recorder = record::Recorder::start(story.host(), path.toStdString(), {.name = "Left"});
  ASSERT_TRUE(static_cast<bool>(recorder));
  handTo(story, {-0.030, 0.010, 0.022});
  ASSERT_TRUE(recorder.value()->stop().empty());
  for (const bool left : {true, false}) {
    story.perform(kAction, left);
    ASSERT_TRUE(story.perform("replay.open", path));
    ASSERT_TRUE(QTest::qWaitFor([&story] {
      story.window().frame();
      return story.window().player().isOpen();
    }));
    EXPECT_EQ(middleOfBall_mm(story), -30.0) << left;
    EXPECT_FALSE(story.window().document().isMirrored());
    ASSERT_TRUE(story.perform("replay.close"));
    EXPECT_EQ(middleOfBall_mm(story), left ? -30.0 : 30.0);
  }
}

TEST(LeftHandStory, VisitorsGetTheSceneInTheMirror) {
  VisitorDesk desk({"10_two_spheres_nearest"});
  ASSERT_TRUE(desk.window->actions().perform(kAction, QVariant(true)));
  ASSERT_TRUE(desk.begin());
  const scene::Description file = scene::readSceneFile(desk.paths.front().toStdString()).value();
  EXPECT_TRUE(scene::isSame(desk.host->scene(), scene::mirrored(file)));
  EXPECT_FALSE(scene::isSame(desk.host->scene(), file));
  desk.window->findChild<VisitorMode*>()->leave();
  EXPECT_TRUE(desk.window->document().isMirrored());
}

TEST(LeftHandStory, WhatIsComparedIsForTheSameHand) {
  Story story(rightBallScene());
  auto* const tool = story.window().findChild<CompareTool*>();
  const auto beside_mm = [tool] {
    return std::get<scene::Sphere>(tool->beside().scene().constraints.at(0).shape).center_mm.x();
  };
  ASSERT_TRUE(story.perform("compare.on", true));
  ASSERT_TRUE(story.perform(kAction, true));
  EXPECT_EQ(beside_mm(), -30.0);
  const QString other = temporaryFile("other_ball.json", QByteArray(R"({"underact_scene": 1, "title": "Other",
      "constraints": [{"type": "sphere", "center_mm": [20, 0, 0], "radius_mm": 10}]})"));
  ASSERT_TRUE(story.perform("compare.open", other));
  EXPECT_TRUE(QTest::qWaitFor([&] {
    story.window().frame();
    return beside_mm() == -20.0;
  }));
  ASSERT_TRUE(story.perform("compare.swap"));
  EXPECT_EQ(middleOfBall_mm(story), -20.0);
  EXPECT_EQ(beside_mm(), -30.0);
  const QString path = temporaryFile("left_swapped.json");
  ASSERT_TRUE(story.perform("scene.save_as", path));
  EXPECT_EQ(written(path), written(other));
}

/// A box is its own mirror image: it looks the same, inside and outside, with the light from the same side.
TEST(LeftHandStory, AMirroredMeshIsDrawnFromItsOutside) {
  Story story("");
  openMesh(story, temporaryFile("seen_box.stl", boxStl({30, 20, 15}, false)));
  story.perform("layer.arm", false);
  handTo(story, {0.0, 0.0, 0.060});
  story.settle(300);
  const QImage plain = story.view().picture();
  ASSERT_TRUE(story.perform(kAction, true));
  story.run(2000);
  story.settle(300);
  EXPECT_LT(worstBlockDifference(plain, story.view().picture()), kTolerance);
  ASSERT_TRUE(story.perform("section.x", true));
  ASSERT_TRUE(story.perform("layer.section", true));
  story.settle(300);
  const QImage mirrored_cut = story.view().picture();
  ASSERT_TRUE(story.perform(kAction, false));
  story.run(2000);
  story.settle(300);
  EXPECT_LT(worstBlockDifference(mirrored_cut, story.view().picture()), kTolerance);
}

TEST(LeftHandStory, OfAnArmWhoseZIsUpItIsAcrossThePlaneThatTheArmFaces) {
  Story story(temporaryFile("right_ball_ur5e.json", R"({"underact_scene": 1, "title": "Ball of a UR5e", "arm": "ur5e",
      "constraints": [{"type": "sphere", "center_mm": [650, -130, 200], "radius_mm": 60, "side": "outside"}]})"));
  const auto middle_mm = [&story] {
    return std::get<scene::Sphere>(story.host().scene().constraints.at(0).shape).center_mm;
  };
  ASSERT_TRUE(story.perform(kAction, true));
  EXPECT_EQ(middle_mm(), Vec3(650, 130, 200));
  ASSERT_TRUE(story.perform("scene.arm", "omni-thesis"));
  EXPECT_EQ(middle_mm(), Vec3(-650, -130, 200)) << "what the file says, across the plane of the new arm";
  ASSERT_TRUE(story.perform("edit.undo"));
  EXPECT_EQ(middle_mm(), Vec3(650, 130, 200));
  ASSERT_TRUE(story.perform(kAction, false));
  EXPECT_EQ(middle_mm(), Vec3(650, -130, 200));
}

TEST(LeftHandStory, PicturesOfIt) {
  for (const char* theme : {"light", "dark"}) {
    Story story("27_bracket");
    ASSERT_TRUE(waitForMeshes(story));
    story.perform(QString("view.theme.") + theme);
    story.perform(kAction, true);
    story.perform("session.start");
    handTo(story, {-0.020, 0.0, 0.010});
    story.savePicture(QString("left_handed_") + theme);
  }
}

}  // namespace underact::gui::test
