#pragma once
#include <algorithm>
#include <charconv>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>
#include <variant>
#include <vector>

#include "core/scene/setting_rows.h"

// Inside the room: the way from a path to the row of a setting and the object that has it.
namespace underact::scene {

/// Of a path, without the slashes.
using Steps = std::span<const std::string>;

/// None: it is no path.
inline std::vector<std::string> stepsOf(std::string_view path) {
  std::vector<std::string> steps;
  while (!path.empty() && path.front() == '/') {
    path.remove_prefix(1);
    const std::size_t length = std::min(path.find('/'), path.size());
    steps.emplace_back(path.substr(0, length));
    path.remove_prefix(length);
  }
  if (!path.empty()) steps.clear();  // a path begins with /
  return steps;
}

/// The path that has these steps.
inline std::string joinedSteps(Steps steps) {
  std::string path;
  for (const std::string& step : steps) path += "/" + step;
  return path;
}

/// None: it is no number, or one with zeros before it.
inline std::optional<std::size_t> numberOfStep(const std::string& step) {
  std::size_t number = 0;
  const auto [end, error] = std::from_chars(step.data(), step.data() + step.size(), number);
  const bool is_padded = step.size() > 1 && step.front() == '0';  // else each place would have any number of paths
  if (error != std::errc() || end != step.data() + step.size() || is_padded) return std::nullopt;
  return number;
}

// Each calls visit(row, object) for the setting at the end of the steps; false: there is none. Optional objects are
// passed as std::optional.

/// Of an object's own rows.
template <class Object, class Visit>
bool atKey(Object& object, const std::string& key, const Visit& visit) {
  for (const auto& row : rowsOf<std::remove_const_t<Object>>()) {
    if (key != row.is.key || !isThere(row, std::as_const(object))) continue;
    visit(row, object);
    return true;
  }
  return false;
}

/// Of an optional object's rows, whether it is there or not.
template <class Part, class Object, class Visit>
bool atOptional(Object& object, const std::string& key, const Visit& visit) {
  for (const SettingOf<Part>& row : rowsOf<Part>()) {
    if (key != row.is.key) continue;
    visit(row, object);
    return true;
  }
  return false;
}

/// Below a control.
template <class Its, class Visit>
bool atControl(Its& control, Steps steps, const Visit& visit) {
  if (steps.size() == 2 && steps[0] == "velocity") return atKey(control.velocity, steps[1], visit);
  return steps.size() == 1 && atKey(control, steps[0], visit);
}

/// Below a constraint, in its shape.
template <class Its, class Visit>
bool inShape(Its& shape, Steps steps, const Visit& visit) {
  if (steps.size() == 1) return atKey(shape, steps[0], visit);
  using Plain = std::remove_const_t<Its>;
  if constexpr (std::is_same_v<Plain, Curve>)
    return steps.size() == 2 && steps[0] == "guide" && atOptional<CurveGuidance>(shape.guide, steps[1], visit);
  if constexpr (std::is_same_v<Plain, VirtualManipulator>) {
    if (steps.size() == 2 && steps[0] == "solver") return atKey(shape.solver, steps[1], visit);
    const std::optional<std::size_t> joint =
        steps.size() == 3 && steps[0] == "joints" ? numberOfStep(steps[1]) : std::nullopt;
    return joint && *joint < shape.joints.size() && atKey(shape.joints[*joint], steps[2], visit);
  }
  return false;
}

/// Below a constraint. One without a control of its own gets one, in a scene that is not const.
template <class Scene, class Visit>
bool inConstraint(Scene& scene, std::size_t index, Steps steps, const Visit& visit) {
  auto& constraint = scene.constraints[index];
  if (steps.size() > 1 && steps[0] == "control") {
    if constexpr (std::is_const_v<Scene>) {
      return atControl(controlOf(scene, index), steps.subspan(1), visit);
    } else {
      if (!constraint.control) constraint.control = scene.control;
      return atControl(*constraint.control, steps.subspan(1), visit);
    }
  }
  if (steps.size() == 2 && steps[0] == "influence")
    return takesInfluence(constraint.shape) && atOptional<Influence>(constraint.influence, steps[1], visit);
  if (steps.size() == 2 && steps[0] == "friction")
    return takesFriction(constraint.shape) && atOptional<Friction>(constraint.friction, steps[1], visit);
  if (steps.size() == 1 && atKey(constraint, steps[0], visit)) return true;
  return std::visit([&](auto& shape) { return inShape(shape, steps, visit); }, constraint.shape);
}

/// In a whole scene.
template <class Scene, class Visit>
bool inScene(Scene& scene, Steps steps, const Visit& visit) {
  if (steps.empty()) return false;
  if (steps.size() == 1) return atKey(scene, steps[0], visit);
  if (steps[0] == "control") return atControl(scene.control, steps.subspan(1), visit);
  if (steps[0] == "simulation") return steps.size() == 2 && atKey(scene.simulation, steps[1], visit);
  const std::optional<std::size_t> index = steps[0] == "constraints" ? numberOfStep(steps[1]) : std::nullopt;
  return index && *index < scene.constraints.size() && inConstraint(scene, *index, steps.subspan(2), visit);
}

}  // namespace underact::scene
