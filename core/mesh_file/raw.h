#pragma once
#include <cstdint>
#include <string>

#include "core/mesh/triangles.h"
#include "core/mesh_file/format.h"

namespace underact::mesh_file {

/// What was left out while a file was read, in faces as the file has them.
struct Dropped {
  std::int64_t not_finite = 0;      // a corner is no finite point
  std::int64_t out_of_range = 0;    // a corner that is not there
  std::int64_t without_extent = 0;  // fewer than three different corners
};

/// A mesh as it stands in its file, its polygons cut into triangles.
struct Raw {
  mesh::Triangles triangles;     // finite, indexes in range
  Vec3 origin_M = Vec3::Zero();  // of the file's frame, that is 0 in that of the triangles
  Dropped dropped;
  std::int64_t polygons = 0;         // faces as the file has them, those left out among them
  std::int64_t normals = 0;          // that the file gives for faces, and
  std::int64_t normals_against = 0;  // of these, how many point against the order of the corners
  double cpu_s = 0.0;                // that the reading program took
  std::int64_t peak_bytes = 0;       // that it had in memory at once, as it says; 0: unknown
};

}  // namespace underact::mesh_file
