#pragma once
#include <cstdint>
#include <span>
#include <vector>

#include "core/mesh_file/raw.h"

namespace underact::mesh_reader {

/// Vertices and faces as a reader delivers them, unchecked.
struct Polygons {
  std::vector<Eigen::Vector3f> p_MV;
  std::vector<std::int32_t> corners;  // of all faces, one after the other
  std::vector<std::int32_t> ends;     // of each face: one past its last vertex
};

/// Divides a face into triangles: one with four vertices along the diagonal that lies inside, one with more by ear
/// clipping (concave ones, too); as a fan if it intersects itself or has very many. face: three or more different
/// vertices. Cost: the square of the number of vertices, which is bounded.
void cutIntoTriangles(const std::vector<Eigen::Vector3f>& p_MV, std::span<const std::int32_t> face,
                      std::vector<mesh::Face>& triangles);

/// Divides all faces, and leaves out invalid ones: a face with a vertex that is missing or not finite is left out
/// completely. Vertices that are not finite are set to zero; no face uses them.
mesh_file::RawMesh trianglesOf(Polygons polygons);

}  // namespace underact::mesh_reader
