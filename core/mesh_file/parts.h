#pragma once
#include <cstdint>
#include <optional>
#include <vector>

#include "core/mesh_file/edges.h"

namespace underact::mesh_file {

/// A connected part of a mesh: faces connected by edges of exactly two faces.
struct Part {
  std::int64_t faces = 0;
  std::int64_t against = 0;     // faces with the opposite winding of its first face, as read
  std::int64_t clashes = 0;     // edges whose faces have no consistent winding
  bool is_open = false;         // a border, or an edge with more than two faces
  bool is_turned_over = false;  // faces wound as its first face are reversed; else the others
  bool is_nested = false;       // closed, and within another closed one
  double volume = 0.0;          // signed by the winding of its first face
  double area = 0.0;
  Vec3 low = Vec3::Constant(kInfinity), high = Vec3::Constant(-kInfinity);
  std::int32_t some_corner = 0;
};

/// All parts of a mesh.
struct Parts {
  std::vector<Part> parts;
  std::vector<std::int32_t> part_of;     // of each face
  std::vector<std::uint8_t> is_against;  // of each face: wound against the first of its part
  std::int64_t clashes = 0;              // edges
};

/// Whether it has no border, no edge of more than two faces, and a consistent winding.
inline bool isClosed(const Part& part) {
  return !part.is_open && part.clashes == 0;
}

/// Finds the connected parts, the winding of each face, and the faces to reverse: in a closed part, so that normals
/// point outwards; in a part within another, which may be the wall of a cavity, and in an open part, so that the
/// majority stays. None: cancelled.
std::optional<Parts> partsOf(const mesh::Triangles& triangles, const Edges& edges, const TaskMonitor& monitor);

}  // namespace underact::mesh_file
