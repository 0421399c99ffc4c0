#pragma once
#include <QString>

#include "core/base/result.h"
#include "core/scene/description.h"

namespace underact::gui {

/// The columns of the table of joints.
enum class JointField { Type, AxisX, AxisY, AxisZ, PointX, PointY, PointZ, Min, Max, Stiffness, Rest };
inline constexpr int kJointFields = 11;

/// Its name in commands: "type", "axis_x", ..., "rest".
QString keyOf(JointField field);
/// "axis\nx": the head of its column, with its unit.
QString headOf(JointField field);
/// One sentence.
QString tipOf(JointField field);

/// A number of a joint as shown in a cell, in degrees for a revolute joint; a dash: none.
QString shownText(const scene::Joint& joint, JointField field);
/// The field with all digits, as the initial text of the editor; empty: none.
QString exactText(const scene::Joint& joint, JointField field);
/// A prismatic joint has an axis, but no point.
bool isThere(const scene::Joint& joint, JointField field);

/// The joint with a field as typed. An empty text, or a dash, means no limit. A new type resets the limits and the
/// spring, whose units differ. Problem: not a number, or not a type.
Result<scene::Joint> withField(scene::Joint joint, JointField field, const QString& text);

/// A typed number: either minus sign, a decimal point.
Result<double> typedNumber(const QString& text);
/// A number with 12 significant digits.
QString exactNumber(double value);

/// A rotation as three angles, degrees: about x, then y, then z of W, R = Rz Ry Rx. At ry = 90 degrees rz is 0.
Vec3 anglesOf_deg(const Mat3& R);
/// The rotation matrix, rounded to 12 digits, so that a file has 0 for sin(180 degrees).
Mat3 rotationOf(const Vec3& angles_deg);

/// A new robot: one joint, with the home pose of the end effector 40 mm from it.
scene::VirtualManipulator newRobot();
/// The joint to insert after the one at index: like that one, but without limits and spring, halfway to the next joint
/// or the end effector, so that it is visible.
scene::Joint nextJoint(const scene::VirtualManipulator& robot, std::size_t index);

}  // namespace underact::gui
