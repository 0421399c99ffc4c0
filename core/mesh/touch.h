#pragma once
#include "core/mesh/search.h"

namespace underact::mesh {

/// Where a tip may be that a wall keeps out of the other side.
enum class Free : std::uint8_t { Outside, Inside };

/// What a touch remembers from tick to tick. The proxy is a point of the surface on this face.
struct TouchState {
  std::int32_t face = -1;   // that the proxy is on; -1: nothing is touched
  bool knows_last = false;  // where the tip was
  Vec3 q_M = Vec3::Zero();  // there
};

/// A proxy (god-object) for a wall: where the tip went in, a point stays on the surface and slides to where it is
/// nearest to the tip, from face to face across edges and around corners, always nearer: so it neither goes through a
/// thin part to its other side nor slips over a sharp edge, however deep the tip is. It has no tolerance, so neither
/// the mesh's scale nor its fineness matters. A first tip, or one of which nobody knows where it came from, is taken
/// for behind the wall where the nearest point of all says so. Gives the proxy's place; face -1: free. q_M: finite.
/// Cost: that of a search, or of a walk of 256 faces at most. Source: Zilles and Salisbury 1995, A constraint-based
/// god-object method; Ho, Basdogan and Srinivasan 1999.
Hit touch(const Surface& surface, Free free, const Vec3& q_M, TouchState& state) noexcept UNDERACT_REAL_TIME;

}  // namespace underact::mesh
