#pragma once
#include "core/mesh/search.h"

namespace underact::mesh {

/// How far a force may lean from the surface's own normal, so that a bend of faces feels round: Phong smoothing.
/// An angle of 0 to 45 degrees by its cosine and sine; edges that turn by more stay as sharp as they are.
struct Lean {
  double cos = 1.0, sin = 0.0;
  /// Whether forces lean at all.
  bool isThere() const noexcept UNDERACT_REAL_TIME { return sin > 0.0; }
};

/// most_rad: 0 to pi/4.
Lean leanOf(double most_rad);

/// The direction between the tip and its hit becomes the one that the corners' normals give there, weighted by where in
/// its face the hit is. A corner's normal is that of the faces that no sharp edge parts. u_M: unit, from the hit to the
/// tip, or the other way; the answer: unit, off from it by most at most. Continuous over faces, edges and the corners
/// where no sharp edge ends; on sharp edges and the corners of theirs it is u_M, but where a bend fades into one.
/// Cost: some fifty faces' normals; bounded for any fan.
/// Source: Morgenbesser and Srinivasan 1996, Force shading for haptic shape perception, after Phong 1975; the weights
/// at edges and the limit are ours.
Vec3 leaning(const Surface& surface, const Hit& hit, const Vec3& u_M, const Lean& most) noexcept UNDERACT_REAL_TIME;

}  // namespace underact::mesh
