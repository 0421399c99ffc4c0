#include <array>

#include "core/base/norms.h"
#include "core/shape/shape.h"
#include "tests/error_bounds/oracle/shapes.h"
#include "tests/error_bounds/rows/rows.h"

namespace underact::error_bounds {
namespace weighted_shapes_rows {

using shape::Nearest;
using shape::Status;

struct Drawn {
  Vec3 p_WC, axis_W, scale;
  double size_m = 0.0;
};

/// The plain shape, and the scales of unequal gains: 1e-6 to 1.
Drawn drawScaled(Input& input) {
  Drawn drawn;
  drawn.size_m = input.number("size_m", [](Dice& dice) { return dice.scale(); });
  drawn.p_WC = input.vector("p_WC", [&](Dice& dice) {
    return dice.one(3) ? Vec3(Vec3::Zero()) : dice.inBox(dice.one(2) ? dice.scale() : 3.0 * drawn.size_m);
  });
  drawn.axis_W = input.vector("axis_W", [](Dice& dice) { return dice.direction(); });
  drawn.scale = input.vector("scale", [](Dice& dice) {
    const auto one = [&] { return dice.one(3) ? 1.0 : dice.one(2) ? dice.between(0.2, 1.0) : dice.power(-20, 0) / 2; };
    return Vec3(one(), one(), one());
  });
  return drawn;
}

/// A tip near the scaled shape: anywhere, in the middle of a thin axis except for 2^-k, or along one axis.
Vec3 drawTip(Input& input, const Vec3& p_WC, const Mat3& axes, const Vec3& sizes) {
  return input.vector("p_WT", [&](Dice& dice) {
    if (dice.one(5)) return dice.oddPointAbout(p_WC, axes.col(0), largestOf(sizes));
    const double reach = dice.one(3) ? 1.0 + dice.closeness() : dice.one(2) ? 3.0 : dice.power(-20, 10);
    Vec3 share = dice.inBox(reach);
    for (Eigen::Index i = 0; i < 3; ++i) {
      if (dice.one(3)) share[i] = dice.one(2) ? 0.0 : dice.closeness();
    }
    return Vec3(p_WC + axes * share.cwiseProduct(sizes));
  });
}

/// y and semi: tip and half axes in the quadric's own frame, the third beside it for an ellipse.
struct InFrame {
  Real3 p_WC;
  std::array<Real3, 3> axes;
  std::array<Real, 3> semi;
  std::array<Real, 3> of(const Real3& p_W) const {
    const Real3 away = p_W - p_WC;
    return {dot(away, axes[0]), dot(away, axes[1]), dot(away, axes[2])};
  }
};

enum class Solid { Ellipsoid, Ellipse, Cylinder };

Real distanceTo(Solid solid, const InFrame& frame, const Real3& p_W) {
  const std::array<Real, 3> y = frame.of(p_W);
  const Real in_plane = oracle::toQuadric(frame.semi, y, solid == Solid::Ellipsoid ? 3 : 2);
  return solid == Solid::Ellipse ? Real(sqrt(in_plane * in_plane + y[2] * y[2])) : in_plane;
}

bool isInside(Solid solid, const InFrame& frame, const Real3& p_W) {
  if (solid == Solid::Ellipse) return false;
  const std::array<Real, 3> y = frame.of(p_W);
  Real sum = 0;
  for (std::size_t i = 0; i < (solid == Solid::Ellipsoid ? 3U : 2U); ++i)
    sum += (y[i] / frame.semi[i]) * (y[i] / frame.semi[i]);
  return sum < 1;
}

Outcome compare(Solid solid, const InFrame& frame, const Nearest& got, const Vec3& p_WT, const Real& scale) {
  const Real3 tip = real(p_WT);
  const Real nearest = distanceTo(solid, frame, tip);
  const Real height = isInside(solid, frame, tip) ? Real(-nearest) : nearest;
  const double height_ulp = ulpsOf(got.height_m, height, scale);
  if (!got.p_WP.allFinite()) return {kInfinity, false};
  if (got.status == Status::NotUnique) return {got.p_WP == p_WT ? height_ulp : kInfinity, true};
  const Real off = distanceTo(solid, frame, real(got.p_WP)), farther = norm(real(got.p_WP) - tip) - nearest;
  return {std::max({height_ulp, ulpsOf(off, scale), ulpsOf(farther > 0 ? farther : Real(0), scale)}), false};
}

Outcome judgeEllipsoid(Input& input) {
  const Drawn drawn = drawScaled(input);
  const shape::Ellipsoid ellipsoid = shape::scaled(shape::Sphere{drawn.p_WC, drawn.size_m}, drawn.scale);
  const Vec3 p_WT = drawTip(input, ellipsoid.p_WC, Mat3::Identity(), ellipsoid.semi_m);
  const Nearest got = asTheServo([&] { return closestPoint(ellipsoid, p_WT); });
  const Vec3& semi = ellipsoid.semi_m;
  const InFrame frame{real(ellipsoid.p_WC), oracle::axesOf(Mat3::Identity()), {semi.x(), semi.y(), semi.z()}};
  const double largest = std::max({largestOf(ellipsoid.p_WC), largestOf(semi), largestOf(p_WT)});
  return compare(Solid::Ellipsoid, frame, got, p_WT, largest);
}

Mat3 axesOf(const shape::Ellipse& ellipse) {
  Mat3 axes;
  axes << ellipse.first_W, ellipse.second_W, ellipse.axis_W;
  return axes;
}

template <class Shape>
Outcome judgeElliptic(Input& input, const Shape& shape, const shape::Ellipse& section, Solid solid) {
  const Mat3 axes = axesOf(section);
  const Vec3 p_WT = drawTip(input, section.p_WC, axes, {section.first_m, section.second_m, section.first_m});
  const Nearest got = asTheServo([&] { return closestPoint(shape, p_WT); });
  const InFrame frame{real(section.p_WC), oracle::axesOf(axes), {section.first_m, section.second_m, 1}};
  const double largest = std::max({largestOf(section.p_WC), section.first_m, section.second_m, largestOf(p_WT)});
  return compare(solid, frame, got, p_WT, largest);
}

Outcome judgeEllipse(Input& input) {
  const Drawn drawn = drawScaled(input);
  const shape::Circle circle = shape::makeCircle(drawn.p_WC, drawn.axis_W, drawn.size_m, {}).value();
  const shape::Ellipse ellipse = shape::scaled(circle, drawn.scale);
  return judgeElliptic(input, ellipse, ellipse, Solid::Ellipse);
}

Outcome judgeEllipticCylinder(Input& input) {
  const Drawn drawn = drawScaled(input);
  const shape::Cylinder cylinder = shape::makeCylinder(drawn.p_WC, drawn.axis_W, drawn.size_m, {}).value();
  const shape::EllipticCylinder elliptic = shape::scaled(cylinder, drawn.scale);
  return judgeElliptic(input, elliptic, elliptic.section, Solid::Cylinder);
}

Outcome judgeParallelepiped(Input& input) {
  const Drawn drawn = drawScaled(input);
  const Vec3 sizes = input.vector("sizes", [](Dice& dice) { return dice.ratios(); });
  const Mat3 R_WB = input.matrix("R_WB", [](Dice& dice) { return dice.one(3) ? Mat3(Mat3::Identity()) : dice.turn(); });
  const shape::Box box = shape::makeBox(drawn.p_WC, drawn.size_m * sizes, R_WB, {}).value();
  const shape::Parallelepiped solid = shape::scaled(box, drawn.scale);
  const Vec3 p_WT = drawTip(input, solid.p_WC, solid.edges_W, Vec3::Ones());
  const Nearest got = asTheServo([&] { return closestPoint(solid, p_WT); });
  const std::array<Real3, 3> edges{real(solid.edges_W.col(0)), real(solid.edges_W.col(1)), real(solid.edges_W.col(2))};
  const Real3 centre = real(solid.p_WC), tip = real(p_WT);
  const oracle::Nearest right = oracle::onSolid(centre, edges, tip);
  const Real height = oracle::isInSolid(centre, edges, tip) ? Real(-right.distance) : right.distance;
  const Real scale = std::max({largestOf(solid.p_WC), largestOf(p_WT), solid.edges_W.cwiseAbs().maxCoeff()});
  const double height_ulp = ulpsOf(got.height_m, height, scale);
  if (!got.p_WP.allFinite()) return {kInfinity, false};
  if (got.status == Status::NotUnique) return {got.p_WP == p_WT ? height_ulp : kInfinity, true};
  const Real off = oracle::onSolid(centre, edges, real(got.p_WP)).distance;
  const Real farther = norm(real(got.p_WP) - tip) - right.distance;
  return {std::max({height_ulp, ulpsOf(off, scale), ulpsOf(farther > 0 ? farther : Real(0), scale)}), false};
}

constexpr const char* kPromise =
    "ulp of the largest coordinate of the shape and the tip: off the shape, farther than the nearest, height";

constexpr std::array<Row, 4> kRows{{
    {"shape_ellipsoid", Kind::Shape, "Ellipsoid: nearest point, height", kPromise, 64, 12, judgeEllipsoid},
    {"shape_ellipse", Kind::Shape, "Ellipse: nearest point, distance", kPromise, 64, 12, judgeEllipse},
    {"shape_elliptic_cylinder", Kind::Shape, "Elliptic cylinder: nearest point, height", kPromise, 64, 12,
     judgeEllipticCylinder},
    {"shape_parallelepiped", Kind::Shape, "Parallelepiped: nearest point, height", kPromise, 64, 10,
     judgeParallelepiped},
}};

}  // namespace weighted_shapes_rows

constinit const std::span<const Row> kWeightedShapeRows = weighted_shapes_rows::kRows;

}  // namespace underact::error_bounds
