#pragma once
#include <utility>

#include "core/json/words.h"
#include "core/scene/description.h"

namespace underact::scene {

// The rows of the types that are more than plain numbers (of the others: shapes.h), and the words of all choices.

// For joints, home and solver see manipulators.cpp, for the file and pose of a mesh or a curve meshes.cpp.
template <>
inline constexpr auto kRow<VirtualManipulator> = shapeRow("virtual_manipulator",
                                                          TRANSLATE_NOOP("shape", "Virtual robot"), false);
template <>
inline constexpr auto kRow<Mesh> = shapeRow("mesh", TRANSLATE_NOOP("shape", "Mesh"), true);
template <>
inline constexpr auto kRow<Curve> = shapeRow("curve", TRANSLATE_NOOP("shape", "Curve"), false);

/// Calls visit(shape) for a default of each type of shape, in the order of Shape.
template <class Visit>
void eachShape(Visit&& visit) {
  const auto visitAll = [&]<std::size_t... kIndex>(std::index_sequence<kIndex...>) {
    (visit(std::variant_alternative_t<kIndex, Shape>{}), ...);
  };
  visitAll(std::make_index_sequence<std::variant_size_v<Shape>>{});
}

/// The word for the filter in a scene file: "kalman", ...
const char* filterName(const Velocity& velocity);

/// See core/json/words.h.
using json::Word;

inline constexpr Word<LawType> kLawWords[] = {{"P", LawType::P}, {"PD", LawType::PD}, {"PID", LawType::PID}};
inline constexpr Word<std::size_t> kFilterWords[] = {
    {"kalman", 0}, {"low_pass", 1}, {"adaptive_window", 2}, {"raw", 3}};  // in the order of Velocity
inline constexpr Word<Anisotropy> kAnisotropyWords[] = {{"weighted", Anisotropy::Weighted},
                                                        {"euclidean", Anisotropy::Euclidean}};
inline constexpr Word<tick::Space> kSpaceWords[] = {{"cartesian", tick::Space::Cartesian},
                                                    {"joint", tick::Space::Joint}};
inline constexpr Word<control::Passivity> kPassivityWords[] = {{"observe", control::Passivity::Observe},
                                                               {"off", control::Passivity::Off},
                                                               {"control", control::Passivity::Control}};
inline constexpr Word<StylusAxis> kStylusAxisWords[] = {{"+z", StylusAxis::PlusZ}, {"-z", StylusAxis::MinusZ}};
inline constexpr Word<target::Side> kSideWords[] = {
    {"both", target::Side::Both}, {"outside", target::Side::Outside}, {"inside", target::Side::Inside}};
inline constexpr Word<tick::Combine> kCombineWords[] = {{"sum", tick::Combine::Sum},
                                                        {"nearest", tick::Combine::Nearest}};

inline constexpr Word<Integrator> kIntegratorWords[] = {{"mean_velocity", Integrator::MeanVelocity},
                                                        {"end_velocity", Integrator::EndVelocity},
                                                        {"trapezoidal", Integrator::Trapezoidal}};

inline constexpr Word<chain::JointType> kJointWords[] = {{"revolute", chain::JointType::Revolute},
                                                         {"prismatic", chain::JointType::Prismatic}};
inline constexpr Word<manipulator::Orientation> kOrientationWords[] = {{"none", manipulator::Orientation::None},
                                                                       {"axis", manipulator::Orientation::Axis},
                                                                       {"angle", manipulator::Orientation::Angle},
                                                                       {"full", manipulator::Orientation::Full}};
inline constexpr Word<SolverMethod> kSolverWords[] = {
    {"auto", SolverMethod::Auto}, {"closed_form", SolverMethod::ClosedForm}, {"iterative", SolverMethod::Iterative}};
inline constexpr Word<manipulator::ForceLaw> kForceLawWords[] = {{"energy", manipulator::ForceLaw::Energy},
                                                                 {"thesis-5.2", manipulator::ForceLaw::Thesis52}};

inline constexpr Word<curve::CurveKind> kCurveWords[] = {{"spline", curve::CurveKind::Spline},
                                                         {"polyline", curve::CurveKind::Polyline}};
inline constexpr Word<mesh::Search> kSearchWords[] = {
    {"hybrid", mesh::Search::Hybrid}, {"global", mesh::Search::Global}, {"local", mesh::Search::Local}};

/// The key of a joint's spring: "stiffness_N_mm_per_rad" or "stiffness_N_per_mm".
const char* stiffnessKey(chain::JointType type);

/// Whether the type can have an influence: a circle, a cylinder, a sphere.
bool takesInfluence(const Shape& shape);

/// Whether the type can have friction: everything that the stylus can slide along.
bool takesFriction(const Shape& shape);

/// Whether the type separates the workspace into an inside and an outside.
bool hasSides(const Shape& shape);

/// The default name of the constraint at index: type and number, "sphere 2".
std::string defaultName(const Constraint& constraint, std::size_t index);

}  // namespace underact::scene
