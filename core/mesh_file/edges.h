#pragma once
#include <cstdint>
#include <optional>
#include <vector>

#include "core/base/task_monitor.h"
#include "core/mesh/triangles.h"

namespace underact::mesh_file {

/// A side of a face: 3 * face + k goes from its corner k to the next one.
using Side = std::int32_t;

inline constexpr Side kBorder = -1;   // the edge has this face alone
inline constexpr Side kCrowded = -2;  // it has more than two

/// How the faces of a mesh meet.
struct Edges {
  std::vector<Side> across;  // of each side: the side of the other face at its edge, or one of the two above
  std::int64_t borders = 0;  // edges
  std::int64_t crowded = 0;
};

/// The face that the side belongs to. side: from 0 on.
inline std::int32_t faceOf(Side side) {
  return side / 3;
}
/// The corner that the side begins at. side: from 0 on, not checked.
inline std::int32_t startOf(const mesh::Triangles& triangles, Side side) {
  return triangles.faces[static_cast<std::size_t>(side / 3)][static_cast<std::size_t>(side % 3)];
}
/// The corner that the side ends at, the next one of its face.
inline std::int32_t endOf(const mesh::Triangles& triangles, Side side) {
  return triangles.faces[static_cast<std::size_t>(side / 3)][static_cast<std::size_t>((side + 1) % 3)];
}

/// Finds the sides that share an edge. Faces: of three different corners that exist. None: cancelled.
std::optional<Edges> edgesOf(const mesh::Triangles& triangles, const TaskMonitor& monitor);

}  // namespace underact::mesh_file
