#include "core/target/mesh_target.h"

#include <cmath>

#include "core/base/valid_bytes.h"

namespace underact::target {
namespace {

/// The point of the surface near p_W, from the face that the target is on.
mesh::Hit alongSurface(const MeshPlace& place, const MeshState& state, const Vec3& p_W) noexcept UNDERACT_REAL_TIME {
  mesh::SearchState search{state.touch.face >= 0 ? state.touch.face : state.search.face};
  return nearestPoint(*place.surface, mesh::Search::Local, toMesh(place, p_W), search);
}

}  // namespace

bool isValid(const MeshState& state, const mesh::Surface& surface) noexcept {
  const std::size_t faces = surface.triangles.faces.size();
  const auto isFace = [faces](std::int32_t face) { return face >= -1 && face < static_cast<std::int64_t>(faces); };
  return isFace(state.search.face) && isFace(state.touch.face) && isFlag(state.touch.knows_last) &&
         state.search.cut.size <= mesh::Cut::kMax;  // each search looks at its nodes before using them
}

Target meshTarget(const MeshPlace& place, Side side, const Vec3& p_WT, MeshState& state) noexcept {
  const Vec3 q_M = toMesh(place, p_WT);
  if (side == Side::Both) {
    const mesh::Hit hit = nearestPoint(*place.surface, place.search, q_M, state.search);
    if (hit.face < 0) return {p_WT, Status::Degenerate, 0.0};
    return {toWorkspace(place, hit.p_M), Status::Unique, std::abs(place.scale_m) * std::sqrt(hit.squared)};
  }
  const mesh::FreeSide free = side == Side::Outside ? mesh::FreeSide::Outside : mesh::FreeSide::Inside;
  const mesh::Hit hit = followProxy(*place.surface, free, q_M, state.touch);
  if (hit.face < 0) return {p_WT, Status::Free, 0.0};
  return {toWorkspace(place, hit.p_M), Status::Unique, std::abs(place.scale_m) * std::sqrt(hit.squared)};
}

Vec3 ontoMesh(const MeshPlace& place, const MeshState& state, const Vec3& p_W) noexcept {
  const mesh::Hit hit = alongSurface(place, state, p_W);
  return hit.face < 0 ? p_W : toWorkspace(place, hit.p_M);
}

Vec3 shadingOffset(const MeshPlace& place, const MeshState& state, const Vec3& p_WT, const Vec3& p_WP) noexcept {
  const Vec3 offset_W = p_WT - p_WP;
  const double length_m = offset_W.norm();
  if (!place.lean.isThere() || !(length_m > 0.0)) return Vec3::Zero();
  // A scale below 0 reflects both directions, so the displacement along the surface is the same.
  const Vec3 u_M = place.R_WM.transpose() * (offset_W / length_m);
  const Vec3 leaning_M = shadedDirection(*place.surface, alongSurface(place, state, p_WT), u_M, place.lean);
  return length_m * (place.R_WM * (u_M - leaning_M));
}

}  // namespace underact::target
