#pragma once
#include <memory>

#include "core/base/real_time.h"
#include "core/mesh/force_shading.h"
#include "core/mesh/proxy.h"
#include "core/target/target.h"

namespace underact::target {

/// A mesh placed in the workspace: p_W = p_WM + scale_m R_WM p_M.
struct MeshPlace {
  std::shared_ptr<const mesh::Surface> surface;  // never null
  Mat3 R_WM = Mat3::Identity();
  Vec3 p_WM = Vec3::Zero();
  double scale_m = 1.0;  // of a unit of the mesh, not 0; below 0: of its mirror image
  mesh::Search search = mesh::Search::Hybrid;
  mesh::ForceShading lean = {};  // smoothing of the force, so that edges feel round
};

/// What a mesh remembers from tick to tick.
struct MeshState {
  mesh::SearchState search;  // of the nearest point
  mesh::ProxyState touch;    // of a wall's proxy
};

/// For bytes from a file: whether the state can be used. surface: for which it was made.
bool isValid(const MeshState& state, const mesh::Surface& surface) noexcept;

/// A point of the workspace, m, in the mesh's frame and unit.
inline Vec3 toMesh(const MeshPlace& place, const Vec3& p_W) noexcept UNDERACT_REAL_TIME {
  return place.R_WM.transpose() * (p_W - place.p_WM) / place.scale_m;
}
/// A point of the mesh, in its unit, in the workspace, m.
inline Vec3 toWorkspace(const MeshPlace& place, const Vec3& p_M) noexcept UNDERACT_REAL_TIME {
  return place.p_WM + place.scale_m * (place.R_WM * p_M);
}

/// Both sides: the nearest point, as place.search says; local: along the surface, so that the target never changes to
/// another sheet. A wall: the proxy; free where nothing is touched. Without friction.
Target meshTarget(const MeshPlace& place, Side side, const Vec3& p_WT, MeshState& state) noexcept UNDERACT_REAL_TIME;

/// The point of the mesh near p_W, found along the surface from the target.
Vec3 ontoMesh(const MeshPlace& place, const MeshState& state, const Vec3& p_W) noexcept UNDERACT_REAL_TIME;

/// The displacement of the target p_WP that turns the force towards the smoothed normal. Zero without smoothing, or
/// where the tip is on the surface.
Vec3 shadingOffset(const MeshPlace& place, const MeshState& state, const Vec3& p_WT,
                   const Vec3& p_WP) noexcept UNDERACT_REAL_TIME;

}  // namespace underact::target
