#include "app/gui/shape/shape_text.h"

#include <gtest/gtest.h>

#include <QLabel>
#include <QToolButton>

#include "app/gui/shape/shape_panel.h"
#include "core/scene/edit.h"
#include "tests/gui/desk.h"
#include "tests/gui/example.h"

namespace underact::gui {
FeatureRow shapeFeature();
}

namespace underact::gui::test {

TEST(ShapeText, SaysTypeSideLengthsAndFriction) {
  scene::Constraint constraint;
  constraint.shape = scene::Sphere{{1, 2, 3}, 50.0};
  constraint.side = target::Side::Outside;
  constraint.friction = scene::Friction{.static_share = 0.5, .dynamic_share = 0.25};
  QStringList given;
  for (const ShapeLine& line : shapeText(constraint)) given << line.label + ": " + line.value;
  EXPECT_EQ(given.join("; "), QString("Sphere: felt from outside; Centre: 1.0, 2.0, 3.0 mm; Radius: 50.0 mm; "
                                      "Friction: 0.50 static, 0.25 dynamic"));
}

TEST(ShapeText, ARobotIsItsJointsInOrderWithSpringsAndLimits) {
  scene::VirtualManipulator robot;
  robot.joints = {turning(Vec3::UnitZ(), Vec3::Zero()), turning(Vec3::UnitX(), Vec3::Zero())};
  robot.joints[0].stiffness = 1.0;
  robot.joints[1].type = chain::JointType::Prismatic;
  robot.joints[1].max = 10.0;
  scene::Constraint constraint;
  constraint.shape = robot;
  QHash<QString, QString> given;
  for (const ShapeLine& line : shapeText(constraint)) given[line.label] = line.value;
  EXPECT_EQ(given["Joints"], QString("R P"));
  EXPECT_EQ(given["Springs"], QString("q1"));
  EXPECT_EQ(given["Limits"], QString("q2"));
  EXPECT_EQ(shapeName(robot), QString("Virtual robot"));
}

TEST(ShapePanel, TheDistanceIsThatOfTheSnapshotAndFreeWhereNothingIsTouched) {
  Desk desk(shapeFeature());
  servo::Snapshot snapshot = desk.host().snapshot();
  ASSERT_EQ(snapshot.report.held.size(), 1U);
  snapshot.report.held[0].status = target::Status::Unique;
  snapshot.report.held[0].distance_m = 0.0042;
  desk.present(snapshot);
  EXPECT_EQ(desk.label("panel.shape.value.3"), QString("4.2 mm away"));
  snapshot.report.held[0].status = target::Status::Free;
  desk.present(snapshot);
  EXPECT_EQ(desk.label("panel.shape.value.3"), QString("free"));
}

TEST(ShapePanel, FollowsAnEditOfTheShapeAndOffersJointsOnlyOfARobot) {
  Desk desk(shapeFeature());
  EXPECT_TRUE(desk.find("panel.shape.edit_robot")->isHidden());
  ASSERT_TRUE(
      desk.document().edit(scene::withShape(desk.scene(), 0, scene::Sphere{{0, 0, 0}, 31.0}), "radius", 1).empty());
  EXPECT_EQ(desk.label("panel.shape.value.2"), QString("31.0 mm"));
  desk.open("16_one_joint_robot");
  EXPECT_FALSE(desk.find("panel.shape.edit_robot")->isHidden());
}

}  // namespace underact::gui::test
