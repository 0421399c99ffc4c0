#include <array>
#include <cmath>

#include "core/base/trig.h"
#include "core/base/types.h"
#include "scenes/meshes/make/meshes.h"

namespace underact::mesh_maker {
namespace {

constexpr double kTurn = 6.283185307179586;
constexpr double kLengthToGirth = 402.3 / (kTurn * kKnotTube_mm);  // of the tube, so that its triangles are even

/// A place on the knot's curve, and two unit vectors across it: away from the torus, which the curve lies on, and
/// aside.
struct Station {
  Vec3 p_MC, away_M, aside_M;
};

Station stationAt(double share) {
  const SinCos about = sinCos(2.0 * kTurn * share), around = sinCos(3.0 * kTurn * share);
  const Vec3 radial_M(about.cos, about.sin, 0.0), ahead_M(-about.sin, about.cos, 0.0);
  const double ring_mm = kKnotRing_mm + kKnotWinding_mm * around.cos;
  const Vec3 away_M = around.cos * radial_M - around.sin * Vec3::UnitZ();
  const Vec3 tangent_M =
      2.0 * ring_mm * ahead_M - 3.0 * kKnotWinding_mm * (around.sin * radial_M + around.cos * Vec3::UnitZ());
  return {ring_mm * radial_M - kKnotWinding_mm * around.sin * Vec3::UnitZ(), away_M,
          tangent_M.cross(away_M).normalized()};
}

}  // namespace

Triangles torusKnot(int faces) {
  const int girth = std::max(3, static_cast<int>(std::lround(std::sqrt(0.5 * faces / kLengthToGirth))));
  const int length = std::max(32, static_cast<int>(std::lround(0.5 * faces / girth)));
  Triangles made;
  for (int i = 0; i < length; ++i) {
    const Station at = stationAt(static_cast<double>(i) / length);
    for (int j = 0; j < girth; ++j) {
      const SinCos turn = sinCos(kTurn * j / girth);
      made.p_MV.emplace_back((at.p_MC + kKnotTube_mm * (turn.cos * at.away_M + turn.sin * at.aside_M)).cast<float>());
    }
  }
  const auto corner = [&](int i, int j) { return (i % length) * girth + j % girth; };
  for (int i = 0; i < length; ++i) {
    for (int j = 0; j < girth; ++j) {
      made.faces.push_back({corner(i, j), corner(i, j + 1), corner(i + 1, j + 1)});
      made.faces.push_back({corner(i, j), corner(i + 1, j + 1), corner(i + 1, j)});
    }
  }
  return made;
}

}  // namespace underact::mesh_maker
