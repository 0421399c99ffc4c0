#pragma once
#include <cstddef>
#include <memory>

#include "core/base/real_time.h"
#include "core/base/result.h"
#include "core/base/task_monitor.h"
#include "core/mesh/node.h"
#include "core/mesh/triangles.h"

namespace underact::mesh {

/// A mesh as the tick reads it; const from makeSurface() on. Unit and frame are those of its triangles.
struct Surface {
  Triangles triangles;                     // faces in the order of the tree, those of a leaf in a row
  std::vector<Face> neighbours;            // of each face across AB, BC, CA; -1: none (a border, or not manifold)
  std::vector<Eigen::Vector3f> normals_M;  // of each corner: the sum of its faces' normals weighted by angle, unit
  std::vector<Node> nodes;                 // the root first
  Vec3 origin_M = Vec3::Zero();            // the origin of its corners, in the frame of its file
  bool is_closed = false;                  // separates inside from outside: two consistently wound faces at every edge
  bool is_united = false;  // has faces that were cut, in floats: of two that nearly touch, either may be in front
  Eigen::Vector3f low_M, high_M;  // its bounds
  std::uint64_t mark = 0;         // a hash of corners and faces
};

/// triangles: 1 to 2^27 faces, each of three different corners that exist and are finite. Allocates; takes seconds for
/// millions of faces, in as many threads as there are processors; equal triangles give bit-identical surfaces.
/// Problems: triangles as above are not given; cancelled.
Result<std::shared_ptr<const Surface>> makeSurface(Triangles triangles, const TaskMonitor& monitor = {},
                                                   const Vec3& origin_M = Vec3::Zero());

/// A copy of the surface with one flag changed.
std::shared_ptr<const Surface> withoutInside(const Surface& surface);  // not is_closed
std::shared_ptr<const Surface> asUnited(const Surface& surface);       // is_united

/// Fills in bounds and mark from the corners (one at least) and faces.
void complete(Surface& surface);

/// How much memory it takes.
std::size_t bytesOf(const Surface& surface);

/// The corners of a face.
struct Corners {
  Vec3 a, b, c;
};
/// face: an index of surface.triangles.faces, not checked. In the frame and the unit of the mesh.
inline Corners cornersOf(const Surface& surface, std::int32_t face) noexcept UNDERACT_REAL_TIME {
  const Face& corners = surface.triangles.faces[static_cast<std::size_t>(face)];
  const auto at = [&](std::size_t k) noexcept UNDERACT_REAL_TIME -> Vec3 {
    return surface.triangles.p_MV[static_cast<std::size_t>(corners[k])].cast<double>();
  };
  return {at(0), at(1), at(2)};
}

}  // namespace underact::mesh
