#pragma once
#include <memory>

#include "core/base/real_time.h"
#include "core/mesh/lean.h"
#include "core/mesh/touch.h"
#include "core/target/target.h"

namespace underact::target {

/// A mesh that stands in the workspace: p_W = p_WM + scale_m R_WM p_M.
struct MeshPlace {
  std::shared_ptr<const mesh::Surface> surface;  // never null
  Mat3 R_WM = Mat3::Identity();
  Vec3 p_WM = Vec3::Zero();
  double scale_m = 1.0;  // of a unit of the mesh, not 0; below 0: of its mirror image
  mesh::Search search = mesh::Search::Hybrid;
  mesh::Lean lean = {};  // how far the force may lean, so that bends feel round
};

/// What a mesh remembers from tick to tick.
struct MeshState {
  mesh::SearchState search;  // of the nearest point
  mesh::TouchState touch;    // of a wall's proxy
};

/// Of bytes from a file. surface: that the state is for.
bool isSound(const MeshState& state, const mesh::Surface& surface) noexcept;

/// A point of the workspace, m, in the mesh's frame and unit.
inline Vec3 toMesh(const MeshPlace& place, const Vec3& p_W) noexcept UNDERACT_REAL_TIME {
  return place.R_WM.transpose() * (p_W - place.p_WM) / place.scale_m;
}
/// A point of the mesh, in its unit, in the workspace, m.
inline Vec3 toWorkspace(const MeshPlace& place, const Vec3& p_M) noexcept UNDERACT_REAL_TIME {
  return place.p_WM + place.scale_m * (place.R_WM * p_M);
}

/// Both sides: the nearest point, as place.search says; local: along the surface, so that the target never changes over
/// to another sheet. A wall: the proxy's place, free where nothing is touched. Friction is not in it.
Target meshTarget(const MeshPlace& place, Side side, const Vec3& p_WT, MeshState& state) noexcept UNDERACT_REAL_TIME;

/// The point of the mesh near p_W, found along the surface from where the target is.
Vec3 ontoMesh(const MeshPlace& place, const MeshState& state, const Vec3& p_W) noexcept UNDERACT_REAL_TIME;

/// By how much the target p_WP moves across the surface, so that the force leans to the smooth normal. Zero where the
/// place has no lean, or the tip is on the surface.
Vec3 leanOfMesh(const MeshPlace& place, const MeshState& state, const Vec3& p_WT,
                const Vec3& p_WP) noexcept UNDERACT_REAL_TIME;

}  // namespace underact::target
