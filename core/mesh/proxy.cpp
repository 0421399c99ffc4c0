#include "core/mesh/proxy.h"

#include <algorithm>

#include "core/base/norms.h"
#include "core/mesh/crossing.h"

namespace underact::mesh {
namespace {

bool isBehind(const Surface& surface, FreeSide free, const Hit& hit, const Vec3& q_M) noexcept UNDERACT_REAL_TIME {
  const double height = (q_M - hit.p_M).dot(outwardAt(surface, hit));
  return free == FreeSide::Outside ? height < 0.0 : height > 0.0;
}

/// isBehind() by a ray in place of the nearest face.
bool isBehindByRay(const Surface& surface, FreeSide free, const Vec3& q_M) noexcept UNDERACT_REAL_TIME {
  return isInside(surface, q_M) == (free == FreeSide::Outside);
}

/// Where a path comes through the wall from its free side.
Crossing firstWall(const Surface& surface, FreeSide free, const Vec3& from_M,
                   const Vec3& to_M) noexcept UNDERACT_REAL_TIME {
  const CrossingDirection direction =
      free == FreeSide::Outside ? CrossingDirection::Inwards : CrossingDirection::Outwards;
  return firstCrossing(surface, direction, from_M, to_M);
}

Hit alongFrom(const Surface& surface, std::int32_t face, const Vec3& q_M) noexcept UNDERACT_REAL_TIME {
  SearchState search{face};
  return nearestPoint(surface, Search::Local, q_M, search);
}

/// Whether a tip is on the surface within the rounding of its coordinates, where a ray may say either.
bool isOnIt(const Surface& surface, const Hit& hit) noexcept UNDERACT_REAL_TIME {
  constexpr double kRounding = 1e-12;
  const double within =
      kRounding * std::max(largestOf(surface.low_M.cast<double>()), largestOf(surface.high_M.cast<double>()));
  return hit.squared <= within * within;
}

/// Whether the tip stays behind the wall, which is the surface anywhere and not only where the proxy was: a proxy that
/// falls off an edge into a gap goes straight to the tip, is stopped by the opposite wall, and slides on there. hit:
/// the proxy, which moves, and never away from the tip. The faces that meet where it is are not in its way. From an
/// edge or a corner, or where faces were cut, a tip that no face is in the way of is free only if a ray confirms it,
/// since rounding, or the end of a walk halfway, may hide a face there.
bool staysBehind(const Surface& surface, FreeSide free, const Vec3& q_M, Hit& hit) noexcept UNDERACT_REAL_TIME {
  constexpr int kMaxWalls = 8;            // that a proxy falls on in a tick; past them it is held by the last one
  constexpr double kNearer = 1.0 - 1e-9;  // by less it is the same point, on another face there
  constexpr double kBegin = 1e-6;         // of the way to the tip: it is past the faces that meet there
  for (int walls = 0; !isBehind(surface, free, hit, q_M); ++walls) {
    if (isOnIt(surface, hit)) return false;
    if (walls == kMaxWalls) return true;
    // A path from within a face has all others ahead.
    const bool is_within = hit.part == Part::Inside;
    const Crossing wall = firstWall(surface, free, is_within ? hit.p_M : Vec3(hit.p_M + kBegin * (q_M - hit.p_M)), q_M);
    if (wall.face < 0 && !wall.is_whole) return true;
    if (wall.face < 0 && is_within && !surface.is_united) return false;
    const Hit next = wall.face >= 0 ? alongFrom(surface, wall.face, q_M) : Hit{};
    if (!(next.squared < kNearer * hit.squared)) return isBehindByRay(surface, free, q_M);
    hit = next;
  }
  return true;
}

}  // namespace

Hit followProxy(const Surface& surface, FreeSide free, const Vec3& q_M, ProxyState& state) noexcept {
  Hit hit;
  const bool is_held = state.face >= 0, is_first = !is_held && !state.knows_last;
  if (is_held) {
    hit = alongFrom(surface, state.face, q_M);
  } else if (is_first) {
    SearchState search;
    hit = nearestPoint(surface, Search::Global, q_M, search);
  } else if (const Crossing wall = firstWall(surface, free, state.q_M, q_M); wall.face >= 0) {
    hit = alongFrom(surface, wall.face, q_M);
  }
  if (hit.face >= 0) {
    bool is_behind = false;
    if (is_first) {
      // Of cut faces, either of two that nearly touch may be in front.
      is_behind = surface.is_united ? isBehindByRay(surface, free, q_M) : isBehind(surface, free, hit, q_M);
    } else {
      is_behind = staysBehind(surface, free, q_M, hit);
    }
    if (!is_behind) hit.face = -1;
  }
  state = {hit.face, true, q_M};
  return hit;
}

}  // namespace underact::mesh
