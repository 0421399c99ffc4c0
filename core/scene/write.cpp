#include "core/scene/write.h"

#include <cstring>
#include <type_traits>
#include <utility>
#include <vector>

#include "core/json/json.h"
#include "core/scene/setting_rows.h"

namespace underact::scene {
namespace {

constexpr std::size_t kLineWidth = 110;

/// Compares bits, not values: -0 is not 0 here, so that what is left out reads back to the last bit.
template <class Matrix>
bool sameBits(const Matrix& a, const Matrix& b) {
  return std::memcmp(a.data(), b.data(), static_cast<std::size_t>(a.size()) * sizeof(double)) == 0;
}

std::string text(double number) {
  return json::numberText(number);
}

std::string text(const Vec3& numbers) {
  return "[" + text(numbers.x()) + ", " + text(numbers.y()) + ", " + text(numbers.z()) + "]";
}

std::string text(const Mat3& numbers) {
  return "[" + text(Vec3(numbers.row(0).transpose())) + ", " + text(Vec3(numbers.row(1).transpose())) + ", " +
         text(Vec3(numbers.row(2).transpose())) + "]";
}

/// Keys with the text of their values.
using Members = std::vector<std::pair<std::string, std::string>>;

/// On one line if it fits, else a line for each key.
std::string objectText(const Members& members, std::size_t indent) {
  std::string line;
  for (const auto& [key, value] : members) line += (line.empty() ? "" : ", ") + json::quotedText(key) + ": " + value;
  if (line.find('\n') == std::string::npos && indent + line.size() + 2 <= kLineWidth) return "{" + line + "}";
  const std::string margin(indent, ' ');
  std::string lines;
  for (const auto& [key, value] : members) {
    lines += (lines.empty() ? "\n  " : ",\n  ") + margin + json::quotedText(key) + ": " + value;
  }
  return "{" + lines + "\n" + margin + "}";
}

/// The settings of an object as in a file; between() adds other keys before the key of that name.
template <class Object, class Between>
void addSettings(Members& members, const Object& object, std::string_view before, const Between& between) {
  for (const SettingOf<Object>& row : rowsOf<Object>()) {
    if (row.is.key == before) between();
    if (!isThere(row, object)) continue;
    const SettingValue value = row.get(object);
    if (row.is.given == KeyPresence::UnlessDefault && isSameValue(value, row.default_value(object))) continue;
    members.emplace_back(row.is.key, fileTextOf(value));
  }
}

template <class Object>
void addSettings(Members& members, const Object& object) {
  addSettings(members, object, {}, [] {});
}

/// The text of an object with settings only.
template <class Object>
std::string settingsText(const Object& object, std::size_t indent) {
  Members members;
  addSettings(members, object);
  return objectText(members, indent);
}

std::string controlText(const Control& control, std::size_t indent) {
  Members members;
  addSettings(members, control, "passivity", [&] {
    if (!(control.velocity == Velocity{})) members.emplace_back("velocity", settingsText(control.velocity, 6));
  });
  return objectText(members, indent);
}

std::string jointText(const Joint& joint) {
  Members members{{"type", json::quotedText(wordOf(kJointWords, joint.type))}, {"axis", text(joint.axis)}};
  if (joint.type == chain::JointType::Revolute) members.emplace_back("point_mm", text(joint.point_mm));
  addSettings(members, joint);
  return objectText(members, 8);
}

/// One row per line.
std::string poseText(const Eigen::Matrix4d& X) {
  std::string rows;
  for (Eigen::Index row = 0; row < 4; ++row) {
    std::string numbers;
    for (Eigen::Index column = 0; column < 4; ++column) numbers += (column == 0 ? "" : ", ") + text(X(row, column));
    rows += (row == 0 ? "\n        [" : ",\n        [") + numbers + "]";
  }
  return "[" + rows + "\n      ]";
}

/// One joint per line.
void addManipulator(Members& members, const VirtualManipulator& robot) {
  std::string joints;
  for (const Joint& joint : robot.joints) joints += (joints.empty() ? "\n        " : ",\n        ") + jointText(joint);
  members.emplace_back("joints", "[" + joints + "\n      ]");
  members.emplace_back("X_WV_home", poseText(robot.X_WV_home));
  addSettings(members, robot, "force_law", [&] {
    if (!(robot.solver == Solver{})) members.emplace_back("solver", settingsText(robot.solver, 6));
  });
}

template <class FromFile>
void addPlacement(Members& members, const FromFile& shape) {
  const FromFile default_value;
  members.emplace_back("file", json::quotedText(shape.file));
  if (shape.scale_mm_per_unit != default_value.scale_mm_per_unit) {
    members.emplace_back("scale_mm_per_unit", text(shape.scale_mm_per_unit));
  }
  if (!sameBits(shape.X_WM, default_value.X_WM)) members.emplace_back("X_WM", poseText(shape.X_WM));
  addSettings(members, shape);
}

void addMesh(Members& members, const Mesh& mesh) {
  addPlacement(members, mesh);
  if (!mesh.checksum.empty()) members.emplace_back("checksum", json::quotedText(mesh.checksum));
}

void addCurve(Members& members, const Curve& curve) {
  addPlacement(members, curve);
  if (curve.guide) members.emplace_back("guide", settingsText(*curve.guide, 6));
  if (!curve.checksum.empty()) members.emplace_back("checksum", json::quotedText(curve.checksum));
}

std::string constraintText(const Constraint& constraint, std::size_t index) {
  Members members;
  if (constraint.name != defaultName(constraint, index))
    members.emplace_back("name", json::quotedText(constraint.name));
  members.emplace_back("type", json::quotedText(typeName(constraint.shape)));
  if (const auto* robot = std::get_if<VirtualManipulator>(&constraint.shape)) addManipulator(members, *robot);
  if (const auto* mesh = std::get_if<Mesh>(&constraint.shape)) addMesh(members, *mesh);
  if (const auto* curve = std::get_if<Curve>(&constraint.shape)) addCurve(members, *curve);
  std::visit(
      [&](const auto& shape) {
        const std::remove_cvref_t<decltype(shape)> default_value;
        eachField(shape, [&](const auto& field, const auto& number) {
          if constexpr (requires { number.data(); }) {
            if (!field.required && sameBits(number, default_value.*field.member)) return;
          }
          members.emplace_back(field.key, text(number));
        });
      },
      constraint.shape);
  addSettings(members, constraint);
  if (constraint.influence) members.emplace_back("influence", settingsText(*constraint.influence, 6));
  if (constraint.friction) members.emplace_back("friction", settingsText(*constraint.friction, 6));
  if (constraint.control) members.emplace_back("control", controlText(*constraint.control, 6));
  return objectText(members, 4);
}

std::string teachingText(const Teaching& teaching) {
  Members members{{"group", json::quotedText(wordOf(kGroupWords, teaching.group))}};
  if (!teaching.feel.empty()) members.emplace_back("feel", json::quotedText(teaching.feel));
  if (!teaching.try_this.empty()) members.emplace_back("try", json::quotedText(teaching.try_this));
  if (!teaching.equation.empty()) members.emplace_back("equation", json::quotedText(teaching.equation));
  return objectText(members, 2);
}

}  // namespace

std::string writeScene(const Description& scene, const std::optional<Teaching>& teaching) {
  const Description default_value;
  std::string result = "{\n  \"underact_scene\": 1,\n  \"title\": " + json::quotedText(scene.title);
  if (scene.about != default_value.about) result += ",\n  \"about\": " + json::quotedText(scene.about);
  if (teaching) result += ",\n  \"teach\": " + teachingText(*teaching);
  if (scene.arm != default_value.arm) result += ",\n  \"arm\": " + json::quotedText(scene.arm);
  if (!scene.arm_text.empty()) result += ",\n  \"arm_text\": " + json::quotedText(scene.arm_text);
  if (!isDefault(scene.control) || !(scene.control.velocity == Velocity{}))
    result += ",\n  \"control\": " + controlText(scene.control, 2);
  Members settings;
  addSettings(settings, scene);
  for (const auto& [key, value] : settings) result += ",\n  " + json::quotedText(key) + ": " + value;
  if (!isDefault(scene.simulation)) result += ",\n  \"simulation\": " + settingsText(scene.simulation, 2);
  result += ",\n  \"constraints\": [";
  for (std::size_t index = 0; index < scene.constraints.size(); ++index) {
    result += (index == 0 ? "\n    " : ",\n    ") + constraintText(scene.constraints[index], index);
  }
  return result + "\n  ]\n}\n";
}

}  // namespace underact::scene
