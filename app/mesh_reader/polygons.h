#pragma once
#include <cstdint>
#include <span>
#include <vector>

#include "core/mesh_file/raw.h"

namespace underact::mesh_reader {

/// Corners and faces as a reader hands them over, whatever they are worth.
struct Polygons {
  std::vector<Eigen::Vector3f> p_MV;
  std::vector<std::int32_t> corners;  // of all faces in a row
  std::vector<std::int32_t> ends;     // of each face in there, one past its last corner
};

/// Cuts a face into triangles: one with four corners along the diagonal that stays inside, one with more by cutting
/// ears off (concave ones, too); where it crosses itself or has very many, as a fan. face: three or more different
/// corners. Cost: the square of its corners, which are bounded.
void cutIntoTriangles(const std::vector<Eigen::Vector3f>& p_MV, std::span<const std::int32_t> face,
                      std::vector<mesh::Face>& triangles);

/// Cuts all of them, and leaves out what makes none: a face with a corner that is not there or not finite is left out
/// whole. Corners that are not finite are put to zero; no face has them.
mesh_file::Raw trianglesOf(Polygons polygons);

}  // namespace underact::mesh_reader
