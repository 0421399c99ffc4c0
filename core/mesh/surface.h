#pragma once
#include <cstddef>
#include <memory>

#include "core/base/real_time.h"
#include "core/base/result.h"
#include "core/base/watch.h"
#include "core/mesh/node.h"
#include "core/mesh/triangles.h"

namespace underact::mesh {

/// A mesh as the tick reads it; const from makeSurface() on. Unit and frame are those of its triangles.
struct Surface {
  Triangles triangles;                     // faces in the order of the tree, those of a bottom node in a row
  std::vector<Face> neighbours;            // of each face across AB, BC, CA; -1: none (a border, or not manifold)
  std::vector<Eigen::Vector3f> normals_M;  // of each corner: the sum of its faces' normals weighted by angle, unit
  std::vector<Node> nodes;                 // the root first
  Vec3 origin_M = Vec3::Zero();            // where its corners' own origin is in the frame of its file
  bool is_closed = false;                  // parts the space: every edge has two faces that go along it oppositely
  bool is_united = false;         // faces that were cut, in floats: of two that nearly touch, either may be before
  Eigen::Vector3f low_M, high_M;  // its bounds
  std::uint64_t mark = 0;         // of its corners and faces: tells it from others
};

/// triangles: 1 to 2^27 faces of three different corners that are there, finite. Allocates; seconds for millions of
/// faces, in as many threads as there are processors; equal triangles give equal surfaces to the bit. Problems: none of
/// these, cancelled.
Result<std::shared_ptr<const Surface>> makeSurface(Triangles triangles, const Watch& watch = {},
                                                   const Vec3& origin_M = Vec3::Zero());

/// The same, but for one of these.
std::shared_ptr<const Surface> withoutInside(const Surface& surface);  // not is_closed
std::shared_ptr<const Surface> asUnited(const Surface& surface);       // is_united

/// Bounds and mark, from its corners (one at least) and faces.
void complete(Surface& surface);

/// Of memory.
std::size_t bytesOf(const Surface& surface);

/// The corners of a face.
struct Corners {
  Vec3 a, b, c;
};
inline Corners cornersOf(const Surface& surface, std::int32_t face) noexcept UNDERACT_REAL_TIME {
  const Face& corners = surface.triangles.faces[static_cast<std::size_t>(face)];
  const auto at = [&](std::size_t k) noexcept UNDERACT_REAL_TIME -> Vec3 {
    return surface.triangles.p_MV[static_cast<std::size_t>(corners[k])].cast<double>();
  };
  return {at(0), at(1), at(2)};
}

}  // namespace underact::mesh
