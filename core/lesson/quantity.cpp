#include "core/lesson/quantity.h"

#include <algorithm>

#include "core/base/translate.h"

namespace underact::lesson {
namespace {

bool isInfluenced(const scene::Constraint& constraint) {
  return constraint.influence.has_value();
}

bool isRobot(const scene::Constraint& constraint) {
  return std::holds_alternative<scene::VirtualManipulator>(constraint.shape);
}

}  // namespace

const Quantity* findQuantity(std::string_view key) {
  const std::span<const Quantity> all = quantities();
  const auto found = std::find_if(all.begin(), all.end(), [key](const Quantity& one) { return key == one.key; });
  return found == all.end() ? nullptr : &*found;
}

const char* unitOfDistance(const Quantity& quantity) {
  return quantity.apart == DistanceMetric::Angle ? "°" : quantity.unit;
}

Sentence missingReason(const Quantity& quantity, const scene::Description& scene) {
  const auto has = [&scene](bool (*is)(const scene::Constraint&)) {
    return std::any_of(scene.constraints.begin(), scene.constraints.end(), is);
  };
  const auto missing = [&](const char* pattern) { return phrase(pattern, {scene.title, quantity.key}); };
  if (quantity.needs == Needs::Influence && !has(isInfluenced))
    return missing(TRANSLATE_NOOP("problem", "The scene \"%1\" has no %2: none of its constraints has an influence."));
  if (quantity.needs == Needs::Robot && !has(isRobot))
    return missing(
        TRANSLATE_NOOP("problem", "The scene \"%1\" has no %2: none of its constraints is a virtual robot."));
  if (quantity.needs != Needs::Energy) return {};
  for (std::size_t index = 0; index < scene.constraints.size(); ++index) {
    if (scene::controlOf(scene, index).passivity != control::Passivity::Off) return {};
  }
  return missing(TRANSLATE_NOOP(
      "problem", "The scene \"%1\" has no %2: its passivity is \"off\", so its energy is not observed."));
}

}  // namespace underact::lesson
