#include "core/scene/edit.h"

#include <algorithm>
#include <utility>

#include "core/scene/scene_arm.h"

namespace underact::scene {
namespace {

/// Whether everything that determines the targets is equal. Unequal gains do, too; but they are tuned while running,
/// and change smoothly. The simulation is of the arm, not of a target.
bool haveSameTargets(const Description& a, const Description& b) {
  const auto have_same_target = [](const Constraint& one, const Constraint& other) {
    return one.name == other.name && one.shape == other.shape && one.side == other.side &&
           one.influence == other.influence && one.friction == other.friction;
  };
  return a.title == b.title && a.about == b.about && a.arm == b.arm && haveSameArm(a, b) && a.combine == b.combine &&
         std::equal(a.constraints.begin(), a.constraints.end(), b.constraints.begin(), b.constraints.end(),
                    have_same_target);
}

/// Whether the states of the two are compatible: joint by joint the same kind, so that their values continue; the same
/// triangles, so that the proxy's face exists.
bool goTogether(const Shape& a, const Shape& b) {
  if (const auto* mesh = std::get_if<Mesh>(&a), *next = std::get_if<Mesh>(&b); mesh != nullptr && next != nullptr)
    return mesh->surface == next->surface;
  if (const auto* curve = std::get_if<Curve>(&a), *next = std::get_if<Curve>(&b); curve != nullptr && next != nullptr)
    return curve->points == next->points && curve->kind == next->kind && curve->closed == next->closed;
  const auto *one = std::get_if<VirtualManipulator>(&a), *other = std::get_if<VirtualManipulator>(&b);
  if (one == nullptr || other == nullptr) return a.index() == b.index();
  const auto same_type = [](const Joint& left, const Joint& right) { return left.type == right.type; };
  return std::equal(one->joints.begin(), one->joints.end(), other->joints.begin(), other->joints.end(), same_type);
}

}  // namespace

Description withControl(Description scene, std::size_t index, const Control& control) {
  const bool only_one = scene.constraints.size() == 1 && !scene.constraints[index].control;
  (only_one ? scene.control : scene.constraints[index].control.emplace()) = control;
  return scene;
}

Description withShape(Description scene, std::size_t index, const Shape& shape) {
  scene.constraints[index].shape = shape;
  return scene;
}

Description withAdded(Description scene, Constraint constraint) {
  const auto is_taken = [&scene](const std::string& name) {
    return std::any_of(scene.constraints.begin(), scene.constraints.end(),
                       [&name](const Constraint& other) { return other.name == name; });
  };
  const std::string first_name = constraint.name;
  for (int number = 2; is_taken(constraint.name); ++number) constraint.name = first_name + " " + std::to_string(number);
  scene.constraints.push_back(std::move(constraint));
  return scene;
}

Description without(Description scene, std::size_t index) {
  scene.constraints.erase(scene.constraints.begin() + static_cast<std::ptrdiff_t>(index));
  return scene;
}

bool isSame(const Description& a, const Description& b) {
  if (!(a.simulation == b.simulation) || !haveSameTargets(a, b)) return false;
  for (std::size_t index = 0; index < a.constraints.size(); ++index) {
    if (!(controlOf(a, index) == controlOf(b, index))) return false;
  }
  return true;
}

Change changeBetween(const Description& before, const Description& after) {
  const std::size_t count = before.constraints.size();
  if (!haveSameArm(before, after) || before.combine != after.combine || after.constraints.size() != count) {
    return Change::Scene;
  }
  for (std::size_t index = 0; index < count; ++index) {
    const Constraint &one = before.constraints[index], &other = after.constraints[index];
    const bool alike = goTogether(one.shape, other.shape) && one.side == other.side &&
                       one.influence.has_value() == other.influence.has_value() &&
                       one.friction.has_value() == other.friction.has_value();
    if (!alike || controlOf(before, index).space != controlOf(after, index).space) return Change::Scene;
  }
  return haveSameTargets(before, after) ? Change::Gains : Change::Targets;
}

}  // namespace underact::scene
