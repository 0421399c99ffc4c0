#include "core/mesh/proxy.h"

#include "core/mesh/crossing.h"

namespace underact::mesh {
namespace {

bool isBehind(const Surface& surface, FreeSide free, const Hit& hit, const Vec3& q_M) noexcept UNDERACT_REAL_TIME {
  const double height = (q_M - hit.p_M).dot(outwardAt(surface, hit));
  return free == FreeSide::Outside ? height < 0.0 : height > 0.0;
}

/// The same for a surface with cut faces, by a ray in place of the nearest face.
bool isBehindCut(const Surface& surface, FreeSide free, const Vec3& q_M) noexcept UNDERACT_REAL_TIME {
  return isInside(surface, q_M) == (free == FreeSide::Outside);
}

}  // namespace

Hit followProxy(const Surface& surface, FreeSide free, const Vec3& q_M, ProxyState& state) noexcept {
  Hit hit;
  SearchState search;
  const bool is_held = state.face >= 0, is_first = !is_held && !state.knows_last;
  if (is_held) {
    search.face = state.face;
    hit = nearestPoint(surface, Search::Local, q_M, search);
  } else if (!state.knows_last) {
    hit = nearestPoint(surface, Search::Global, q_M, search);
  } else {
    const CrossingDirection way = free == FreeSide::Outside ? CrossingDirection::Inwards : CrossingDirection::Outwards;
    search.face = firstCrossing(surface, way, state.q_M, q_M).face;
    if (search.face >= 0) hit = nearestPoint(surface, Search::Local, q_M, search);
  }
  if (hit.face >= 0) {
    bool is_behind = isBehind(surface, free, hit, q_M);
    // The end of a contact, and a first tip, are checked a second time.
    if (surface.is_united && (is_first || !is_behind)) is_behind = isBehindCut(surface, free, q_M);
    if (!is_behind) hit.face = -1;
  }
  state = {hit.face, true, q_M};
  return hit;
}

}  // namespace underact::mesh
