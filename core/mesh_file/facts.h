#pragma once
#include <array>
#include <cstdint>

namespace underact::mesh_file {

/// How inside and outside of a mesh are distinguished.
enum class Inside : std::int64_t {
  AsItIs,  // its faces separate the two, or cannot
  United,  // where its winding number is above 0; the surface of that is felt, not its own faces
  Unsure,  // there are more crossings than are checked: they cannot be distinguished
};

/// What was found in a mesh, what was repaired, and what it is now. Lengths in the mesh's own unit.
struct Facts {
  // As the file has it
  std::int64_t file_faces = 0;
  std::int64_t file_corners = 0;
  std::int64_t normals = 0, normals_against = 0;  // given for faces; of these, against the winding
  double single_step = 0.0;  // of single-precision numbers that far from its origin; 0: near it, or no such numbers
  std::int64_t miscounted = 0, skipped_bytes = 0;  // of a binary STL: faces beyond the stated number, other bytes
  // Left out, in faces
  std::int64_t not_finite = 0, out_of_range = 0, without_extent = 0, duplicates = 0;
  // Repaired
  std::int64_t welded = 0;          // corners that were merged with another
  double weld_tolerance = 0.0;      // how near
  std::int64_t turned = 0;          // faces whose winding was reversed
  std::int64_t added_at_seams = 0;  // faces, where others were divided at corners on their borders
  // As it is now
  std::int64_t faces = 0, corners = 0;
  std::int64_t parts = 0, closed_parts = 0, nested_parts = 0;  // nested: a closed one within another closed one
  std::int64_t hollows = 0;                                    // nested ones whose outside is within them
  std::int64_t borders = 0, border_edges = 0;                  // borders: connected ones
  double longest_border = 0.0;
  std::int64_t crowded_edges = 0;      // with more than two faces
  std::int64_t clashing_edges = 0;     // with two faces that have no consistent outside, as on a Möbius strip
  std::int64_t flat_faces = 0;         // three different collinear corners
  std::int64_t crossings = 0;          // pairs of faces, without a corner in common, that go through each other
  std::int64_t crossings_checked = 0;  // 1: all pairs were checked; 0: too many faces
  // What is felt of it
  Inside inside = Inside::AsItIs;
  std::int64_t felt_faces = 0, felt_corners = 0;  // of the surface that is felt
  std::int64_t closed_holes = 0;                  // small ones, closed so that there is an inside
  double longest_closed_hole = 0.0;               // length of its border
  std::int64_t within = 0;                        // faces inside bodies, which are not felt
  double thinnest = 0.0;  // of closed parts: mean thickness, twice the volume over the area; 0: no such part
  std::array<double, 3> low{}, high{};
  double area = 0.0, volume = 0.0;  // volume: of the closed parts
};

/// Whether every edge has two faces of consistent winding, so that there is an inside.
inline bool isClosed(const Facts& facts) {
  return facts.faces > 0 && facts.border_edges == 0 && facts.crowded_edges == 0 && facts.clashing_edges == 0;
}

/// The largest of its three extents, in the mesh's unit.
inline double largestExtent(const Facts& facts) {
  double largest = 0.0;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const double extent = facts.high[axis] - facts.low[axis];
    largest = extent > largest ? extent : largest;
  }
  return largest;
}

}  // namespace underact::mesh_file
