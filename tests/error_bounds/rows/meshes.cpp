#include <array>
#include <memory>

#include "core/base/norms.h"
#include "core/mesh/search.h"
#include "tests/error_bounds/oracle/shapes.h"
#include "tests/error_bounds/rows/rows.h"

namespace underact::error_bounds {
namespace meshes_rows {

/// A coordinate as a file of floats holds it.
double asFloat(double number) {
  return static_cast<double>(static_cast<float>(number));
}
Vec3 asFloats(const Vec3& v) {
  return {asFloat(v.x()), asFloat(v.y()), asFloat(v.z())};
}

/// Three corners: any, collinear except for 2^-k, two of them equal, or in a coordinate plane.
std::array<Vec3, 3> drawTriangle(Input& input, double size, const Vec3& about) {
  const Vec3 a = input.vector("a", [&](Dice& dice) { return asFloats(about + dice.inBox(size)); });
  const Vec3 b = input.vector("b", [&](Dice& dice) {
    return asFloats(dice.one(12) ? a : Vec3(a + (dice.one(4) ? dice.power(-20, 1) : 1.0) * dice.inBox(size)));
  });
  const Vec3 c = input.vector("c", [&](Dice& dice) {
    if (dice.one(3))
      return asFloats(a + dice.between(-1.0, 2.0) * (b - a) + size * dice.closeness() * dice.direction());
    if (dice.one(8)) return b;
    if (dice.one(6)) return asFloats(b + size * dice.closeness() * dice.direction());  // a needle
    return asFloats(a + dice.inBox(size));
  });
  return {a, b, c};
}

/// A point near a corner, an edge or the face, or far away.
Vec3 drawPoint(Input& input, const std::array<Vec3, 3>& corners, double size) {
  return input.vector("q", [&](Dice& dice) {
    const double u = dice.one(3) ? 0.0 : dice.between(-0.5, 1.5), v = dice.one(3) ? 0.0 : dice.between(-0.5, 1.5);
    const Vec3 place = dice.one(4) ? corners[dice.below(3)]
                                   : Vec3(corners[0] + u * (corners[1] - corners[0]) + v * (corners[2] - corners[0]));
    if (dice.one(6)) return dice.oddPointAbout(corners[0], Vec3::UnitX(), size);
    return Vec3(place + (dice.one(2) ? size * dice.closeness() : dice.scale()) * dice.direction());
  });
}

double offAndFarther(const Vec3& p, const Real3& q, const Real& off, const Real& nearest, const Real& scale) {
  if (!p.allFinite()) return kInfinity;
  const Real farther = norm(real(p) - q) - nearest;
  return std::max(ulpsOf(off, scale), ulpsOf(farther > 0 ? farther : Real(0), scale));
}

Outcome judgeTriangle(Input& input) {
  const double size = input.number("size", [](Dice& dice) { return dice.scale(); });
  const std::array<Vec3, 3> corners = drawTriangle(input, size, Vec3::Zero());
  const Vec3 q = drawPoint(input, corners, size);
  // No structured binding: Clang 14 cannot capture its parts in a lambda.
  const Vec3 &a = corners[0], &b = corners[1], &c = corners[2];
  const mesh::OnTriangle got =
      asTheServo([&] { return mesh::onTriangle(a.cast<float>(), b.cast<float>(), c.cast<float>(), q); });
  const Real3 ra = real(a), rb = real(b), rc = real(c), rq = real(q);
  const Real nearest = oracle::onTriangle(ra, rb, rc, rq).distance;
  const Real off = oracle::onTriangle(ra, rb, rc, real(got.p_M)).distance;
  return {offAndFarther(got.p_M, rq, off, nearest, std::max({largestOf(a), largestOf(b), largestOf(c), largestOf(q)})),
          false};
}

Outcome judgeMesh(Input& input) {
  const double size = input.number("size", [](Dice& dice) { return dice.scale(); });
  const std::size_t count = 1 + input.choice("faces", 16);
  const Vec3 about = input.vector(
      "about", [&](Dice& dice) { return dice.one(2) ? Vec3(Vec3::Zero()) : dice.inBox(dice.power(0, 10) * size); });
  mesh::Triangles triangles;
  double largest = 0.0;
  std::array<Vec3, 3> first;
  for (std::size_t face = 0; face < count; ++face) {
    const std::array<Vec3, 3> corners = drawTriangle(input, size, about);
    if (face == 0) first = corners;
    const auto begin = static_cast<std::int32_t>(triangles.p_MV.size());
    for (const Vec3& corner : corners) {
      triangles.p_MV.push_back(corner.cast<float>());
      largest = std::max(largest, largestOf(corner));
    }
    triangles.faces.push_back({begin, begin + 1, begin + 2});
  }
  const Vec3 q = drawPoint(input, first, size);
  const Result<std::shared_ptr<const mesh::Surface>> surface = mesh::makeSurface(triangles);
  if (!surface) return {kInfinity, false};
  const auto search = input.flag("global") ? mesh::Search::Global : mesh::Search::Hybrid;
  mesh::SearchState state;
  const mesh::Hit got = asTheServo([&] { return mesh::nearestPoint(*surface.value(), search, q, state); });
  const Real3 rq = real(q);
  const auto distanceOf = [&](const Real3& p) {
    Real best = -1;
    for (const mesh::Face& face : triangles.faces) {
      const auto corner = [&](std::size_t k) {
        return real(triangles.p_MV[static_cast<std::size_t>(face[k])].cast<double>());
      };
      const Real distance = oracle::onTriangle(corner(0), corner(1), corner(2), p).distance;
      if (best < 0 || distance < best) best = distance;
    }
    return best;
  };
  const double scale = std::max(largest, largestOf(q));
  if (!got.is_proved) {  // sixteen faces are never too many, so only a point can be too far
    const Vec3 extent = (surface.value()->high_M - surface.value()->low_M).cast<double>();
    const bool is_far = scale > 1e5 * extent.norm();
    return {is_far ? ulpsOf(distanceOf(real(got.p_M)), scale) : kInfinity, true};
  }
  return {offAndFarther(got.p_M, rq, distanceOf(real(got.p_M)), distanceOf(rq), scale), false};
}

// 4.5 ulp are the 1e-15 that core/mesh/search.h says.
constexpr const char* kPromise = "ulp of the largest coordinate: off the triangles, farther than the nearest";

constexpr std::array<Row, 2> kRows{{
    {"mesh_triangle", Kind::Shape, "Triangle, slivers and needles among them: nearest point", kPromise, 4.5, 1,
     judgeTriangle},
    {"mesh_nearest", Kind::Shape, "Mesh of 1 to 16 odd triangles: nearest point by the tree", kPromise, 4.5, 12,
     judgeMesh},
}};

}  // namespace meshes_rows

constinit const std::span<const Row> kMeshRows = meshes_rows::kRows;

}  // namespace underact::error_bounds
