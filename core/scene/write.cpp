#include "core/scene/write.h"

#include <cstring>
#include <type_traits>
#include <utility>
#include <vector>

#include "core/json/json.h"
#include "core/scene/fields.h"

namespace underact::scene {
namespace {

constexpr std::size_t kLineWidth = 110;

/// Bits, not values: -0 is not 0 here, so that what is left out reads back to the last bit.
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

/// On one line where it fits, else a key a line.
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

std::string gainText(const Vec3& gain) {
  return sameBits(gain, Vec3(Vec3::Constant(gain.x()))) ? text(gain.x()) : text(gain);
}

std::string velocityText(const Velocity& velocity) {
  Members members{{"filter", json::quotedText(filterName(velocity))}};
  std::visit(
      [&](const auto& filter) {
        const std::decay_t<decltype(filter)> usual;
        eachSetting(filter, [&](const auto& setting, double number) {
          if (number != usual.*setting.member) members.emplace_back(setting.key, text(number));
        });
      },
      velocity);
  return objectText(members, 6);
}

std::string controlText(const Control& control, std::size_t indent) {
  const Control usual;
  Members members{{"law", json::quotedText(wordOf(kLawWords, control.law))}};
  for (const GainField& field : kGainFields) {
    const Vec3& gain = control.gains.*field.member;
    if (!sameBits(gain, usual.gains.*field.member)) members.emplace_back(field.key, gainText(gain));
  }
  if (control.anisotropy != usual.anisotropy) {
    members.emplace_back("anisotropy", json::quotedText(wordOf(kAnisotropyWords, control.anisotropy)));
  }
  if (!(control.velocity == usual.velocity)) members.emplace_back("velocity", velocityText(control.velocity));
  if (control.passivity != usual.passivity) {
    members.emplace_back("passivity", json::quotedText(wordOf(kPassivityWords, control.passivity)));
  }
  if (control.space != usual.space) members.emplace_back("space", json::quotedText(wordOf(kSpaceWords, control.space)));
  return objectText(members, indent);
}

bool isUsual(const Control& control) {
  const Control usual;
  bool same = control.law == usual.law && control.anisotropy == usual.anisotropy && control.space == usual.space &&
              control.velocity == usual.velocity && control.passivity == usual.passivity;
  for (const GainField& field : kGainFields) {
    same = same && sameBits(control.gains.*field.member, usual.gains.*field.member);
  }
  return same;
}

std::string influenceText(const Influence& influence) {
  const Influence usual;
  Members members{{"t", text(influence.t)}};
  if (influence.stylus_axis != usual.stylus_axis) {
    members.emplace_back("stylus_axis", json::quotedText(wordOf(kStylusAxisWords, influence.stylus_axis)));
  }
  if (influence.blend_deg != usual.blend_deg) members.emplace_back("blend_deg", text(influence.blend_deg));
  return objectText(members, 6);
}

void addNumber(Members& members, const char* key, double number) {
  if (!sameBits(Vec3(Vec3::Constant(number)), Vec3(Vec3::Zero()))) members.emplace_back(key, text(number));
}

std::string jointText(const Joint& joint) {
  Members members{{"type", json::quotedText(wordOf(kJointWords, joint.type))}, {"axis", text(joint.axis)}};
  if (joint.type == chain::JointType::Revolute) members.emplace_back("point_mm", text(joint.point_mm));
  if (joint.min) members.emplace_back("min", text(*joint.min));
  if (joint.max) members.emplace_back("max", text(*joint.max));
  addNumber(members, stiffnessKey(joint.type), joint.stiffness);
  addNumber(members, "rest", joint.rest);
  return objectText(members, 8);
}

std::string solverText(const Solver& solver) {
  const Solver usual;
  Members members;
  if (solver.method != usual.method) {
    members.emplace_back("method", json::quotedText(wordOf(kSolverWords, solver.method)));
  }
  if (solver.max_steps != usual.max_steps) members.emplace_back("max_steps", std::to_string(solver.max_steps));
  if (solver.tolerance != usual.tolerance) members.emplace_back("tolerance", text(solver.tolerance));
  return objectText(members, 6);
}

/// A row on each line.
std::string poseText(const Eigen::Matrix4d& X) {
  std::string rows;
  for (Eigen::Index row = 0; row < 4; ++row) {
    std::string numbers;
    for (Eigen::Index column = 0; column < 4; ++column) numbers += (column == 0 ? "" : ", ") + text(X(row, column));
    rows += (row == 0 ? "\n        [" : ",\n        [") + numbers + "]";
  }
  return "[" + rows + "\n      ]";
}

/// A joint on each line.
void addManipulator(Members& members, const VirtualManipulator& robot) {
  std::string joints;
  for (const Joint& joint : robot.joints) joints += (joints.empty() ? "\n        " : ",\n        ") + jointText(joint);
  members.emplace_back("joints", "[" + joints + "\n      ]");
  members.emplace_back("X_WV_home", poseText(robot.X_WV_home));
  if (robot.orientation != manipulator::Orientation::None) {
    members.emplace_back("orientation", json::quotedText(wordOf(kOrientationWords, robot.orientation)));
  }
  addNumber(members, "ko_N_mm_per_rad", robot.ko_N_mm_per_rad);
  if (!(robot.solver == Solver{})) members.emplace_back("solver", solverText(robot.solver));
  if (robot.force_law != manipulator::ForceLaw::Energy) {
    members.emplace_back("force_law", json::quotedText(wordOf(kForceLawWords, robot.force_law)));
  }
}

template <class FromFile>
void addPlacement(Members& members, const FromFile& shape) {
  const FromFile usual;
  members.emplace_back("file", json::quotedText(shape.file));
  if (shape.scale_mm_per_unit != usual.scale_mm_per_unit) {
    members.emplace_back("scale_mm_per_unit", text(shape.scale_mm_per_unit));
  }
  if (!sameBits(shape.X_WM, usual.X_WM)) members.emplace_back("X_WM", poseText(shape.X_WM));
  if (shape.search != usual.search)
    members.emplace_back("search", json::quotedText(wordOf(kSearchWords, shape.search)));
}

void addMesh(Members& members, const Mesh& mesh) {
  addPlacement(members, mesh);
  if (mesh.smooth_deg != Mesh{}.smooth_deg) members.emplace_back("smooth_deg", text(mesh.smooth_deg));
  if (!mesh.checksum.empty()) members.emplace_back("checksum", json::quotedText(mesh.checksum));
}

void addCurve(Members& members, const Curve& curve) {
  addPlacement(members, curve);
  if (curve.kind != Curve{}.kind) members.emplace_back("kind", json::quotedText(wordOf(kCurveWords, curve.kind)));
  if (curve.closed) members.emplace_back("closed", "true");
  if (!curve.guide) return;
  const CurveGuide usual;
  Members guide{{"speed_mm_per_s", text(curve.guide->speed_mm_per_s)}};
  if (curve.guide->t != usual.t) guide.emplace_back("t", text(curve.guide->t));
  if (curve.guide->lead_mm != usual.lead_mm) guide.emplace_back("lead_mm", text(curve.guide->lead_mm));
  members.emplace_back("guide", objectText(guide, 6));
}

std::string frictionText(const Friction& friction) {
  Members members{{"static", text(friction.static_share)}};
  if (friction.dynamic_share != friction.static_share) members.emplace_back("dynamic", text(friction.dynamic_share));
  return objectText(members, 6);
}

std::string constraintText(const Constraint& constraint, std::size_t index) {
  Members members;
  if (constraint.name != madeUpName(constraint, index)) members.emplace_back("name", json::quotedText(constraint.name));
  members.emplace_back("type", json::quotedText(typeName(constraint.shape)));
  if (const auto* robot = std::get_if<VirtualManipulator>(&constraint.shape)) addManipulator(members, *robot);
  if (const auto* mesh = std::get_if<Mesh>(&constraint.shape)) addMesh(members, *mesh);
  if (const auto* curve = std::get_if<Curve>(&constraint.shape)) addCurve(members, *curve);
  std::visit(
      [&](const auto& shape) {
        const std::remove_cvref_t<decltype(shape)> usual;
        eachField(shape, [&](const auto& field, const auto& number) {
          if constexpr (requires { number.data(); }) {
            if (!field.required && sameBits(number, usual.*field.member)) return;
          }
          members.emplace_back(field.key, text(number));
        });
      },
      constraint.shape);
  if (constraint.side != target::Side::Both) {
    members.emplace_back("side", json::quotedText(wordOf(kSideWords, constraint.side)));
  }
  if (constraint.influence) members.emplace_back("influence", influenceText(*constraint.influence));
  if (constraint.friction) members.emplace_back("friction", frictionText(*constraint.friction));
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

std::string simulationText(const Simulation& simulation) {
  const Simulation usual;
  Members members;
  if (simulation.integrator != usual.integrator)
    members.emplace_back("integrator", json::quotedText(wordOf(kIntegratorWords, simulation.integrator)));
  if (simulation.substep_us != usual.substep_us) members.emplace_back("substep_us", text(simulation.substep_us));
  return objectText(members, 2);
}

}  // namespace

std::string writeScene(const Description& scene, const std::optional<Teaching>& teaching) {
  const Description usual;
  std::string result = "{\n  \"underact_scene\": 1,\n  \"title\": " + json::quotedText(scene.title);
  if (scene.about != usual.about) result += ",\n  \"about\": " + json::quotedText(scene.about);
  if (teaching) result += ",\n  \"teach\": " + teachingText(*teaching);
  if (scene.arm != usual.arm) result += ",\n  \"arm\": " + json::quotedText(scene.arm);
  if (!isUsual(scene.control)) result += ",\n  \"control\": " + controlText(scene.control, 2);
  if (scene.combine != usual.combine)
    result += ",\n  \"combine\": " + json::quotedText(wordOf(kCombineWords, scene.combine));
  if (!(scene.simulation == usual.simulation)) result += ",\n  \"simulation\": " + simulationText(scene.simulation);
  result += ",\n  \"constraints\": [";
  for (std::size_t index = 0; index < scene.constraints.size(); ++index) {
    result += (index == 0 ? "\n    " : ",\n    ") + constraintText(scene.constraints[index], index);
  }
  return result + "\n  ]\n}\n";
}

}  // namespace underact::scene
