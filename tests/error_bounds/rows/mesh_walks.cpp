#include <algorithm>
#include <array>
#include <memory>
#include <set>
#include <utility>
#include <vector>

#include "core/base/norms.h"
#include "core/mesh/proxy.h"
#include "core/mesh/search.h"
#include "tests/error_bounds/oracle/shapes.h"
#include "tests/error_bounds/rows/rows.h"

// Searches along a mesh from the last result: local ones, and the proxies of walls.
namespace underact::error_bounds {
namespace mesh_walks_rows {

using mesh::Part;
using mesh::Surface;
using oracle::Nearest;

constexpr double kPromise_ulp = 4.5;  // the 1e-15 that core/mesh/search.h says

double largestIn(const Surface& surface) {
  return std::max(largestOf(surface.low_M.cast<double>()), largestOf(surface.high_M.cast<double>()));
}
double extentOf(const Surface& surface) {
  return (surface.high_M - surface.low_M).cast<double>().norm();
}

Nearest onFace(const Surface& surface, std::int32_t face, const Real3& p) {
  const mesh::Corners at = cornersOf(surface, face);
  return oracle::onTriangle(real(at.a), real(at.b), real(at.c), p);
}

std::int32_t facesOf(const Surface& surface) {
  return static_cast<std::int32_t>(surface.triangles.faces.size());
}

/// Whether a face has all the corners of the part of another one.
bool meets(const Surface& surface, std::int32_t face, std::int32_t other, Part part) {
  if (face == other) return true;
  if (part == Part::Inside) return false;
  const mesh::Face& of = surface.triangles.faces[static_cast<std::size_t>(face)];
  const mesh::Face& in = surface.triangles.faces[static_cast<std::size_t>(other)];
  const auto has = [&in](std::int32_t corner) { return in[0] == corner || in[1] == corner || in[2] == corner; };
  if (part >= Part::CornerA) return has(of[static_cast<std::size_t>(part) - static_cast<std::size_t>(Part::CornerA)]);
  const std::size_t side = static_cast<std::size_t>(part) - static_cast<std::size_t>(Part::EdgeAB);
  return has(of[side]) && has(of[(side + 1) % 3]);
}

/// The end of a walk: on the stated face, no farther than its beginning, nor than any face that meets it there. from
/// -1: it has no beginning.
double judgeEnd(const Surface& surface, std::int32_t face, const mesh::Hit& hit, std::int32_t from, const Vec3& q) {
  if (!hit.p_M.allFinite() || face < 0 || face >= facesOf(surface)) return kInfinity;
  const Real scale = std::max(largestIn(surface), largestOf(q));
  const Real3 rq = real(q), p = real(hit.p_M);
  const Real distance = norm(p - rq);
  double worst =
      std::max(ulpsOf(onFace(surface, face, p).distance, scale), ulpsOf(std::sqrt(hit.squared), distance, scale));
  for (std::int32_t other = 0; other < facesOf(surface); ++other) {
    if (other != from && !meets(surface, face, other, hit.part)) continue;
    const Real farther = distance - onFace(surface, other, rq).distance;
    if (farther > 0) worst = std::max(worst, ulpsOf(farther, scale));
  }
  return worst;
}

/// The distance of q from the common part of two faces: an edge, a corner (or all); -1: none.
Real toShared(const Surface& surface, std::int32_t face, std::int32_t other, const Real3& q) {
  const mesh::Face& in = surface.triangles.faces[static_cast<std::size_t>(other)];
  std::vector<Real3> shared;
  for (const std::int32_t corner : surface.triangles.faces[static_cast<std::size_t>(face)]) {
    if (std::find(in.begin(), in.end(), corner) == in.end()) continue;
    shared.push_back(real(surface.triangles.p_MV[static_cast<std::size_t>(corner)].cast<double>()));
  }
  if (shared.empty()) return -1;
  return oracle::onTriangle(shared.front(), shared[shared.size() / 2], shared.back(), q).distance;
}

/// Whether a walk from face to face over their common parts, only ever to nearer faces, can end at p, where no point of
/// the face is nearer to q: within rounding.
bool isReached(const Surface& surface, std::vector<std::int32_t> from, const Vec3& p, const Vec3& q) {
  const Real rounding = ldexp(Real(std::max(largestIn(surface), largestOf(q))), -46);
  const Real3 rq = real(q), end = real(p);
  std::vector<bool> seen(surface.triangles.faces.size(), false);
  while (!from.empty()) {
    const std::int32_t face = from.back();
    from.pop_back();
    if (seen[static_cast<std::size_t>(face)]) continue;
    seen[static_cast<std::size_t>(face)] = true;
    if (onFace(surface, face, end).distance <= rounding) return true;
    const Real max = onFace(surface, face, rq).distance + rounding;
    for (std::int32_t other = 0; other < facesOf(surface); ++other) {
      if (seen[static_cast<std::size_t>(other)]) continue;
      const Real shared = toShared(surface, face, other, rq);
      if (shared >= 0 && shared <= max && onFace(surface, other, rq).distance <= max) from.push_back(other);
    }
  }
  return false;
}

/// Whether q is so far away that the search moves it nearer, and promises only a point of the mesh.
bool isFar(const Surface& surface, const Vec3& q) {
  return std::max(largestIn(surface), largestOf(q)) > 1e5 * extentOf(surface);
}

/// A sheet of 2 to 4 by 2 to 4 corners, bent, crumpled and with needles, and a second, separate one beside it.
mesh::Triangles drawSheets(Input& input, double size) {
  mesh::Triangles sheets;
  const std::size_t columns = 2 + input.choice("columns", 3), rows = 2 + input.choice("rows", 3);
  for (std::size_t i = 0; i < columns * rows; ++i) {
    const Vec3 place = size * Vec3(static_cast<double>(i % columns), static_cast<double>(i / columns), 0.0);
    const Vec3 p = input.vector("p", [&](Dice& dice) -> Vec3 {
      if (i > 0 && dice.one(8)) return sheets.p_MV.back().cast<double>() + size * dice.closeness() * dice.direction();
      return place + size * dice.inBox(dice.one(2) ? 0.4 : std::abs(dice.closeness()));
    });
    sheets.p_MV.push_back(p.cast<float>());
  }
  const Vec3 apart =
      input.vector("apart", [&](Dice& dice) { return Vec3(size * dice.closeness() * dice.direction()); });
  for (std::size_t i = 0; i < columns * rows; ++i)
    sheets.p_MV.push_back((sheets.p_MV[i].cast<double>() + apart).cast<float>());
  for (const std::size_t first : {std::size_t{0}, columns * rows}) {
    for (std::size_t i = 0; i + columns < columns * rows; ++i) {
      if (i % columns + 1 == columns) continue;
      const auto at = [&](std::size_t corner) { return static_cast<std::int32_t>(first + corner); };
      sheets.faces.push_back({at(i), at(i + 1), at(i + columns)});
      sheets.faces.push_back({at(i + 1), at(i + columns + 1), at(i + columns)});
    }
  }
  return sheets;
}

Vec3 drawTip(Input& input, const Surface& surface, double size) {
  return input.vector("q", [&](Dice& dice) {
    const Eigen::Vector3f& near = surface.triangles.p_MV[dice.below(surface.triangles.p_MV.size())];
    if (dice.one(6)) return dice.oddPointAbout(near.cast<double>(), Vec3::UnitZ(), size);
    return Vec3(near.cast<double>() + size * (dice.one(3) ? dice.closeness() : 3.0) * dice.inBox(1.0));
  });
}

Outcome judgeLocal(Input& input) {
  const double size = input.number("size", [](Dice& dice) { return dice.scale(); });
  const mesh::Triangles sheets = drawSheets(input, size);
  const auto made = mesh::makeSurface(sheets);
  if (!made) return {kInfinity, false};
  const Surface& surface = *made.value();
  const auto from = static_cast<std::int32_t>(input.choice("from", static_cast<std::size_t>(facesOf(surface))));
  const Vec3 q = drawTip(input, surface, size);
  mesh::SearchState state{from};
  const mesh::Hit got = asTheServo([&] { return nearestPoint(surface, mesh::Search::Local, q, state); });
  if (isFar(surface, q)) {
    const bool is_on = got.p_M.allFinite() && got.face >= 0 && got.face < facesOf(surface);
    return {is_on ? ulpsOf(onFace(surface, got.face, real(got.p_M)).distance, largestOf(q)) : kInfinity, true};
  }
  const double worst = judgeEnd(surface, got.face, got, from, q);
  return {std::isfinite(worst) && isReached(surface, {from}, got.p_M, q) ? worst : kInfinity, false};
}

/// Two apices above and below a ring of 3 to 8 corners: closed and star-shaped, as thin as a plate of 2^-8.
mesh::Triangles drawSolid(Input& input, double size) {
  const Mat3 R = input.matrix("R", [](Dice& dice) { return dice.turn(); });
  const Vec3 middle = input.vector(
      "about", [&](Dice& dice) { return dice.one(2) ? Vec3(Vec3::Zero()) : dice.inBox(dice.power(0, 4) * size); });
  const std::size_t count = 3 + input.choice("ring", 6);
  const auto drawHeight = [&](const char* name) {
    return size * input.number(name, [](Dice& dice) { return dice.one(2) ? dice.power(-8, 0) : 1.0; });
  };
  const double over = drawHeight("over"), under = drawHeight("under");
  mesh::Triangles solid;
  solid.p_MV.push_back((middle + over * R.col(2)).cast<float>());
  solid.p_MV.push_back((middle - under * R.col(2)).cast<float>());
  for (std::size_t i = 0; i < count; ++i) {
    const double angle = 2.0 * kPi * static_cast<double>(i) / static_cast<double>(count);
    const SinCos turn = sinCos(angle);
    const double radius = size * input.number("radius", [](Dice& dice) { return dice.between(0.3, 1.0); });
    solid.p_MV.push_back((middle + radius * (turn.cos * R.col(0) + turn.sin * R.col(1))).cast<float>());
  }
  for (std::size_t i = 0; i < count; ++i) {
    const auto here = static_cast<std::int32_t>(2 + i), next = static_cast<std::int32_t>(2 + (i + 1) % count);
    solid.faces.push_back({0, here, next});
    solid.faces.push_back({1, next, here});
  }
  return solid;
}

/// Whether q is inside of a closed surface.
bool isInside(const Surface& surface, const Real3& q) {
  Real turns = 0;
  for (std::int32_t face = 0; face < facesOf(surface); ++face) {
    const mesh::Corners at = cornersOf(surface, face);
    turns += oracle::shareOfSphere(real(at.a), real(at.b), real(at.c), q);
  }
  return turns > Real(0.5);
}

Real toSurface(const Surface& surface, const Real3& q) {
  Real best = onFace(surface, 0, q).distance;
  for (std::int32_t face = 1; face < facesOf(surface); ++face) best = std::min(best, onFace(surface, face, q).distance);
  return best;
}

/// A wall over a sequence of ticks, as seen by the oracle.
class WallWatch {
 public:
  WallWatch(const Surface& surface, mesh::FreeSide free, double size) : surface_(surface), free_(free), size_(size) {}

  /// The error in this tick. before, after: the wall's state; hit: its result.
  double judge(const mesh::ProxyState& before, const mesh::ProxyState& after, const mesh::Hit& hit, const Vec3& q) {
    const Real3 rq = real(q);
    const Real off = toSurface(surface_, rq);
    const bool is_sure = off > ldexp(Real(size_), -24), is_barred = isBarred(rq);
    const bool came_through = knows_free_ && is_sure && is_barred;
    knows_free_ = is_sure && !is_barred && after.face < 0;
    if (after.face != hit.face) return kInfinity;
    if (hit.squared == kInfinity) return came_through ? kInfinity : 0.0;  // it was free, and passed through no face
    const Real scale = std::max(largestIn(surface_), largestOf(q));
    const Real farther = norm(real(hit.p_M) - rq) - off;
    double worst = hit.face >= 0 ? judgeEnd(surface_, hit.face, hit, before.face, q)
                                 : ulpsOf(toSurface(surface_, real(hit.p_M)), scale);
    if (!before.knows_last) {  // the nearest of all, so that the wall is touched where it is passed
      worst = std::max(worst, farther > 0 ? ulpsOf(farther, scale) : 0.0);
      return is_sure && (hit.face >= 0) != is_barred ? kInfinity : worst;
    }
    const std::vector<std::int32_t> from =
        before.face >= 0 ? std::vector{before.face} : facesEntered(before.q_M, q, scale);
    if (!from.empty() && !isReachedOverGaps(from, hit.p_M, q, scale)) return kInfinity;
    return isWrongSide(hit, rq, scale) ? kInfinity : worst;
  }

 private:
  bool isBarred(const Real3& q) const { return isInside(surface_, q) == (free_ == mesh::FreeSide::Outside); }

  /// The faces through which the straight path from q to r may first enter the barred side: the first one that it meets
  /// well inside, and those before it whose edges it meets, where rounding decides. A tip that rests on a face, within
  /// 1e-12 of the coordinates, may have passed through it or not.
  std::vector<std::int32_t> facesEntered(const Vec3& q, const Vec3& r, const Real& scale) const {
    const Real3 begin = real(q), heading = real(r) - begin;
    const Real resting = ldexp(scale, -38), length = norm(heading);
    std::vector<std::pair<Real, std::int32_t>> met;
    Real first = 2 * length + resting;
    for (std::int32_t face = 0; face < facesOf(surface_); ++face) {
      const mesh::Corners at = cornersOf(surface_, face);
      const Real3 a = real(at.a), b = real(at.b), c = real(at.c), normal = cross(b - a, c - a);
      const Real along = dot(heading, normal);
      if (!(free_ == mesh::FreeSide::Outside ? along < 0 : along > 0)) continue;
      const Real share = dot(a - begin, normal) / along, gone = share * length;
      const Real3 there = begin + share * heading;
      if (gone < -resting || gone > length + resting || onFace(surface_, face, there).distance > resting) continue;
      met.emplace_back(gone, face);
      const Real inside = std::min({oracle::onSegment(a, b, there).distance, oracle::onSegment(b, c, there).distance,
                                    oracle::onSegment(c, a, there).distance});
      if (gone > resting && inside > resting) first = std::min(first, gone);
    }
    std::vector<std::int32_t> entered;
    for (const auto& [gone, face] : met) {
      if (gone <= first) entered.push_back(face);
    }
    return entered;
  }

  /// Whether the proxy is reached on the surface from these faces, or from the walls that stop a proxy on its straight
  /// way to the tip where it has fallen off an edge.
  bool isReachedOverGaps(std::vector<std::int32_t> from, const Vec3& p, const Vec3& q, const Real& scale) const {
    constexpr int kMaxWalls = 8;
    for (int walls = 0; walls <= kMaxWalls && !from.empty(); ++walls) {
      if (isReached(surface_, from, p, q)) return true;
      std::set<std::int32_t> next;
      for (const std::int32_t face : from) {
        mesh::SearchState search{face};
        const Vec3 end = nearestPoint(surface_, mesh::Search::Local, q, search).p_M;
        for (const std::int32_t wall : facesEntered(end, q, scale)) next.insert(wall);
      }
      from.assign(next.begin(), next.end());
    }
    return false;
  }

  /// Whether a point slightly off the proxy towards the tip is on the wrong side: it must be barred exactly if the wall
  /// is touched. Not tested where the tip is at the proxy, or another part of the surface is equally near.
  bool isWrongSide(const mesh::Hit& hit, const Real3& q, const Real& scale) const {
    const Real3 p = real(hit.p_M), heading = q - p;
    const Real little = ldexp(Real(size_), -24), rounding = ldexp(scale, -46);
    if (norm(heading) < 2 * little) return false;
    for (std::int32_t face = 0; face < facesOf(surface_); ++face) {
      const Real off = onFace(surface_, face, p).distance;
      if (off > rounding && off < 4 * little) return false;
    }
    return isBarred(p + Real(little / norm(heading)) * heading) != (hit.face >= 0);
  }

  const Surface& surface_;
  mesh::FreeSide free_;
  double size_;
  bool knows_free_ = false;  // the last tip was certainly on the free side, and touched nothing
};

Outcome judgeWall(Input& input) {
  constexpr int kTicks = 8;
  const double size = input.number("size", [](Dice& dice) { return dice.scale(); });
  const mesh::Triangles solid = drawSolid(input, size);
  const auto made = mesh::makeSurface(solid);
  if (!made || !made.value()->is_closed) return {kInfinity, false};
  const Surface& surface = *made.value();
  const mesh::FreeSide free = input.flag("inside") ? mesh::FreeSide::Inside : mesh::FreeSide::Outside;
  const Vec3 middle = 0.5 * (surface.low_M + surface.high_M).cast<double>();
  mesh::ProxyState state;
  WallWatch watch(surface, free, size);
  double worst = 0.0;
  for (int tick = 0; tick < kTicks; ++tick) {
    const Vec3 q = input.vector("q", [&](Dice& dice) -> Vec3 {
      const Vec3 corner = surface.triangles.p_MV[dice.below(surface.triangles.p_MV.size())].cast<double>();
      if (dice.one(4)) return corner + size * dice.closeness() * dice.direction();
      if (dice.one(3)) return middle + size * dice.inBox(3.0);
      return middle + dice.between(-0.2, 1.2) * (corner - middle) + 0.1 * size * dice.inBox(1.0);
    });
    const mesh::ProxyState before = state;
    const mesh::Hit hit = asTheServo([&] { return followProxy(surface, free, q, state); });
    worst = std::max(worst, watch.judge(before, state, hit, q));
  }
  return {worst, false};
}

constexpr std::array<Row, 2> kRows{{
    {"mesh_local", Kind::Shape, "Two crumpled sheets beside each other, searched along one from any face",
     "ulp of the largest coordinate: off its face, farther than the first face and those that meet the last; reached "
     "from face to face, each nearer",
     kPromise_ulp, 8, judgeLocal},
    {"mesh_wall", Kind::Shape, "Wall of a closed mesh, plates among them: proxy over 8 ticks to anywhere",
     "ulp of the same, from where it was or came in; touched where the tip is behind it, and whenever the tip came "
     "through the wall",
     kPromise_ulp, 80, judgeWall},
}};

}  // namespace mesh_walks_rows

constinit const std::span<const Row> kMeshWalkRows = mesh_walks_rows::kRows;

}  // namespace underact::error_bounds
