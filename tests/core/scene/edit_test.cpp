#include "core/scene/edit.h"

#include "core/scene/settings.h"
#include "tests/core/scene/scene_support.h"

namespace underact::scene {
namespace {

Description twoRings() {
  Description scene;
  scene.title = "Two rings";
  scene.constraints.push_back({"one", Circle{Vec3::Zero(), Vec3::UnitZ(), 30}, target::Side::Both, {}, {}});
  scene.constraints.push_back({"two", Circle{Vec3::Zero(), Vec3::UnitX(), 40}, target::Side::Both, {}, {}});
  scene.constraints[1].influence = Influence{};
  return scene;
}

Control stiffer() {
  Control control;
  control.gains.kp_N_per_mm.setConstant(0.75);
  return control;
}

}  // namespace

TEST(Edit, TheSceneSControlIsEditedWhereItIsThatOfOneConstraint) {
  Description scene = twoRings();
  const Description two = withControl(scene, 0, stiffer());
  EXPECT_EQ(two.control, Control{});
  EXPECT_EQ(controlOf(two, 0), stiffer());
  EXPECT_EQ(controlOf(two, 1), Control{});
  scene.constraints.pop_back();
  const Description one = withControl(scene, 0, stiffer());
  EXPECT_EQ(one.control, stiffer());
  EXPECT_FALSE(one.constraints[0].control.has_value());
}

TEST(Edit, AScenePutBackIsTheSameWhoeverHoldsTheControl) {
  const Description scene = twoRings();
  const Description there = withControl(scene, 0, stiffer());
  EXPECT_FALSE(isSame(scene, there));
  EXPECT_TRUE(isSame(scene, withControl(there, 0, Control{})));  // now its own, and equal to the scene's
  Description elsewhere = scene;
  elsewhere.file = "elsewhere.json";
  elsewhere.constraints[0].place.line = 7;
  EXPECT_TRUE(isSame(scene, elsewhere));
  EXPECT_FALSE(isSame(scene, withValue(scene, "/constraints/1/influence/t", 0.25).value()));
  EXPECT_FALSE(isSame(scene, withValue(scene, "/constraints/1/influence/t", {}).value()));
}

TEST(Edit, WhatARunningServoKeepsFollowsFromWhatChanged) {
  const Description scene = twoRings();
  EXPECT_EQ(changeBetween(scene, withControl(scene, 0, stiffer())), Change::Gains);
  Control filtered;
  filtered.velocity = LowPassFilter{5.0};
  EXPECT_FALSE(isSame(scene, withControl(scene, 0, filtered)));
  EXPECT_EQ(changeBetween(scene, withControl(scene, 0, filtered)), Change::Gains);
  Control passive;
  passive.passivity = control::Passivity::Control;
  EXPECT_FALSE(isSame(scene, withControl(scene, 0, passive)));
  EXPECT_EQ(changeBetween(scene, withControl(scene, 0, passive)), Change::Gains);
  EXPECT_EQ(changeBetween(scene, withValue(scene, "/constraints/1/influence/t", 0.25).value()), Change::Targets);
  EXPECT_EQ(changeBetween(scene, withValue(scene, "/constraints/1/influence/t", {}).value()), Change::Scene);
  EXPECT_EQ(changeBetween(scene, withValue(scene, "/constraints/0/influence/t", 0.5).value()), Change::Scene);
  Description larger = scene;
  std::get<Circle>(larger.constraints[0].shape).radius_mm = 31;
  EXPECT_EQ(changeBetween(scene, larger), Change::Targets);
  Description point = scene;
  point.constraints[0].shape = Point{};
  EXPECT_EQ(changeBetween(scene, point), Change::Scene);
  Description fewer = scene;
  fewer.constraints.pop_back();
  EXPECT_EQ(changeBetween(scene, fewer), Change::Scene);
  Control in_joints;
  in_joints.space = tick::Space::Joint;
  EXPECT_EQ(changeBetween(scene, withControl(scene, 0, in_joints)), Change::Scene);
  Description other_arm = scene;
  other_arm.arm = "touch-measured";
  EXPECT_EQ(changeBetween(scene, other_arm), Change::Scene);
  Description nearest = scene;
  nearest.combine = tick::Combine::Nearest;
  EXPECT_EQ(changeBetween(scene, nearest), Change::Scene);
}

TEST(Edit, AConstraintIsAddedUnderANameOfItsOwnAndTakenAwayAgain) {
  const Description scene = twoRings();
  Description more = withAdded(scene, {"two", Point{Vec3(1, 2, 3)}, target::Side::Both, {}, {}});
  more = withAdded(more, {"two", Point{Vec3(4, 5, 6)}, target::Side::Both, {}, {}});
  ASSERT_EQ(more.constraints.size(), 4u);
  EXPECT_EQ(more.constraints[2].name, "two 2");
  EXPECT_EQ(more.constraints[3].name, "two 3");
  EXPECT_TRUE(check(more).empty());
  EXPECT_TRUE(isSame(without(without(more, 3), 2), scene));
  EXPECT_EQ(without(scene, 0).constraints.front().name, "two");
}

TEST(Edit, AnotherShapeTakesThePlaceOfOneAndItsNeighbourStays) {
  const Description edited = withShape(twoRings(), 0, Sphere{Vec3::Zero(), 12});
  EXPECT_EQ(std::get<Sphere>(edited.constraints[0].shape).radius_mm, 12.0);
  EXPECT_EQ(edited.constraints[0].name, "one");
  EXPECT_EQ(std::get<Circle>(edited.constraints[1].shape).radius_mm, 40.0);
}

}  // namespace underact::scene
