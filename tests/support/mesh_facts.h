#pragma once
#include "core/mesh/triangles.h"

namespace underact::test {

/// What can be counted and summed of a mesh.
struct MeshFacts {
  bool is_closed = false;       // every edge has two faces that go along it oppositely
  int euler = 0;                // corners - edges + faces: 2 - 2 handles for one closed piece
  double volume = 0.0;          // above 0 where the faces look outwards
  double flattest = kInfinity;  // the least height of a face over its longest edge; 0: a face without area
};
MeshFacts factsOf(const mesh::Triangles& triangles);

/// How many pairs of an edge and a face that share no corner meet. Every pair is looked at.
int crossings(const mesh::Triangles& triangles);

}  // namespace underact::test
