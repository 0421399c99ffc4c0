#pragma once
#include "core/mesh/search.h"

namespace underact::mesh {

/// The side of a wall on which the tip is free.
enum class FreeSide : std::uint8_t { Outside, Inside };

/// What a wall remembers from tick to tick. The proxy is a point of the surface on this face.
struct ProxyState {
  std::int32_t face = -1;   // that the proxy is on; -1: nothing is touched
  bool knows_last = false;  // where the tip was
  Vec3 q_M = Vec3::Zero();  // there
};

/// A proxy (god-object) for a wall: from where the tip went in, a point stays on the surface and slides to where it is
/// nearest to the tip, from face to face across edges and around corners, only ever nearer: so it neither passes
/// through a thin part to the other side nor slips over a sharp edge, however deep the tip is. Where it falls off an
/// edge, the opposite wall of a gap stops it, however narrow the gap is: the tip is free only where no face lies
/// between it and the proxy, and it is outside. It has no tolerance, so neither the mesh's scale nor its resolution
/// matters. A first tip, or one whose past is unknown, counts as behind the wall where the globally nearest point says
/// so. Gives the proxy's position; face -1: free. q_M: finite. Cost: that of a search, or of a walk of at most 256
/// faces; where a contact ends, of a ray besides, and of at most eight further walks. Source: Zilles and Salisbury
/// 1995, A constraint-based god-object method; Ho, Basdogan and Srinivasan 1999.
Hit followProxy(const Surface& surface, FreeSide free, const Vec3& q_M, ProxyState& state) noexcept UNDERACT_REAL_TIME;

}  // namespace underact::mesh
