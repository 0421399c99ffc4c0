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
  for (const auto& [key, value] : members) line += (line.empty() ? "" : ", ") + json::quoted(key) + ": " + value;
  if (line.find('\n') == std::string::npos && indent + line.size() + 2 <= kLineWidth) return "{" + line + "}";
  const std::string margin(indent, ' ');
  std::string lines;
  for (const auto& [key, value] : members) {
    lines += (lines.empty() ? "\n  " : ",\n  ") + margin + json::quoted(key) + ": " + value;
  }
  return "{" + lines + "\n" + margin + "}";
}

std::string gainText(const Vec3& gain) {
  return sameBits(gain, Vec3(Vec3::Constant(gain.x()))) ? text(gain.x()) : text(gain);
}

std::string controlText(const Control& control, std::size_t indent) {
  const Control usual;
  Members members{{"law", json::quoted(wordOf(kLawWords, control.law))}};
  for (const GainField& field : kGainFields) {
    const Vec3& gain = control.gains.*field.member;
    if (!sameBits(gain, usual.gains.*field.member)) members.emplace_back(field.key, gainText(gain));
  }
  if (control.anisotropy != usual.anisotropy) {
    members.emplace_back("anisotropy", json::quoted(wordOf(kAnisotropyWords, control.anisotropy)));
  }
  if (control.space != usual.space) members.emplace_back("space", json::quoted(wordOf(kSpaceWords, control.space)));
  return objectText(members, indent);
}

bool isUsual(const Control& control) {
  const Control usual;
  bool same = control.law == usual.law && control.anisotropy == usual.anisotropy && control.space == usual.space;
  for (const GainField& field : kGainFields) {
    same = same && sameBits(control.gains.*field.member, usual.gains.*field.member);
  }
  return same;
}

std::string influenceText(const Influence& influence) {
  const Influence usual;
  Members members{{"t", text(influence.t)}};
  if (influence.stylus_axis != usual.stylus_axis) {
    members.emplace_back("stylus_axis", json::quoted(wordOf(kStylusAxisWords, influence.stylus_axis)));
  }
  if (influence.blend_deg != usual.blend_deg) members.emplace_back("blend_deg", text(influence.blend_deg));
  return objectText(members, 6);
}

std::string constraintText(const Constraint& constraint, std::size_t index) {
  Members members;
  if (constraint.name != madeUpName(constraint, index)) members.emplace_back("name", json::quoted(constraint.name));
  members.emplace_back("type", json::quoted(typeName(constraint.shape)));
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
    members.emplace_back("side", json::quoted(wordOf(kSideWords, constraint.side)));
  }
  if (constraint.influence) members.emplace_back("influence", influenceText(*constraint.influence));
  if (constraint.control) members.emplace_back("control", controlText(*constraint.control, 6));
  return objectText(members, 4);
}

}  // namespace

std::string writeScene(const Description& scene) {
  const Description usual;
  std::string result = "{\n  \"underact_scene\": 1,\n  \"title\": " + json::quoted(scene.title);
  if (scene.about != usual.about) result += ",\n  \"about\": " + json::quoted(scene.about);
  if (scene.arm != usual.arm) result += ",\n  \"arm\": " + json::quoted(scene.arm);
  if (!isUsual(scene.control)) result += ",\n  \"control\": " + controlText(scene.control, 2);
  if (scene.combine != usual.combine)
    result += ",\n  \"combine\": " + json::quoted(wordOf(kCombineWords, scene.combine));
  result += ",\n  \"constraints\": [";
  for (std::size_t index = 0; index < scene.constraints.size(); ++index) {
    result += (index == 0 ? "\n    " : ",\n    ") + constraintText(scene.constraints[index], index);
  }
  return result + "\n  ]\n}\n";
}

}  // namespace underact::scene
