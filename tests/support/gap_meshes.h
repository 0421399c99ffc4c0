#pragma once
#include <string>
#include <vector>

#include "core/mesh/triangles.h"

namespace underact::test {

/// A closed mesh with narrow gaps that does not intersect itself, slanted against the axes.
struct GapMesh {
  std::string name;
  mesh::Triangles triangles;  // mm
  std::vector<Vec3> aims;     // in the gaps and at their edges
};

/// Blocks with slots of 0.01 to 1 mm, blocks with V grooves, star prisms, spiky balls and gyroids.
std::vector<GapMesh> gapMeshes();

/// A block of 50 x 50 x 40 mm about the origin, along the axes, with a slot about x = 0 that is open upwards, to +y and
/// downwards, and ends at y = -20.
mesh::Triangles slotBlock(double width_mm);

}  // namespace underact::test
