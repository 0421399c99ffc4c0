#include "app/gui/arms/joint_fields.h"

#include <QObject>
#include <array>
#include <cmath>

#include "app/gui/kit/number_box.h"
#include "app/gui/kit/words.h"
#include "core/base/units.h"

namespace underact::gui {
namespace {

using chain::JointType;

struct Row {
  const char *key, *head, *tip;
};
constexpr std::array<Row, kJointFields> kRows{
    {{"type", QT_TRANSLATE_NOOP("QObject", "type"),
      QT_TRANSLATE_NOOP("QObject", "Revolute: rotates about its axis. Prismatic: slides along its axis.")},
     {"axis_x", QT_TRANSLATE_NOOP("QObject", "axis\nx"),
      QT_TRANSLATE_NOOP("QObject",
                        "Direction of the axis in the home pose, in W, of any length: S = (axis, point x axis).")},
     {"axis_y", QT_TRANSLATE_NOOP("QObject", "\ny"),
      QT_TRANSLATE_NOOP("QObject", "Direction of the axis in the home pose.")},
     {"axis_z", QT_TRANSLATE_NOOP("QObject", "\nz"),
      QT_TRANSLATE_NOOP("QObject", "Direction of the axis in the home pose.")},
     {"point_x", QT_TRANSLATE_NOOP("QObject", "point\nx [mm]"),
      QT_TRANSLATE_NOOP("QObject", "A point on the axis in the home pose, in W; a prismatic joint needs none.")},
     {"point_y", QT_TRANSLATE_NOOP("QObject", "\ny [mm]"),
      QT_TRANSLATE_NOOP("QObject", "A point on the axis in the home pose.")},
     {"point_z", QT_TRANSLATE_NOOP("QObject", "\nz [mm]"),
      QT_TRANSLATE_NOOP("QObject", "A point on the axis in the home pose.")},
     {"min", QT_TRANSLATE_NOOP("QObject", "min\n[° mm]"),
      QT_TRANSLATE_NOOP("QObject", "Lower limit, degrees or mm; empty: no limit.")},
     {"max", QT_TRANSLATE_NOOP("QObject", "max\n[° mm]"),
      QT_TRANSLATE_NOOP("QObject", "Upper limit, degrees or mm; empty: no limit.")},
     {"stiffness", QT_TRANSLATE_NOOP("QObject", "spring k\n[N mm/rad, N/mm]"),
      QT_TRANSLATE_NOOP("QObject",
                        "The joint's own spring adds k (q - rest)^2 / 2 to the energy; 0: the joint moves freely.")},
     {"rest", QT_TRANSLATE_NOOP("QObject", "rest\n[° mm]"),
      QT_TRANSLATE_NOOP("QObject", "Where the spring exerts no force, degrees or mm.")}}};

const Row& rowOf(JointField field) {
  return kRows[static_cast<std::size_t>(field)];
}

bool isTurning(const scene::Joint& joint) {
  return joint.type == JointType::Revolute;
}

/// Screen units per file unit: degrees for rad, mm for mm.
double screenUnit(const scene::Joint& joint) {
  return isTurning(joint) ? 1.0 / kRadPerDegree : 1.0;
}

/// The field as a number on the screen; none: it has no number.
std::optional<double> numberOf(const scene::Joint& joint, JointField field) {
  const double unit = screenUnit(joint);
  switch (field) {
    case JointField::Type:
      return {};
    case JointField::AxisX:
    case JointField::AxisY:
    case JointField::AxisZ:
      return joint.axis[static_cast<int>(field) - static_cast<int>(JointField::AxisX)];
    case JointField::PointX:
    case JointField::PointY:
    case JointField::PointZ:
      if (!isTurning(joint)) return {};
      return joint.point_mm[static_cast<int>(field) - static_cast<int>(JointField::PointX)];
    case JointField::Min:
      return joint.min ? std::optional(unit * *joint.min) : std::nullopt;
    case JointField::Max:
      return joint.max ? std::optional(unit * *joint.max) : std::nullopt;
    case JointField::Stiffness:
      return joint.stiffness;
    case JointField::Rest:
      return unit * joint.rest;
  }
  return {};
}

int decimalsOf(JointField field) {
  if (field >= JointField::AxisX && field <= JointField::AxisZ) return 3;
  return field == JointField::Stiffness ? 2 : 1;
}

bool isNone(const QString& text) {
  return text.isEmpty() || text == "-" || text == QChar(0x2013) || text == QChar(0x2212);
}

}  // namespace

QString keyOf(JointField field) {
  return QString::fromLatin1(rowOf(field).key);
}
QString headOf(JointField field) {
  return QObject::tr(rowOf(field).head);
}
QString tipOf(JointField field) {
  return QObject::tr(rowOf(field).tip);
}

bool isThere(const scene::Joint& joint, JointField field) {
  return isTurning(joint) || field < JointField::PointX || field > JointField::PointZ;
}

QString shownText(const scene::Joint& joint, JointField field) {
  if (field == JointField::Type) return isTurning(joint) ? QObject::tr("revolute") : QObject::tr("prismatic");
  const std::optional<double> number = numberOf(joint, field);
  return number ? numberText(*number, decimalsOf(field)) : QString(QChar(0x2013));
}

QString exactText(const scene::Joint& joint, JointField field) {
  if (field == JointField::Type) return shownText(joint, field);
  const std::optional<double> number = numberOf(joint, field);
  return number ? exactNumber(*number) : QString();
}

QString exactNumber(double value) {
  return localNumber(value, 'g', 12);
}

Result<double> typedNumber(const QString& text) {
  if (const std::optional<double> number = typed(text)) return *number;
  return Problems{
      {QObject::tr("\"%1\" is not a number. Enter one such as −12.5.").arg(text.trimmed()).toStdString(), {}}};
}

Result<scene::Joint> withField(scene::Joint joint, JointField field, const QString& text) {
  if (field == JointField::Type) {
    const bool turns = text == QObject::tr("revolute") || text == "revolute";
    if (!turns && text != QObject::tr("prismatic") && text != "prismatic") {
      return Problems{{QObject::tr("A joint is revolute or prismatic.").toStdString(), {}}};
    }
    const JointType type = turns ? JointType::Revolute : JointType::Prismatic;
    if (type == joint.type) return joint;
    scene::Joint other;
    other.type = type;
    other.axis = joint.axis;
    other.point_mm = joint.point_mm;
    return other;
  }
  const double unit = 1.0 / screenUnit(joint);
  const bool is_limit = field == JointField::Min || field == JointField::Max;
  if (is_limit && isNone(text.trimmed())) {
    (field == JointField::Min ? joint.min : joint.max).reset();
    return joint;
  }
  const Result<double> typed = typedNumber(text);
  if (!typed) return typed.problems();
  const double number = typed.value();
  if (field == JointField::Min) joint.min = unit * number;
  if (field == JointField::Max) joint.max = unit * number;
  if (field == JointField::Rest) joint.rest = unit * number;
  if (field == JointField::Stiffness) {
    joint.stiffness = number;
    if (number == 0.0) joint.rest = 0.0;  // without a spring there is no rest position
  }
  if (field >= JointField::AxisX && field <= JointField::AxisZ) {
    joint.axis[static_cast<int>(field) - static_cast<int>(JointField::AxisX)] = number;
  }
  if (field >= JointField::PointX && field <= JointField::PointZ) {
    joint.point_mm[static_cast<int>(field) - static_cast<int>(JointField::PointX)] = number;
  }
  return joint;
}

Vec3 anglesOf_deg(const Mat3& R) {
  const double across = std::hypot(R(0, 0), R(1, 0));
  Vec3 angles_rad(0.0, std::atan2(-R(2, 0), across), 0.0);
  if (across > 1e-9) {
    angles_rad.x() = std::atan2(R(2, 1), R(2, 2));
    angles_rad.z() = std::atan2(R(1, 0), R(0, 0));
  } else {
    angles_rad.x() = std::atan2(-R(1, 2), R(1, 1));
  }
  return angles_rad / kRadPerDegree;
}

Mat3 rotationOf(const Vec3& angles_deg) {
  const Vec3 angles_rad = kRadPerDegree * angles_deg;
  Mat3 R = (Eigen::AngleAxisd(angles_rad.z(), Vec3::UnitZ()) * Eigen::AngleAxisd(angles_rad.y(), Vec3::UnitY()) *
            Eigen::AngleAxisd(angles_rad.x(), Vec3::UnitX()))
               .toRotationMatrix();
  for (double& number : R.reshaped()) number = std::round(number * 1e12) / 1e12 + 0.0;  // + 0.0: no -0
  return R;
}

scene::VirtualManipulator newRobot() {
  scene::VirtualManipulator robot;
  robot.joints.push_back({});
  robot.X_WV_home(0, 3) = 40.0;
  return robot;
}

scene::Joint nextJoint(const scene::VirtualManipulator& robot, std::size_t index) {
  scene::Joint joint;
  joint.type = robot.joints[index].type;
  joint.axis = robot.joints[index].axis;
  const Vec3 tip_mm = robot.X_WV_home.topRightCorner<3, 1>();
  const Vec3 end_mm = index + 1 < robot.joints.size() && robot.joints[index + 1].type == JointType::Revolute
                          ? robot.joints[index + 1].point_mm
                          : tip_mm;
  joint.point_mm = 0.5 * (robot.joints[index].point_mm + end_mm);
  return joint;
}

}  // namespace underact::gui
