#include "core/mesh/force_shading.h"

#include <algorithm>
#include <cmath>

#include "core/base/trig.h"
#include "core/mesh/around_part.h"
#include "core/mesh/normals.h"

namespace underact::mesh {
namespace {

/// The unit vector, or `otherwise` for one without a length.
Vec3 unitOr(const Vec3& v, const Vec3& otherwise) noexcept UNDERACT_REAL_TIME {
  const double length = v.norm();
  return length > 0.0 ? Vec3(v / length) : otherwise;
}

/// The weight of a face's normal at its corner at `place`: the sine of the angle there over the lengths of the sides,
/// which needs no arc tangent. Source: Max 1999, Weights for computing vertex normals from facet normals.
double weightOf(const Surface& surface, std::int32_t face, std::size_t place) noexcept UNDERACT_REAL_TIME {
  const auto [a, b, c] = cornersOf(surface, face);
  const std::array<Vec3, 3> p{a, b, c};
  const Vec3 to_next = p[(place + 1) % 3] - p[place], to_last = p[(place + 2) % 3] - p[place];
  const double lengths = to_next.squaredNorm() * to_last.squaredNorm();
  return lengths > 0.0 ? to_next.cross(to_last).norm() / lengths : 0.0;
}

/// Corners with more faces than this are not smoothed.
constexpr int kMaxAround = 64;

/// Calls poll(face, its normal) for the faces around the corner at `place` up to the next sharp edges, beginning with
/// the given one, whose normal is own_M. Faces without an area make no sharp edge and are skipped.
struct Around {
  bool has_sharp = false;  // a sharp edge ends there
  bool is_whole = true;    // false: too many faces, not all were looked at
};
template <class Visit>
Around visitNeighbours(const Surface& surface, std::int32_t face, const Vec3& own_M, std::size_t place,
                       const ForceShading& max, const Visit& visit) noexcept UNDERACT_REAL_TIME {
  const std::int32_t corner = surface.triangles.faces[static_cast<std::size_t>(face)][place];
  visit(face, own_M);
  Around around;
  int count = 0;
  for (std::size_t turn = 0; turn < 2; ++turn) {
    std::int32_t at = face;
    Vec3 last_M = own_M;
    for (;;) {
      // Of a face whose corner this is at place k, side k leaves it and side k - 1 comes to it.
      const std::size_t here = placeOf(surface.triangles.faces[static_cast<std::size_t>(at)], corner);
      at = surface.neighbours[static_cast<std::size_t>(at)][turn == 0 ? here : (here + 2) % 3];
      if (at == face) return around;  // completely around
      if (at < 0) break;
      if (++count > kMaxAround) {
        around.is_whole = false;
        return around;
      }
      const Vec3 normal_M = normalOf(surface, at);
      if (normal_M == Vec3::Zero()) continue;
      const bool is_sharp = last_M != Vec3::Zero() && normal_M.dot(last_M) < max.cos;
      around.has_sharp = around.has_sharp || is_sharp;
      if (is_sharp) break;
      visit(at, normal_M);
      last_M = normal_M;
    }
  }
  return around;
}

struct Round {
  Vec3 normal_M = Vec3::Zero();  // unit, or zero
  bool is_sharp = false;         // a sharp edge ends there, or there are too many faces
};

Round aroundCorner(const Surface& surface, std::int32_t face, const Vec3& own_M, std::size_t place,
                   const ForceShading& max) noexcept UNDERACT_REAL_TIME {
  const std::int32_t corner = surface.triangles.faces[static_cast<std::size_t>(face)][place];
  Vec3 sum = Vec3::Zero();
  const Around around = visitNeighbours(surface, face, own_M, place, max,
                                        [&](std::int32_t at, const Vec3& normal_M) noexcept UNDERACT_REAL_TIME {
                                          const Face& corners = surface.triangles.faces[static_cast<std::size_t>(at)];
                                          sum += weightOf(surface, at, placeOf(corners, corner)) * normal_M;
                                        });
  return {around.is_whole ? unitOr(sum, own_M) : own_M, around.has_sharp || !around.is_whole};
}

/// The least component of the faces' normals along that of the corner: no direction between them has less.
double lowestAround(const Surface& surface, std::int32_t face, const Vec3& own_M, std::size_t place,
                    const Vec3& normal_M, const ForceShading& max) noexcept UNDERACT_REAL_TIME {
  double lowest = 1.0;
  (void)visitNeighbours(surface, face, own_M, place, max,
                        [&](std::int32_t /*at*/, const Vec3& of_face_M) noexcept UNDERACT_REAL_TIME {
                          if (of_face_M != Vec3::Zero()) lowest = std::min(lowest, of_face_M.dot(normal_M));
                        });
  return lowest;
}

struct Shading {
  Vec3 true_M = Vec3::Zero(), smooth_M = Vec3::Zero();  // unit; zero: a face without an area
};

/// The shading of a face at its point p.
Shading shadingOf(const Surface& surface, std::int32_t face, const Vec3& p_M,
                  const ForceShading& max) noexcept UNDERACT_REAL_TIME {
  const auto [a, b, c] = cornersOf(surface, face);
  const Vec3 true_M = normalOf(surface, face);
  // Twice the areas into which p divides the face, each opposite its corner.
  const std::array<double, 3> areas{areaNormal(p_M, b, c).dot(true_M), areaNormal(a, p_M, c).dot(true_M),
                                    areaNormal(a, b, p_M).dot(true_M)};
  Vec3 sum = Vec3::Zero();
  for (std::size_t k = 0; k < 3; ++k)
    sum += std::max(areas[k], 0.0) * aroundCorner(surface, face, true_M, k, max).normal_M;
  return {true_M, unitOr(sum, true_M)};
}

/// Over an edge the true direction changes from one face's normal to the other's: a sum of both with the weights alpha
/// and beta; the smooth normals replace them in it. At a border only the one face counts; beside a face without an area
/// the corners of the other one determine it.
Vec3 overEdge(const Surface& surface, const Hit& hit, const Vec3& u_M,
              const ForceShading& max) noexcept UNDERACT_REAL_TIME {
  const std::size_t side = static_cast<std::size_t>(hit.part) - static_cast<std::size_t>(Part::EdgeAB);
  const std::int32_t other = surface.neighbours[static_cast<std::size_t>(hit.face)][side];
  const Shading here = shadingOf(surface, hit.face, hit.p_M, max);
  const double a = u_M.dot(here.true_M);
  if (other < 0) return u_M + a * (here.smooth_M - here.true_M);
  const Shading there = shadingOf(surface, other, hit.p_M, max);
  const double b = u_M.dot(there.true_M), c = here.true_M.dot(there.true_M), sine_squared = 1.0 - c * c;
  if (there.true_M == Vec3::Zero()) return std::copysign(1.0, a) * here.smooth_M;
  if (here.true_M == Vec3::Zero()) return std::copysign(1.0, b) * there.smooth_M;
  constexpr double kFlat = 1e-12;  // of a squared sine: the two faces are coplanar
  const double alpha = sine_squared > kFlat ? (a - b * c) / sine_squared : 0.5 * a;
  const double beta = sine_squared > kFlat ? (b - a * c) / sine_squared : 0.5 * b;
  return u_M + alpha * (here.smooth_M - here.true_M) + beta * (there.smooth_M - there.true_M);
}

/// At a corner without a sharp edge: its normal. A direction with a smaller component along it than every face's normal
/// is beside the corner of a border, and fades to itself: there the tip is on no side of the surface.
Vec3 atCorner(const Surface& surface, const Hit& hit, const Vec3& u_M,
              const ForceShading& max) noexcept UNDERACT_REAL_TIME {
  constexpr double kHalfRight = 0.7071;
  const std::size_t place = static_cast<std::size_t>(hit.part) - static_cast<std::size_t>(Part::CornerA);
  const Vec3 own_M = normalOf(surface, hit.face);
  const Round round = aroundCorner(surface, hit.face, own_M, place, max);
  if (round.is_sharp) return u_M;
  const double lowest = std::min(kHalfRight, lowestAround(surface, hit.face, own_M, place, round.normal_M, max));
  if (!(lowest > 0.0)) return u_M;
  const double height = u_M.dot(round.normal_M), share = std::min(1.0, std::abs(height) / lowest);
  return (1.0 - share) * u_M + std::copysign(share, height) * round.normal_M;
}

}  // namespace

ForceShading forceShadingOf(double max_rad) {
  const SinCos max = sinCos(max_rad);
  return {max.cos, max.sin};
}

Vec3 shadedDirection(const Surface& surface, const Hit& hit, const Vec3& u_M, const ForceShading& max) noexcept {
  if (hit.face < 0 || !max.isThere()) return u_M;
  Vec3 wanted_M = u_M;
  if (hit.part == Part::Inside) {
    const Shading here = shadingOf(surface, hit.face, hit.p_M, max);
    wanted_M = u_M.dot(here.true_M) < 0.0 ? Vec3(-here.smooth_M) : here.smooth_M;
  } else {
    wanted_M = hit.part < Part::CornerA ? overEdge(surface, hit, u_M, max) : atCorner(surface, hit, u_M, max);
  }
  wanted_M = unitOr(wanted_M, u_M);
  const double cosine = wanted_M.dot(u_M);
  if (cosine >= max.cos) return wanted_M;
  const Vec3 across_M = unitOr(wanted_M - cosine * u_M, Vec3::Zero());
  return unitOr(max.cos * u_M + max.sin * across_M, u_M);
}

}  // namespace underact::mesh
