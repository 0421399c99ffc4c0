#pragma once
#include <QString>

#include "core/base/result.h"
#include "core/scene/description.h"

namespace underact::gui {

/// The columns of the table of joints.
enum class JointField { Type, AxisX, AxisY, AxisZ, PointX, PointY, PointZ, Min, Max, Stiffness, Rest };
inline constexpr int kJointFields = 11;

/// "type", "axis_x", ..., "rest": what commands call it.
QString keyOf(JointField field);
/// "axis\nx": the head of its column, with its unit.
QString headOf(JointField field);
/// One sentence.
QString tipOf(JointField field);

/// A joint's number as a cell shows it, degrees for the values of a joint that turns; a dash: there is none.
QString shownText(const scene::Joint& joint, JointField field);
/// The same with all its digits, as an editor starts from it; empty: none.
QString exactText(const scene::Joint& joint, JointField field);
/// A joint that slides has an axis, but no point.
bool isThere(const scene::Joint& joint, JointField field);

/// The joint with a field as it was typed. A limit takes no text, or a dash, for none. A joint of another type loses
/// its limits and its spring, which are numbers of another unit. Problem: what was typed is no number, or no type.
Result<scene::Joint> withField(scene::Joint joint, JointField field, const QString& text);

/// A number as people type it: either minus sign, a decimal point.
Result<double> typedNumber(const QString& text);
/// A number with all the digits that tell it apart at a millionth.
QString exactNumber(double value);

/// A turn as three angles, degrees: about x, then y, then z of W, R = Rz Ry Rx. At ry = 90 degrees rz is 0.
Vec3 anglesOf_deg(const Mat3& R);
/// The rotation, its numbers rounded to 12 digits, so that a file says 0 where sin(180 degrees) is meant.
Mat3 rotationOf(const Vec3& angles_deg);

/// A joint of one link: what a new robot starts with, and its tip at home 40 mm from it.
scene::VirtualManipulator newRobot();
/// The joint to put behind the one at index: as that one, but without limits and spring, on the way to the tip, so that
/// it is seen.
scene::Joint nextJoint(const scene::VirtualManipulator& robot, std::size_t index);

}  // namespace underact::gui
