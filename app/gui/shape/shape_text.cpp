#include "app/gui/shape/shape_text.h"

#include <QCoreApplication>
#include <QFileInfo>
#include <QObject>
#include <cctype>
#include <cmath>

#include "app/gui/kit/words.h"
#include "app/gui/model/setting_words.h"
#include "core/scene/fields.h"

namespace underact::gui {
namespace {

using ShapeLines = std::vector<ShapeLine>;

/// The names of the types, marked for translation only.
[[maybe_unused]] constexpr const char* kShapeNames[] = {
    QT_TRANSLATE_NOOP("shape", "Point"), QT_TRANSLATE_NOOP("shape", "Sphere"), QT_TRANSLATE_NOOP("shape", "Line"),
    QT_TRANSLATE_NOOP("shape", "Plane"), QT_TRANSLATE_NOOP("shape", "Circle"), QT_TRANSLATE_NOOP("shape", "Cylinder"),
    QT_TRANSLATE_NOOP("shape", "Box"),   QT_TRANSLATE_NOOP("shape", "Mesh"),   QT_TRANSLATE_NOOP("shape", "Curve")};

ShapeLines linesOf(const scene::Point& point) {
  return {{QObject::tr("Position"), placeText(point.position_mm)}};
}
ShapeLines linesOf(const scene::Sphere& sphere) {
  return {{QObject::tr("Centre"), placeText(sphere.center_mm)}, {QObject::tr("Radius"), millimetres(sphere.radius_mm)}};
}
ShapeLines linesOf(const scene::Line& line) {
  return {{QObject::tr("Through"), placeText(line.point_mm)},
          {QObject::tr("Direction"), directionText(line.direction)}};
}
ShapeLines linesOf(const scene::Plane& plane) {
  return {{QObject::tr("Through"), placeText(plane.point_mm)}, {QObject::tr("Normal"), directionText(plane.normal)}};
}
ShapeLines linesOf(const scene::Circle& circle) {
  return {{QObject::tr("Centre"), placeText(circle.center_mm)},
          {QObject::tr("Radius"), millimetres(circle.radius_mm)},
          {QObject::tr("Normal"), directionText(circle.normal)}};
}
ShapeLines linesOf(const scene::Cylinder& cylinder) {
  return {{QObject::tr("Through"), placeText(cylinder.point_mm)},
          {QObject::tr("Radius"), millimetres(cylinder.radius_mm)},
          {QObject::tr("Axis"), directionText(cylinder.axis)}};
}
ShapeLines linesOf(const scene::Box& box) {
  ShapeLines lines{{QObject::tr("Centre"), placeText(box.center_mm)}, {QObject::tr("Size"), placeText(box.size_mm)}};
  if (!box.R_WB.isIdentity()) lines.push_back({QObject::tr("x axis"), directionText(box.R_WB.col(0))});
  return lines;
}

/// "R R P": the joints in order.
QString jointLetters(const scene::VirtualManipulator& robot) {
  QStringList letters;
  for (const scene::Joint& joint : robot.joints) letters << (joint.type == chain::JointType::Revolute ? "R" : "P");
  return letters.join(' ');
}
/// "q1, q3": the joints with a property.
QString jointsWith(const scene::VirtualManipulator& robot, bool (*has)(const scene::Joint&)) {
  QStringList numbers;
  for (std::size_t index = 0; index < robot.joints.size(); ++index) {
    if (has(robot.joints[index])) numbers << QString("q%1").arg(index + 1);
  }
  return numbers.join(", ");
}
QString orientationText(manipulator::Orientation orientation) {
  switch (orientation) {
    case manipulator::Orientation::None:
      return QObject::tr("position only");
    case manipulator::Orientation::Axis:
      return QObject::tr("position and direction");
    case manipulator::Orientation::Angle:
      return QObject::tr("position and angle");
    case manipulator::Orientation::Full:
      return QObject::tr("position and orientation");
  }
  return {};
}
ShapeLines linesOf(const scene::VirtualManipulator& robot) {
  ShapeLines lines{{QObject::tr("Joints"), jointLetters(robot)},
                   {QObject::tr("Home position"), placeText(robot.X_WV_home.topRightCorner<3, 1>())},
                   {QObject::tr("Follows"), orientationText(robot.orientation)}};
  if (robot.orientation != manipulator::Orientation::None) {
    lines.push_back({QObject::tr("Kθ"), QObject::tr("%1 N mm/rad").arg(numberText(robot.ko_N_mm_per_rad, 1))});
  }
  const QString springs = jointsWith(robot, [](const scene::Joint& joint) { return joint.stiffness > 0.0; });
  if (!springs.isEmpty()) lines.push_back({QObject::tr("Springs"), springs});
  const QString limits = jointsWith(robot, [](const scene::Joint& joint) { return joint.min || joint.max; });
  if (!limits.isEmpty()) lines.push_back({QObject::tr("Limits"), limits});
  if (robot.force_law != manipulator::ForceLaw::Energy) {
    const char* const word = wordOf(scene::kForceLawWords, robot.force_law);
    lines.push_back({QObject::tr("Force law"), settingChoice("/constraints/*/force_law", word)});
  }
  return lines;
}

ShapeLines linesOf(const scene::Mesh& mesh) {
  ShapeLines lines{{QObject::tr("File"), QFileInfo(QString::fromStdString(mesh.file)).fileName()}};
  if (mesh.surface != nullptr) {
    const Vec3 size = (mesh.surface->high_M - mesh.surface->low_M).cast<double>();
    lines.push_back({QObject::tr("Size"), placeText(std::abs(mesh.scale_mm_per_unit) * size)});
    lines.push_back({QObject::tr("Triangles"), QString::number(mesh.surface->triangles.faces.size())});
  }
  lines.push_back({QObject::tr("Placed at"), placeText(mesh.X_WM.topRightCorner<3, 1>())});
  return lines;
}

ShapeLines linesOf(const scene::Curve& curve) {
  ShapeLines lines{{QObject::tr("File"), QFileInfo(QString::fromStdString(curve.file)).fileName()}};
  if (curve.points != nullptr) lines.push_back({QObject::tr("Points"), QString::number(curve.points->size())});
  lines.push_back({QObject::tr("Interpolation"),
                   curve.kind == curve::Kind::Spline ? QObject::tr("smooth") : QObject::tr("straight lines")});
  lines.push_back({QObject::tr("Ends"), curve.closed ? QObject::tr("none, closed") : QObject::tr("two")});
  lines.push_back({QObject::tr("Placed at"), placeText(curve.X_WM.topRightCorner<3, 1>())});
  return lines;
}

QString sideText(target::Side side) {
  switch (side) {
    case target::Side::Both:
      return QObject::tr("held to it");
    case target::Side::Outside:
      return QObject::tr("felt from outside");
    case target::Side::Inside:
      return QObject::tr("felt from inside");
  }
  return {};
}

}  // namespace

QString shapeName(const scene::Shape& shape) {
  if (std::holds_alternative<scene::VirtualManipulator>(shape)) return QObject::tr("Virtual robot");
  QByteArray name = scene::typeName(shape);
  name.front() = static_cast<char>(std::toupper(name.front()));
  return QCoreApplication::translate("shape", name);
}

std::vector<ShapeLine> shapeText(const scene::Constraint& constraint) {
  ShapeLines lines{{shapeName(constraint.shape), sideText(constraint.side)}};
  const ShapeLines geometry = std::visit([](const auto& shape) { return linesOf(shape); }, constraint.shape);
  lines.insert(lines.end(), geometry.begin(), geometry.end());
  if (const auto* mesh = std::get_if<scene::Mesh>(&constraint.shape); mesh && constraint.side == target::Side::Both)
    lines.push_back(
        {QObject::tr("Search"), settingChoice("/constraints/*/search", wordOf(scene::kSearchWords, mesh->search))});
  if (constraint.friction) {
    lines.push_back({QObject::tr("Friction"), QObject::tr("%1 static, %2 dynamic")
                                                  .arg(numberText(constraint.friction->static_share, 2),
                                                       numberText(constraint.friction->dynamic_share, 2))});
  }
  return lines;
}

}  // namespace underact::gui
