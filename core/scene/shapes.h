#pragma once
#include <tuple>
#include <type_traits>

#include "core/base/translate.h"
#include "core/base/types.h"
#include "core/shape/shape.h"

namespace underact::scene {

// The shapes of a scene that are plain numbers, each with its row of the table: reader, checks, writer, schema, mirror,
// moves, the compiler of scenes, panels and sweeps of tests go by the rows. A new shape: a struct, its row and its name
// in the list at the end. A type without a row does not compile.

/// The meaning of a shape's number: it decides the allowed values, and what a move, a mirror and a text make of it.
enum class Meaning : std::uint8_t { Position, Length, Direction, Rotation };

/// One key of a shape as in the file, the member that it stands for, its name in a panel, and what the schema says of
/// it; null: what it says of the meaning.
template <class Shape, class Number>
struct Field {
  const char* key;
  Number Shape::*member;
  Meaning meaning;
  const char *label, *about = nullptr;
  bool required = true;
};
/// By its member.
template <class Shape, class Number, class... More>
Field(const char*, Number Shape::*, More...) -> Field<Shape, Number>;

/// The word for a shape's type in the file, its name in a panel, and whether it has an inside and an outside. Of a
/// shape of this file, also what the schema says of it, the maker of the tick's shape, which takes the numbers in the
/// same order, and its keys.
template <class Make = std::nullptr_t, class... Fields>
struct ShapeRow {
  const char *type, *name;
  bool has_sides;
  const char* about = nullptr;
  Make make = nullptr;
  std::tuple<Fields...> fields = {};
};
/// Makes a row: of another type, and of a shape of this file.
constexpr ShapeRow<> shapeRow(const char* type, const char* name, bool has_sides) {
  return {type, name, has_sides};
}
template <class Make, class... Fields>
constexpr ShapeRow<Make, Fields...> shapeRow(const char* type, const char* name, bool has_sides, const char* about,
                                             Make make, Fields... fields) {
  return {type, name, has_sides, about, make, {fields...}};
}

/// The row of a type.
template <class Shape>
inline constexpr std::nullptr_t kRow = nullptr;

// The keys that several shapes have.
template <class Shape>
constexpr auto centre(Vec3 Shape::*member) {
  return Field{"center_mm", member, Meaning::Position, TRANSLATE_NOOP("shape", "Centre"), "Its centre, mm."};
}
template <class Shape>
constexpr auto through(Vec3 Shape::*member) {
  return Field{"point_mm", member, Meaning::Position, TRANSLATE_NOOP("shape", "Through"),
               "Any point of it; for a cylinder, of its axis; mm."};
}
template <class Shape>
constexpr auto normal(Vec3 Shape::*member) {
  return Field{"normal", member, Meaning::Direction, TRANSLATE_NOOP("shape", "Normal")};
}
template <class Shape>
constexpr auto radius(double Shape::*member) {
  return Field{"radius_mm", member, Meaning::Length, TRANSLATE_NOOP("shape", "Radius"), "Its radius, mm."};
}
template <class Shape>
constexpr auto rotation(Mat3 Shape::*member) {
  return Field{"R_WB", member, Meaning::Rotation, TRANSLATE_NOOP("shape", "x axis"), nullptr, false};
}

/// A point; every direction is held.
struct Point {
  Vec3 position_mm = Vec3::Zero();
  bool operator==(const Point&) const = default;
};
template <>
inline constexpr auto kRow<Point> = shapeRow("point", TRANSLATE_NOOP("shape", "Point"), false, "A point.",
                                             &shape::makePoint,
                                             Field{"position_mm", &Point::position_mm, Meaning::Position,
                                                   TRANSLATE_NOOP("shape", "Position"), "Its position, mm."});

/// A sphere; radius_mm above 0.
struct Sphere {
  Vec3 center_mm = Vec3::Zero();
  double radius_mm = 0.0;
  bool operator==(const Sphere&) const = default;
};
template <>
inline constexpr auto kRow<Sphere> = shapeRow("sphere", TRANSLATE_NOOP("shape", "Sphere"), true,
                                              "The surface of a sphere.", &shape::makeSphere,
                                              centre(&Sphere::center_mm), radius(&Sphere::radius_mm));

/// An infinite line. direction: any length but zero.
struct Line {
  Vec3 point_mm = Vec3::Zero();
  Vec3 direction = Vec3::UnitX();
  bool operator==(const Line&) const = default;
};
template <>
inline constexpr auto kRow<Line> = shapeRow("line", TRANSLATE_NOOP("shape", "Line"), false, "An infinite line.",
                                            &shape::makeLine, through(&Line::point_mm),
                                            Field{"direction", &Line::direction, Meaning::Direction,
                                                  TRANSLATE_NOOP("shape", "Direction")});

/// An infinite plane; its normal, of any length but zero, points outside.
struct Plane {
  Vec3 point_mm = Vec3::Zero();
  Vec3 normal = Vec3::UnitY();
  bool operator==(const Plane&) const = default;
};
template <>
inline constexpr auto kRow<Plane> = shapeRow("plane", TRANSLATE_NOOP("shape", "Plane"), true,
                                             "An infinite plane; its outside is where the normal points.",
                                             &shape::makePlane, through(&Plane::point_mm), normal(&Plane::normal));

/// A circle about its centre, at right angles to the normal. radius_mm above 0.
struct Circle {
  Vec3 center_mm = Vec3::Zero();
  Vec3 normal = Vec3::UnitZ();
  double radius_mm = 0.0;
  bool operator==(const Circle&) const = default;
};
template <>
inline constexpr auto kRow<Circle> = shapeRow("circle", TRANSLATE_NOOP("shape", "Circle"), false,
                                              "A circle: the line, not the disc.", &shape::makeCircle,
                                              centre(&Circle::center_mm), normal(&Circle::normal),
                                              radius(&Circle::radius_mm));

/// An infinite cylinder. axis: any length but zero; radius_mm above 0.
struct Cylinder {
  Vec3 point_mm = Vec3::Zero();
  Vec3 axis = Vec3::UnitZ();
  double radius_mm = 0.0;
  bool operator==(const Cylinder&) const = default;
};
template <>
inline constexpr auto kRow<Cylinder> = shapeRow(
    "cylinder", TRANSLATE_NOOP("shape", "Cylinder"), true, "A cylinder, infinite along its axis.", &shape::makeCylinder,
    through(&Cylinder::point_mm), Field{"axis", &Cylinder::axis, Meaning::Direction, TRANSLATE_NOOP("shape", "Axis")},
    radius(&Cylinder::radius_mm));

/// A box; size_mm: its full edges, along the columns of the rotation R_WB.
struct Box {
  Vec3 center_mm = Vec3::Zero();
  Vec3 size_mm = Vec3::Zero();
  Mat3 R_WB = Mat3::Identity();
  bool operator==(const Box&) const = default;
};
template <>
inline constexpr auto kRow<Box> = shapeRow("box", TRANSLATE_NOOP("shape", "Box"), true, "The surface of a box.",
                                           &shape::makeBox, centre(&Box::center_mm),
                                           Field{"size_mm", &Box::size_mm, Meaning::Length,
                                                 TRANSLATE_NOOP("shape", "Size"),
                                                 "Its three edges along its own x, y and z, mm."},
                                           rotation(&Box::R_WB));

/// An ellipsoid; semi_axes_mm: half of its axes, along the columns of the rotation R_WB.
struct Ellipsoid {
  Vec3 center_mm = Vec3::Zero();
  Vec3 semi_axes_mm = Vec3::Zero();
  Mat3 R_WB = Mat3::Identity();
  bool operator==(const Ellipsoid&) const = default;
};
template <>
inline constexpr auto kRow<Ellipsoid> = shapeRow("ellipsoid", TRANSLATE_NOOP("shape", "Ellipsoid"), true,
                                                 "The surface of an ellipsoid.", &shape::makeEllipsoid,
                                                 centre(&Ellipsoid::center_mm),
                                                 Field{"semi_axes_mm", &Ellipsoid::semi_axes_mm, Meaning::Length,
                                                       TRANSLATE_NOOP("shape", "Semi-axes"),
                                                       "Half of its axes along its own x, y and z, mm."},
                                                 rotation(&Ellipsoid::R_WB));

/// A variant of the shapes of this file, and of others after them.
template <template <class...> class Variant, class... Others>
using ShapesAnd = Variant<Point, Sphere, Line, Plane, Circle, Cylinder, Box, Ellipsoid, Others...>;

/// Whether a type is a shape of this file.
template <class Shape>
concept PlainShape = requires {
  requires !std::is_same_v<std::remove_cv_t<decltype(kRow<std::remove_cvref_t<Shape>>.make)>, std::nullptr_t>;
};

/// Calls visit(field, number) for each field of the shape, in the order of the file; others than plain shapes have
/// none.
template <class Shape, class Visit>
void eachField(Shape& shape, Visit&& visit) {
  std::apply([&](const auto&... field) { (visit(field, shape.*field.member), ...); },
             kRow<std::remove_const_t<Shape>>.fields);
}

}  // namespace underact::scene
