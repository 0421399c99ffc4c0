#pragma once
#include <optional>

#include "core/mesh_union/arrange.h"

namespace underact::mesh_union {

/// The pieces that separate inside from outside.
struct Kept {
  std::vector<Piece> pieces;  // counterclockwise seen from outside
  bool is_all = true;         // every face is kept, uncut
  std::int64_t dropped = 0;   // faces of which no piece is kept
};

/// Keeps the pieces with the outside on one side alone; inside is where the winding number is above 0. None: cancelled,
/// or the faces do not close: some edge is not used as often in one direction as in the other.
std::optional<Kept> keep(const Grid& grid, const std::vector<mesh::Face>& faces, const Boxes& boxes,
                         const Points& points, const Arrangement& arrangement, const TaskMonitor& monitor);

/// A side of a piece.
struct PieceSide {
  std::int32_t low, high;  // points
  std::int32_t piece;
  std::int8_t side;
  bool forward;  // from low to high
};
/// All sides, sorted by their edges.
std::vector<PieceSide> sidesOf(const std::vector<Piece>& pieces);

/// Calls visit(first, last) for the sides on each edge. sides: sorted.
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
