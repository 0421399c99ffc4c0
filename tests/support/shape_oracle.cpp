#include "tests/support/shape_oracle.h"

#include <algorithm>
#include <cmath>

namespace underact::test {
namespace {

constexpr double kMaxTurn_rad = 3.14159265358979323846;
constexpr double kFar_m = 2.0;  // how far lines, planes and cylinders are searched

struct Axes {
  Vec3 u, v, w;
};

/// Two directions across w, by Gram and Schmidt from a random start.
Axes around(Random& random, const Vec3& w) {
  for (;;) {
    const Vec3 start = random.direction();
    const Vec3 across = start - start.dot(w) * w;
    if (across.norm() < 0.1) continue;
    const Vec3 u = across / across.norm();
    return {u, Vec3(w.y() * u.z() - w.z() * u.y(), w.z() * u.x() - w.x() * u.z(), w.x() * u.y() - w.y() * u.x()), w};
  }
}

double distanceFromAxis(const Vec3& p, const Vec3& on, const Vec3& w) {
  return (p - on).cross(w).norm();
}

ShapeOracle sphere(Random& random) {
  const Vec3 c = random.inBox(0.1);
  const double r = random.between(0.01, 0.1);
  ShapeOracle made{"sphere", shape::makeSphere(c, r, {}).value(), {}, Vec3::Ones(), {}, {}, true, r};
  made.patches = {{[=](double a, double b) -> Vec3 {
                     return c + r * Vec3(std::cos(a) * std::cos(b), std::sin(a) * std::cos(b), std::sin(b));
                   },
                   kMaxTurn_rad, kMaxTurn_rad / 2}};
  made.off = [=](const Vec3& q) { return (q - c).norm() - r; };
  return made;
}

ShapeOracle circle(Random& random) {
  const Vec3 c = random.inBox(0.1), n = random.direction();
  const double r = random.between(0.01, 0.1);
  const Axes axes = around(random, n);
  ShapeOracle made{"circle", shape::makeCircle(c, 3.0 * n, r, {}).value(), {}, Vec3::Ones(), {}, {}, false, r};
  made.patches = {{[=](double a, double) -> Vec3 { return c + r * (std::cos(a) * axes.u + std::sin(a) * axes.v); },
                   kMaxTurn_rad, 0.0}};
  made.off = [=](const Vec3& q) { return std::hypot((q - c).dot(n), distanceFromAxis(q, c, n) - r); };
  return made;
}

ShapeOracle cylinder(Random& random) {
  const Vec3 c = random.inBox(0.1), n = random.direction();
  const double r = random.between(0.01, 0.1);
  const Axes axes = around(random, n);
  ShapeOracle made{"cylinder", shape::makeCylinder(c, 0.2 * n, r, {}).value(), {}, Vec3::Ones(), {}, {}, true, r};
  made.patches = {
      {[=](double a, double b) -> Vec3 { return c + r * (std::cos(a) * axes.u + std::sin(a) * axes.v) + b * n; },
       kMaxTurn_rad, kFar_m, false, true}};
  made.off = [=](const Vec3& q) { return distanceFromAxis(q, c, n) - r; };
  return made;
}

ShapeOracle box(Random& random) {
  const Vec3 c = random.inBox(0.1);
  const Vec3 half(random.between(0.01, 0.1), random.between(0.01, 0.1), random.between(0.01, 0.1));
  const Axes axes = around(random, random.direction());
  Mat3 R;
  R << axes.u, axes.v, axes.w;
  ShapeOracle made{"box",          shape::makeBox(c, 2.0 * half, R, {}).value(), {}, Vec3::Ones(), {}, {}, true,
                   half.minCoeff()};
  const std::array<Vec3, 3> edge{half.x() * axes.u, half.y() * axes.v, half.z() * axes.w};
  for (std::size_t i = 0; i < 3; ++i) {
    for (const double side : {-1.0, 1.0}) {
      made.patches.push_back({[=](double a, double b) -> Vec3 {
                                return c + side * edge[i] + a * edge[(i + 1) % 3] + b * edge[(i + 2) % 3];
                              },
                              1.0, 1.0, true});
    }
  }
  made.off = [=](const Vec3& q) {
    const Vec3 d = q - c;
    return std::max(
        {std::abs(d.dot(axes.u)) - half.x(), std::abs(d.dot(axes.v)) - half.y(), std::abs(d.dot(axes.w)) - half.z()});
  };
  return made;
}

ShapeOracle ellipsoid(Random& random) {
  const Vec3 c = random.inBox(0.1);
  const Vec3 semi(random.between(0.02, 0.1), random.between(0.02, 0.1), random.between(0.02, 0.1));
  const Axes axes = around(random, random.direction());
  Mat3 R;
  R << axes.u, axes.v, axes.w;
  ShapeOracle made{"turned ellipsoid", shape::makeEllipsoid(c, semi, R, {}).value(), {}, Vec3::Ones(), {}, {}, true,
                   semi.maxCoeff()};
  made.patches = {{[=](double a, double b) -> Vec3 {
                     return c + semi.x() * std::cos(a) * std::cos(b) * axes.u +
                            semi.y() * std::sin(a) * std::cos(b) * axes.v + semi.z() * std::sin(b) * axes.w;
                   },
                   kMaxTurn_rad, kMaxTurn_rad / 2}};
  made.off = [=](const Vec3& q) {  // to first order: the level over its slope
    const Vec3 d(axes.u.dot(q - c), axes.v.dot(q - c), axes.w.dot(q - c)), share = d.cwiseQuotient(semi);
    return share.norm() * (share.norm() - 1.0) / share.cwiseQuotient(semi).norm();
  };
  return made;
}

ShapeOracle point(Random& random) {
  const Vec3 c = random.inBox(0.1);
  ShapeOracle made{"point", shape::makePoint(c, {}).value(), {}, Vec3::Ones(), {}, {}, false, 0.0};
  made.patches = {{[=](double, double) -> Vec3 { return c; }, 0.0, 0.0}};
  made.off = [=](const Vec3& q) { return (q - c).norm(); };
  return made;
}

ShapeOracle line(Random& random) {
  const Vec3 c = random.inBox(0.1), d = random.direction();
  ShapeOracle made{"line", shape::makeLine(c, 7.0 * d, {}).value(), {}, Vec3::Ones(), {}, {}, false, 0.0};
  made.patches = {{[=](double a, double) -> Vec3 { return c + a * d; }, kFar_m, 0.0}};
  made.off = [=](const Vec3& q) { return distanceFromAxis(q, c, d); };
  return made;
}

ShapeOracle plane(Random& random) {
  const Vec3 c = random.inBox(0.1), n = random.direction();
  const Axes axes = around(random, n);
  ShapeOracle made{"plane", shape::makePlane(c, 0.5 * n, {}).value(), {}, Vec3::Ones(), {}, {}, true, 0.0};
  made.patches = {
      {[=](double a, double b) -> Vec3 { return c + a * axes.u + b * axes.v; }, kFar_m, kFar_m, false, true}};
  made.off = [=](const Vec3& q) { return (q - c).dot(n); };
  return made;
}

ShapeOracle scaledBy(const Vec3& scale, const char* name, ShapeOracle plain) {
  plain.name = name;
  plain.scale = scale;
  plain.shape = shape::scaled(plain.plain, scale);
  for (Patch& patch : plain.patches) {
    patch.at = [scale, at = patch.at](double a, double b) -> Vec3 { return scale.cwiseProduct(at(a, b)); };
  }
  return plain;
}

double searchPatch(const Patch& patch, const Vec3& p_WT) {
  if (patch.straight) {  // a skewed cylinder is a narrow valley in a and b, and no valley at all in a alone
    const auto at = [&](double a, double) -> Vec3 {
      const Vec3 start = patch.at(a, 0.0), along = patch.at(a, 1.0) - start;
      return start + (along.dot(p_WT - start) / along.dot(along)) * along;
    };
    return searchPatch({at, patch.a_half, 0.0}, p_WT);
  }
  // In each direction; the search below needs only the right basin. A thin ellipse has narrow ones at its ends: with 8
  // starts one of 25 000 draws missed them.
  const int grid = patch.b_half > 0.0 ? 8 : 64;
  const auto inRange = [&](double x, double half) { return patch.held ? std::clamp(x, -half, half) : x; };
  const auto square = [&](double a, double b) { return (patch.at(a, b) - p_WT).squaredNorm(); };
  constexpr std::array<std::array<double, 2>, 8> kHeadings{
      {{1, 0}, {-1, 0}, {0, 1}, {0, -1}, {1, 1}, {-1, -1}, {1, -1}, {-1, 1}}};
  double over_all = kInfinity;
  for (int i = 0; i <= (patch.a_half > 0.0 ? grid : 0); ++i) {  // from each a: the far side has a bottom of its own
    double best = kInfinity, best_a = 0.0, best_b = 0.0;
    const auto take = [&](double a, double b) {
      const double here = square(a, b);
      if (!(here < best)) return false;
      best = here, best_a = a, best_b = b;
      return true;
    };
    for (int j = 0; j <= (patch.b_half > 0.0 ? grid : 0); ++j) {
      take(patch.a_half * (2.0 * i / grid - 1.0), patch.b_half * (2.0 * j / grid - 1.0));
    }
    for (double step = 2.0 / grid; step > 1e-9;) {  // 1e-9 of a flat bottom: 1e-18 of the square
      bool better = false;
      for (const auto& heading : kHeadings) {  // eight: a slanting valley of a scaled face is followed too
        better = take(inRange(best_a + heading[0] * step * patch.a_half, patch.a_half),
                      inRange(best_b + heading[1] * step * patch.b_half, patch.b_half)) ||
                 better;
      }
      if (!better) step /= 2.0;
    }
    over_all = std::min(over_all, best);
    if (patch.held) break;  // a face is flat: one bottom, whatever the start
  }
  return std::sqrt(over_all);
}

}  // namespace

std::vector<ShapeOracle> everyShape(Random& random) {
  static_assert(std::variant_size_v<shape::Shape> == 11,
                "A new shape: give it an oracle here, and it is in all sweeps.");
  std::vector<ShapeOracle> all{point(random),  sphere(random),   line(random), plane(random),
                               circle(random), cylinder(random), box(random),  ellipsoid(random)};
  for (ShapeOracle& one : all) one.plain = one.shape;
  const std::vector<ShapeOracle> plain = all;
  constexpr std::array<const char*, 8> kNames{"scaled point",   "ellipsoid",       "scaled line",
                                              "scaled plane",   "ellipse",         "elliptic cylinder",
                                              "parallelepiped", "scaled ellipsoid"};
  const Vec3 scale(random.between(0.2, 1.0), random.between(0.2, 1.0), random.between(0.2, 1.0));
  for (std::size_t i = 0; i < plain.size(); ++i) all.push_back(scaledBy(scale, kNames[i], plain[i]));
  return all;
}

double searchDistance(const ShapeOracle& oracle, const Vec3& p_WT) {
  double best = kInfinity;
  for (const Patch& patch : oracle.patches) best = std::min(best, searchPatch(patch, p_WT));
  return best;
}

}  // namespace underact::test
