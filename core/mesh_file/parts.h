#pragma once
#include <cstdint>
#include <optional>
#include <vector>

#include "core/mesh_file/edges.h"

namespace underact::mesh_file {

/// Faces that hang together by edges of two faces.
struct Part {
  std::int64_t faces = 0;
  std::int64_t against = 0;     // that stand the other way round than its first face, as it was
  std::int64_t clashes = 0;     // edges whose faces cannot agree
  bool is_open = false;         // a border, or an edge with more than two faces
  bool is_turned_over = false;  // what stands as its first face is turned; else what stands against it
  bool is_nested = false;       // closed, and within another closed one
  double volume = 0.0;          // as its first face stands
  double area = 0.0;
  Vec3 low = Vec3::Constant(kInfinity), high = Vec3::Constant(-kInfinity);
  std::int32_t some_corner = 0;
};

/// All parts of a mesh.
struct Parts {
  std::vector<Part> parts;
  std::vector<std::int32_t> part_of;     // of each face
  std::vector<std::uint8_t> is_against;  // of each face: it stands against the first of its part
  std::int64_t clashes = 0;              // edges
};

/// Whether it has neither border nor edge of more than two faces, and its faces can be made to agree.
inline bool isClosed(const Part& part) {
  return !part.is_open && part.clashes == 0;
}

/// Which faces hang together and how each stands, and which must be turned: in a closed part, so that the outside is
/// out; a part within another may be the wall of a hollow, so it stands as the file has most of it, and so does an open
/// part. None: cancelled.
std::optional<Parts> partsOf(const mesh::Triangles& triangles, const Edges& edges, const Watch& watch);

}  // namespace underact::mesh_file
