#include "tests/error_bounds/oracle/shapes.h"

#include <array>

#include "core/base/norms.h"
#include "core/shape/shape.h"
#include "tests/error_bounds/rows/rows.h"

namespace underact::error_bounds {
namespace shapes_rows {

using shape::Nearest;
using shape::Status;

/// The position and size of a shape, and a tip near it.
struct Drawn {
  Vec3 p_WC, axis_W, p_WT;
  double size_m = 0.0;
  Real largest() const { return Real(std::max({largestOf(p_WC), largestOf(p_WT), size_m})); }
};

Vec3 drawCentre(Input& input, double size_m) {
  return input.vector("p_WC", [&](Dice& dice) {
    return dice.one(4) ? Vec3(Vec3::Zero()) : dice.one(3) ? dice.inBox(dice.scale()) : dice.inBox(3.0 * size_m);
  });
}

Drawn drawShape(Input& input) {
  Drawn drawn;
  drawn.size_m = input.number("radius_m", [](Dice& dice) { return dice.scale(); });
  drawn.p_WC = drawCentre(input, drawn.size_m);
  drawn.axis_W = input.vector("axis_W", [](Dice& dice) { return dice.direction(); });
  drawn.p_WT = input.vector("p_WT", [&](Dice& dice) {
    // On the shape except for 2^-k, or anywhere.
    if (dice.one(5))
      return Vec3(drawn.p_WC + drawn.size_m * (1.0 + dice.closeness()) * referencePerpendicular(drawn.axis_W));
    return dice.oddPointAbout(drawn.p_WC, drawn.axis_W, drawn.size_m);
  });
  return drawn;
}

/// A smooth shape: the point itself is compared.
Outcome compare(const Nearest& got, const oracle::Nearest& right, const Real& height, const Real& scale) {
  if (got.status != Status::Unique) return {kInfinity, false};
  return {std::max(ulpsOf(got.p_WP, right.p_WP, scale), ulpsOf(got.height_m, height, scale)), false};
}

/// A result that is reported as not unique: its height, and that the tip is within the rounding of the coordinates of
/// the middle. within: how near it may be.
Outcome compareDegenerate(const Nearest& got, const Vec3& p_WT, const Real& off, const Real& within, const Real& height,
                          const Real& scale) {
  if (off > within || got.p_WP != p_WT) return {kInfinity, true};
  return {ulpsOf(got.height_m, height, scale), true};
}

Outcome judgePoint(Input& input) {
  const Drawn drawn = drawShape(input);
  const shape::Shape point = shape::makePoint(drawn.p_WC, {}).value();
  const Nearest got = asTheServo([&] { return closestPoint(point, drawn.p_WT); });
  const Real3 p_WC = real(drawn.p_WC);
  return compare(got, {p_WC, 0}, norm(real(drawn.p_WT) - p_WC), drawn.largest());
}

Outcome judgeSphere(Input& input) {
  const Drawn drawn = drawShape(input);
  const shape::Shape sphere = shape::makeSphere(drawn.p_WC, drawn.size_m, {}).value();
  const Nearest got = asTheServo([&] { return closestPoint(sphere, drawn.p_WT); });
  const Real3 p_WC = real(drawn.p_WC), p_WT = real(drawn.p_WT);
  const Real off = norm(p_WT - p_WC), height = off - drawn.size_m;
  if (got.status == Status::NotUnique)
    return compareDegenerate(got, drawn.p_WT, off, 2 * shape::kTooShort_m, height, drawn.largest());
  return compare(got, oracle::onSphere(p_WC, drawn.size_m, p_WT), height, drawn.largest());
}

Outcome judgeLine(Input& input) {
  const Drawn drawn = drawShape(input);
  const shape::Line line = shape::makeLine(drawn.p_WC, drawn.axis_W, {}).value();
  const Nearest got = asTheServo([&] { return closestPoint(line, drawn.p_WT); });
  const oracle::Nearest right = oracle::onLine(real(drawn.p_WC), real(line.axis_W), real(drawn.p_WT));
  return compare(got, right, right.distance, drawn.largest());
}

Outcome judgePlane(Input& input) {
  const Drawn drawn = drawShape(input);
  const shape::Plane plane = shape::makePlane(drawn.p_WC, drawn.axis_W, {}).value();
  const Nearest got = asTheServo([&] { return closestPoint(plane, drawn.p_WT); });
  const Real3 normal = unit(real(plane.normal_W));
  const oracle::Nearest right = oracle::onPlane(real(drawn.p_WC), normal, real(drawn.p_WT));
  return compare(got, right, dot(real(drawn.p_WT) - real(drawn.p_WC), normal), drawn.largest());
}

/// Circle and cylinder. Their direction from the axis has the rounding of the vector from C to the tip over the
/// distance from the axis, and the point R times that.
template <class Round, class Right>
Outcome judgeRound(const Drawn& drawn, const Round& round, const Right& rightOf) {
  const Nearest got = asTheServo([&] { return closestPoint(round, drawn.p_WT); });
  const Real3 p_WC = real(drawn.p_WC), axis = real(round.axis_W), p_WT = real(drawn.p_WT);
  const Real off = oracle::offAxis(p_WC, axis, p_WT), away = norm(p_WT - p_WC), largest = drawn.largest();
  const auto [right, height] = rightOf(p_WC, axis, p_WT, off);
  const Real lost = Real(shape::kDirectionLost) * std::max(largestOf(drawn.p_WC), largestOf(drawn.p_WT));
  const Real rounding = ldexp(away, -50) + shape::kTooShort_m;
  if (got.status == Status::NotUnique) return compareDegenerate(got, drawn.p_WT, off, lost + rounding, height, largest);
  if (off < lost - rounding) return {kInfinity, false};
  const Real scale = largest + drawn.size_m * away / (8 * off);
  Outcome outcome = compare(got, right, height, scale);
  outcome.error_ulp = std::max(outcome.error_ulp, ulpsOf(got.height_m, height, largest));
  return outcome;
}

Outcome judgeCircle(Input& input) {
  const Drawn drawn = drawShape(input);
  const shape::Circle circle = shape::makeCircle(drawn.p_WC, drawn.axis_W, drawn.size_m, {}).value();
  return judgeRound(drawn, circle, [&](const Real3& p_WC, const Real3& axis, const Real3& p_WT, const Real&) {
    const oracle::Nearest right = oracle::onCircle(p_WC, axis, drawn.size_m, p_WT);
    return std::pair(right, right.distance);
  });
}

Outcome judgeCylinder(Input& input) {
  const Drawn drawn = drawShape(input);
  const shape::Cylinder cylinder = shape::makeCylinder(drawn.p_WC, drawn.axis_W, drawn.size_m, {}).value();
  return judgeRound(drawn, cylinder, [&](const Real3& p_WC, const Real3& axis, const Real3& p_WT, const Real& off) {
    return std::pair(oracle::onCylinder(p_WC, axis, drawn.size_m, p_WT), Real(off - drawn.size_m));
  });
}

/// The distance of a point from the surface, and its excess distance from the tip over the nearest point.
double offAndFarther(const Vec3& p_WP, const Real3& p_WT, const Real& off, const Real& nearest, const Real& scale) {
  if (!p_WP.allFinite()) return kInfinity;
  const Real farther = norm(real(p_WP) - p_WT) - nearest;
  return std::max(ulpsOf(off, scale), ulpsOf(farther > 0 ? farther : Real(0), scale));
}

Outcome judgeBox(Input& input) {
  const double size_m = input.number("size_m", [](Dice& dice) { return dice.scale(); });
  const Vec3 size_of_m = input.vector("sizes_m", [&](Dice& dice) {
    if (dice.one(3)) return Vec3(Vec3::Constant(size_m));  // many ties
    return Vec3(size_m * dice.ratios());
  });
  const Vec3 p_WC = drawCentre(input, size_m);
  const Mat3 R_WB = input.matrix("R_WB", [](Dice& dice) { return dice.one(3) ? Mat3(Mat3::Identity()) : dice.turn(); });
  const Vec3 p_WT = input.vector("p_WT", [&](Dice& dice) {
    if (dice.one(3)) {  // inside, or on a face but for 2^-k
      Vec3 share = dice.inBox(0.5);
      if (dice.one(2)) share[static_cast<Eigen::Index>(dice.below(3))] = 0.5 * dice.sign() * (1.0 + dice.closeness());
      return Vec3(p_WC + R_WB * share.cwiseProduct(size_of_m));
    }
    return dice.oddPointAbout(p_WC, R_WB.col(0), size_m);
  });
  const shape::Box box = shape::makeBox(p_WC, size_of_m, R_WB, {}).value();
  const Nearest got = asTheServo([&] { return closestPoint(box, p_WT); });
  std::array<Real3, 3> edges = oracle::axesOf(box.R_WB);
  for (std::size_t i = 0; i < 3; ++i) edges[i] = Real(box.half_m[static_cast<Eigen::Index>(i)]) * edges[i];
  const Real3 centre = real(p_WC), tip = real(p_WT);
  const oracle::Nearest right = oracle::onSolid(centre, edges, tip);
  const bool inside = oracle::isInSolid(centre, edges, tip);
  const Real height = inside ? Real(-right.distance) : right.distance;
  const Real scale = std::max({largestOf(p_WC), largestOf(p_WT), largestOf(box.half_m)});
  const double height_ulp = ulpsOf(got.height_m, height, scale);
  if (got.status == Status::NotUnique) return {got.p_WP == p_WT ? height_ulp : kInfinity, true};
  if (!got.p_WP.allFinite()) return {kInfinity, false};
  const Real off = oracle::onSolid(centre, edges, real(got.p_WP)).distance;
  double point_ulp = offAndFarther(got.p_WP, tip, off, right.distance, scale);
  if (!inside) point_ulp = std::max(point_ulp, ulpsOf(got.p_WP, right.p_WP, scale));  // convex: it is unique
  return {std::max(point_ulp, height_ulp), false};
}

constexpr const char* kOfLargest = "ulp of the largest coordinate of the shape and the tip";
constexpr const char* kOfRound = "the same, and near the axis R |CT| / (8 off the axis) more for the point";

constexpr std::array<Row, 7> kRows{{
    {"shape_point", Kind::Shape, "Point: nearest point, distance", kOfLargest, 64, 1, judgePoint},
    {"shape_sphere", Kind::Shape, "Sphere: nearest point, height", kOfLargest, 64, 1, judgeSphere},
    {"shape_line", Kind::Shape, "Line: nearest point, distance", kOfLargest, 64, 1, judgeLine},
    {"shape_plane", Kind::Shape, "Plane: nearest point, height", kOfLargest, 64, 1, judgePlane},
    {"shape_circle", Kind::Shape, "Circle: nearest point, distance", kOfRound, 64, 1, judgeCircle},
    {"shape_cylinder", Kind::Shape, "Cylinder: nearest point, height", kOfRound, 64, 1, judgeCylinder},
    {"shape_box", Kind::Shape, "Box: nearest point, height", kOfLargest, 64, 12, judgeBox},
}};

}  // namespace shapes_rows

constinit const std::span<const Row> kShapeRows = shapes_rows::kRows;

}  // namespace underact::error_bounds
