#pragma once
#include "core/base/real_time.h"
#include "core/mesh/on_triangle.h"
#include "core/mesh/surface.h"

namespace underact::mesh {

/// The index of a corner in its face.
inline std::size_t placeOf(const Face& face, std::int32_t corner) noexcept UNDERACT_REAL_TIME {
  return face[0] == corner ? 0 : face[1] == corner ? 1 : 2;
}

/// Calls poll(face) for the faces that share with the given one the part that a point is on: none inside, the one
/// across an edge, those around a corner (first one way round, then, past a border, the other), until look returns
/// false. Bounded: of a fan, the first hundred.
template <class Visit>
void forNeighbours(const Surface& surface, std::int32_t face, Part part,
                   const Visit& visit) noexcept UNDERACT_REAL_TIME {
  constexpr int kMaxOfFan = 100;
  if (part == Part::Inside) return;
  const auto neighbourOf = [&](std::int32_t of, std::size_t side) noexcept UNDERACT_REAL_TIME {
    return surface.neighbours[static_cast<std::size_t>(of)][side];
  };
  if (part < Part::CornerA) {
    const auto side = static_cast<std::size_t>(part) - static_cast<std::size_t>(Part::EdgeAB);
    if (const std::int32_t other = neighbourOf(face, side); other >= 0) (void)visit(other);
    return;
  }
  const auto start = static_cast<std::size_t>(part) - static_cast<std::size_t>(Part::CornerA);
  const std::int32_t corner = surface.triangles.faces[static_cast<std::size_t>(face)][start];
  for (const bool forward : {true, false}) {
    std::int32_t at = face;
    for (int count = 0; count < kMaxOfFan; ++count) {
      // Of a face that has this corner at index k, side k leaves it and side k - 1 arrives.
      const std::size_t place = placeOf(surface.triangles.faces[static_cast<std::size_t>(at)], corner);
      at = neighbourOf(at, forward ? place : (place + 2) % 3);
      if (at == face) return;  // all the way round
      if (at < 0) break;
      if (!visit(at)) return;
    }
  }
}

}  // namespace underact::mesh
