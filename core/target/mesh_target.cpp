#include "core/target/mesh_target.h"

#include <cmath>

#include "core/target/target.h"

namespace underact::target {

Target meshTarget(const MeshPlace& place, Side side, const Vec3& p_WT, MeshState& state) noexcept {
  const Vec3 q_M = toMesh(place, p_WT);
  if (side == Side::Both) {
    const mesh::Hit hit = nearestPoint(*place.surface, place.search, q_M, state.search);
    if (hit.face < 0) return {p_WT, Status::Degenerate, 0.0};
    return {toWorkspace(place, hit.p_M), Status::Unique, place.scale_m * std::sqrt(hit.squared)};
  }
  const mesh::Free free = side == Side::Outside ? mesh::Free::Outside : mesh::Free::Inside;
  const mesh::Hit hit = touch(*place.surface, free, q_M, state.touch);
  if (hit.face < 0) return {p_WT, Status::Free, 0.0};
  return {toWorkspace(place, hit.p_M), Status::Unique, place.scale_m * std::sqrt(hit.squared)};
}

Vec3 ontoMesh(const MeshPlace& place, const MeshState& state, const Vec3& p_W) noexcept {
  mesh::SearchState search{state.touch.face >= 0 ? state.touch.face : state.search.face};
  const mesh::Hit hit = nearestPoint(*place.surface, mesh::Search::Local, toMesh(place, p_W), search);
  return hit.face < 0 ? p_W : toWorkspace(place, hit.p_M);
}

}  // namespace underact::target
