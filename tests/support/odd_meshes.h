#pragma once
#include <string>
#include <vector>

#include "core/mesh/triangles.h"

namespace underact::test {

struct OddMesh {
  std::string name;
  mesh::Triangles triangles;
  bool parts_space = false;  // closed, and nowhere through itself: inside and outside are told apart
};

/// Meshes that are hard to search: faces without width, many at one place or equally far, none, odd scales.
std::vector<OddMesh> oddMeshes();

}  // namespace underact::test
