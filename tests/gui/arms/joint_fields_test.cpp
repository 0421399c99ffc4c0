#include "app/gui/arms/joint_fields.h"

#include <gtest/gtest.h>

#include "core/base/units.h"
#include "core/scene/compile.h"
#include "core/scene/read.h"
#include "core/scene/write.h"
#include "tests/gui/example.h"

namespace underact::gui {

TEST(JointFields, TakeTypedDegreesAndMillimetres) {
  scene::Joint joint = test::turning(Vec3::UnitZ(), {1, 2, 3});
  for (int column = 1; column < kJointFields; ++column) {
    const auto field = static_cast<JointField>(column);
    if (field == JointField::Rest) continue;
    const Result<scene::Joint> typed = withField(joint, field, QString(QChar(0x2212)) + "12.5");
    ASSERT_TRUE(typed) << keyOf(field).toStdString();
    EXPECT_EQ(exactText(typed.value(), field), "-12.5") << keyOf(field).toStdString();
  }
  EXPECT_NEAR(*withField(joint, JointField::Max, "90").value().max, 0.5 * kPi, 1e-15);
  scene::Joint slide = withField(joint, JointField::Type, "prismatic").value();
  EXPECT_EQ(withField(slide, JointField::Max, "90").value().max, 90.0);
  EXPECT_FALSE(isThere(slide, JointField::PointX));
  EXPECT_FALSE(withField(joint, JointField::AxisX, "abc"));
  EXPECT_FALSE(withField(joint, JointField::Type, "screw"));
}

TEST(JointFields, ALimitIsTakenAwayByADashAndAnotherTypeLosesNumbersOfAnotherUnit) {
  scene::Joint joint = test::turning(Vec3::UnitZ(), Vec3::Zero());
  joint.min = -1.0;
  joint.max = 1.0;
  joint.stiffness = 100.0;
  joint.rest = 0.2;
  EXPECT_FALSE(withField(joint, JointField::Min, "").value().min.has_value());
  EXPECT_FALSE(withField(joint, JointField::Max, QString(QChar(0x2013))).value().max.has_value());
  EXPECT_EQ(withField(joint, JointField::Stiffness, "0").value().rest, 0.0);
  const scene::Joint slide = withField(joint, JointField::Type, "prismatic").value();
  EXPECT_FALSE(slide.min || slide.max);
  EXPECT_EQ(slide.stiffness, 0.0);
  EXPECT_EQ(slide.axis, joint.axis);
}

TEST(JointFields, AnglesMakeTheTurnTheyAreReadFromAlsoWhereOneIsLost) {
  for (const Vec3& angles_deg :
       {Vec3(0, 0, 0), Vec3(10, 20, 30), Vec3(-170, 80, 95), Vec3(33, 90, 0), Vec3(-71, -90, 0), Vec3(0, 0, 180)}) {
    const Mat3 R = rotationOf(angles_deg);
    EXPECT_NEAR((rotationOf(anglesOf_deg(R)) - R).norm(), 0.0, 1e-9) << angles_deg.transpose();
    EXPECT_NEAR((R.transpose() * R - Mat3::Identity()).norm(), 0.0, 1e-11);
  }
  EXPECT_EQ(rotationOf({0, 0, 90}), (Mat3() << 0, -1, 0, 1, 0, 0, 0, 0, 1).finished());
}

TEST(JointFields, ANewRobotAndItsNextJointsAreScenesThatCanBeLoadedAndWritten) {
  scene::VirtualManipulator robot = newRobot();
  while (robot.joints.size() < manipulator::kMaxJoints) {
    robot.joints.push_back(nextJoint(robot, robot.joints.size() - 1));
    scene::Description scene = test::sceneOf(robot);
    scene.title = "new";
    EXPECT_TRUE(scene::compile(scene));
    EXPECT_TRUE(scene::readScene(scene::writeScene(scene), "new"));
  }
}

}  // namespace underact::gui
