#pragma once
#include <optional>

#include "core/mesh_union/arrange.h"

namespace underact::mesh_union {

/// What is between inside and outside.
struct Kept {
  std::vector<Piece> pieces;  // counterclockwise as seen from outside
  bool is_all = true;         // every face, as it was
  std::int64_t dropped = 0;   // faces that are inside, or outside, on both sides, all over
};

/// None: cancelled, or the faces do not close: around some edge they do not go as often one way as the other.
/// Inside is where the winding number is above 0.
std::optional<Kept> keep(const Grid& grid, const std::vector<mesh::Face>& faces, const Boxes& boxes,
                         const Points& points, const Arrangement& arrangement, const TaskMonitor& watch);

/// A side of a piece, in order of the edge that it lies on.
struct PieceSide {
  std::int32_t low, high;  // points
  std::int32_t piece;
  std::int8_t side;
  bool forward;  // from low to high
};
std::vector<PieceSide> sidesOf(const std::vector<Piece>& pieces);

/// Calls visit(first, last) for the sides on each edge.
template <class Visit>
void eachEdge(const std::vector<PieceSide>& sides, const Visit& visit) {
  for (std::size_t begin = 0; begin < sides.size();) {
    std::size_t end = begin + 1;
    while (end < sides.size() && sides[end].low == sides[begin].low && sides[end].high == sides[begin].high) ++end;
    visit(sides.data() + begin, sides.data() + end);
    begin = end;
  }
}

}  // namespace underact::mesh_union
