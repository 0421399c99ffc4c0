#include "core/scene/description.h"

#include <cmath>
#include <type_traits>

#include "core/scene/fields.h"

namespace underact::scene {

bool Mesh::operator==(const Mesh& other) const {
  return file == other.file && scale_mm_per_unit == other.scale_mm_per_unit && X_WM == other.X_WM &&
         search == other.search && smooth_deg == other.smooth_deg && checksum == other.checksum;
}

bool Curve::operator==(const Curve& other) const {
  return file == other.file && scale_mm_per_unit == other.scale_mm_per_unit && X_WM == other.X_WM &&
         kind == other.kind && closed == other.closed && search == other.search && guide == other.guide &&
         checksum == other.checksum;
}

const char* typeName(const Shape& shape) {
  return std::visit([](const auto& chosen) { return kRow<std::decay_t<decltype(chosen)>>.type; }, shape);
}

const char* filterName(const Velocity& velocity) {
  return wordOf(kFilterWords, velocity.index());
}

const Control& controlOf(const Description& scene, std::size_t index) {
  const std::optional<Control>& own = scene.constraints[index].control;
  return own ? *own : scene.control;
}

Integration integrationOf(const Simulation& simulation) {
  return {simulation.integrator, std::llround(1e3 * simulation.substep_us)};
}

bool hasSides(const Shape& shape) {
  return std::visit([](const auto& chosen) { return kRow<std::decay_t<decltype(chosen)>>.has_sides; }, shape);
}

bool takesInfluence(const Shape& shape) {
  return std::holds_alternative<Circle>(shape) || std::holds_alternative<Cylinder>(shape) ||
         std::holds_alternative<Sphere>(shape);
}

bool takesFriction(const Shape& shape) {
  return !std::holds_alternative<Point>(shape) && !std::holds_alternative<VirtualManipulator>(shape);
}

const char* stiffnessKey(chain::JointType type) {
  return type == chain::JointType::Revolute ? "stiffness_N_mm_per_rad" : "stiffness_N_per_mm";
}

std::string defaultName(const Constraint& constraint, std::size_t index) {
  return std::string(typeName(constraint.shape)) + " " + std::to_string(index + 1);
}

}  // namespace underact::scene
