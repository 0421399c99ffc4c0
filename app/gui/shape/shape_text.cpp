#include "app/gui/shape/shape_text.h"

#include <QCoreApplication>
#include <QFileInfo>
#include <QObject>
#include <cmath>
#include <map>

#include "app/gui/kit/words.h"
#include "app/gui/model/setting_words.h"
#include "core/scene/fields.h"

namespace underact::gui {
namespace {

using ShapeLines = std::vector<ShapeLine>;

QString meaningText(scene::Meaning, double number) {
  return millimetres(number);
}
QString meaningText(scene::Meaning meaning, const Vec3& number) {
  return meaning == scene::Meaning::Direction ? directionText(number) : placeText(number);
}
QString meaningText(scene::Meaning, const Mat3& R) {
  return R.isIdentity() ? QString() : directionText(R.col(0));
}

/// The numbers, places first, then sizes, then directions.
template <scene::PlainShape Shape>
ShapeLines linesOf(const Shape& shape) {
  std::map<scene::Meaning, ShapeLines> by_meaning;
  eachField(shape, [&](const auto& field, const auto& number) {
    const QString text = meaningText(field.meaning, number);
    if (!text.isEmpty()) by_meaning[field.meaning].push_back({QCoreApplication::translate("shape", field.label), text});
  });
  ShapeLines lines;
  for (const auto& [meaning, some] : by_meaning) lines.insert(lines.end(), some.begin(), some.end());
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
                   curve.kind == curve::CurveKind::Spline ? QObject::tr("smooth") : QObject::tr("straight lines")});
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
  return std::visit(
      []<class Shape>(const Shape&) { return QCoreApplication::translate("shape", scene::kRow<Shape>.name); }, shape);
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
