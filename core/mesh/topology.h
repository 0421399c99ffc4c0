#pragma once
#include <vector>

#include "core/mesh/triangles.h"

namespace underact::mesh {

/// How faces meet.
struct Topology {
  std::vector<Face> neighbours;  // of each face across AB, BC, CA; -1: none, several, or one wound inconsistently
  bool is_closed = false;        // each edge has two consistently wound faces
};

/// faces: of three different corners each. Sorts the edges: n log n.
Topology topologyOf(const std::vector<Face>& faces);

}  // namespace underact::mesh
