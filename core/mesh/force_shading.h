#pragma once
#include "core/mesh/search.h"

namespace underact::mesh {

/// How far a force may deviate from the surface normal, so that an edge between faces feels round: Phong smoothing. An
/// angle of 0 to 45 degrees by its cosine and sine; edges that bend by more stay sharp.
struct ForceShading {
  double cos = 1.0, sin = 0.0;
  /// Whether there is any smoothing.
  bool isThere() const noexcept UNDERACT_REAL_TIME { return sin > 0.0; }
};

/// max_rad: 0 to pi/4.
ForceShading forceShadingOf(double max_rad);

/// The direction between the tip and its hit, replaced by the interpolation of the corner normals at the hit. A
/// corner's normal is that of its faces up to the next sharp edge. u_M: unit, from the hit to the tip or the other way;
/// the result: unit, off from it by at most `most`. Continuous over faces, edges and the corners where no sharp edge
/// ends; on sharp edges and their corners it is u_M, except where a bend fades into one. Cost: some fifty face normals;
/// bounded for any fan. Source: Morgenbesser and Srinivasan 1996, Force shading for haptic shape perception, after
/// Phong 1975; the weights at edges and the limit are ours.
Vec3 shadedDirection(const Surface& surface, const Hit& hit, const Vec3& u_M,
                     const ForceShading& max) noexcept UNDERACT_REAL_TIME;

}  // namespace underact::mesh
