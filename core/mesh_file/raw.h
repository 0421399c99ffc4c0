#pragma once
#include <cstdint>
#include <string>

#include "core/mesh/triangles.h"
#include "core/mesh_file/format.h"

namespace underact::mesh_file {

/// What was left out while a file was read, counted in faces.
struct Dropped {
  std::int64_t not_finite = 0;      // a corner is not finite
  std::int64_t out_of_range = 0;    // a corner does not exist
  std::int64_t without_extent = 0;  // fewer than three different corners
};

/// A mesh as read from its file, its polygons split into triangles.
struct RawMesh {
  mesh::Triangles triangles;     // finite, indexes in range
  Vec3 origin_M = Vec3::Zero();  // the origin of the triangles in the frame of the file
  double single_step = 0.0;      // between the single-precision numbers of a file far from its origin; 0: not so
  Dropped dropped;
  std::int64_t polygons = 0;         // faces of the file, including those left out
  std::int64_t normals = 0;          // that the file gives for faces, and
  std::int64_t normals_against = 0;  // of these, how many are against the winding
  double cpu_s = 0.0;                // processor time of the reader
  std::int64_t peak_bytes = 0;       // its greatest memory use, as reported by itself; 0: unknown
};

}  // namespace underact::mesh_file
