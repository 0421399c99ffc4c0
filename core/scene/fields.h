#pragma once
#include <tuple>

#include "core/json/words.h"
#include "core/scene/description.h"

namespace underact::scene {

// The keys of each type of shape: one list for reader, checks and writer. A new type without its Fields does not
// compile.

/// The meaning of a shape's number, which decides the allowed values.
enum class Meaning : std::uint8_t { Position, Direction, Length, Rotation };

/// One key of a shape: the member that it stands for, and what the number means.
template <class Shape, class Number>
struct Field {
  /// its_key: as in the file; it lives as long as the field.
  constexpr Field(const char* its_key, Number Shape::*its_member, Meaning its_meaning, bool is_required = true)
      : key(its_key), member(its_member), meaning(its_meaning), required(is_required) {}
  const char* key;
  Number Shape::*member;
  Meaning meaning;
  bool required;
};

/// The word for a shape's type, whether it has an inside and an outside, and its keys; one specialisation a type.
template <class Shape>
struct Fields;

template <>
struct Fields<Point> {
  static constexpr const char* kType = "point";
  static constexpr bool kHasSides = false;
  static constexpr std::tuple kAll{Field{"position_mm", &Point::position_mm, Meaning::Position}};
};

template <>
struct Fields<Sphere> {
  static constexpr const char* kType = "sphere";
  static constexpr bool kHasSides = true;
  static constexpr std::tuple kAll{Field{"center_mm", &Sphere::center_mm, Meaning::Position},
                                   Field{"radius_mm", &Sphere::radius_mm, Meaning::Length}};
};

template <>
struct Fields<Line> {
  static constexpr const char* kType = "line";
  static constexpr bool kHasSides = false;
  static constexpr std::tuple kAll{Field{"point_mm", &Line::point_mm, Meaning::Position},
                                   Field{"direction", &Line::direction, Meaning::Direction}};
};

template <>
struct Fields<Plane> {
  static constexpr const char* kType = "plane";
  static constexpr bool kHasSides = true;
  static constexpr std::tuple kAll{Field{"point_mm", &Plane::point_mm, Meaning::Position},
                                   Field{"normal", &Plane::normal, Meaning::Direction}};
};

template <>
struct Fields<Circle> {
  static constexpr const char* kType = "circle";
  static constexpr bool kHasSides = false;
  static constexpr std::tuple kAll{Field{"center_mm", &Circle::center_mm, Meaning::Position},
                                   Field{"normal", &Circle::normal, Meaning::Direction},
                                   Field{"radius_mm", &Circle::radius_mm, Meaning::Length}};
};

template <>
struct Fields<Cylinder> {
  static constexpr const char* kType = "cylinder";
  static constexpr bool kHasSides = true;
  static constexpr std::tuple kAll{Field{"point_mm", &Cylinder::point_mm, Meaning::Position},
                                   Field{"axis", &Cylinder::axis, Meaning::Direction},
                                   Field{"radius_mm", &Cylinder::radius_mm, Meaning::Length}};
};

template <>
struct Fields<Box> {
  static constexpr const char* kType = "box";
  static constexpr bool kHasSides = true;
  static constexpr std::tuple kAll{Field{"center_mm", &Box::center_mm, Meaning::Position},
                                   Field{"size_mm", &Box::size_mm, Meaning::Length},
                                   Field{"R_WB", &Box::R_WB, Meaning::Rotation, false}};
};

/// Joints, home and solver are not plain numbers: manipulators.cpp reads, checks and writes them.
template <>
struct Fields<VirtualManipulator> {
  static constexpr const char* kType = "virtual_manipulator";
  static constexpr bool kHasSides = false;
  static constexpr std::tuple<> kAll{};
};

/// For its file and pose see meshes.cpp.
template <>
struct Fields<Mesh> {
  static constexpr const char* kType = "mesh";
  static constexpr bool kHasSides = true;
  static constexpr std::tuple<> kAll{};
};

/// As of a mesh, with its guidance: curves.cpp.
template <>
struct Fields<Curve> {
  static constexpr const char* kType = "curve";
  static constexpr bool kHasSides = false;
  static constexpr std::tuple<> kAll{};
};

/// Calls visit(field, number) for each field of the shape, in the order of the file.
template <class Shape, class Visit>
void eachField(Shape& shape, Visit&& visit) {
  std::apply([&](const auto&... field) { (visit(field, shape.*field.member), ...); },
             Fields<std::remove_const_t<Shape>>::kAll);
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

inline constexpr Word<curve::Kind> kCurveWords[] = {{"spline", curve::Kind::Spline},
                                                    {"polyline", curve::Kind::Polyline}};
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
