#pragma once
#include <cstdint>

#include "core/base/task_monitor.h"
#include "core/mesh/triangles.h"

namespace underact::mesh_union {

enum class Outcome : std::uint8_t {
  AsItWas,  // no two faces go through each other, and none is within a body: nothing was changed
  Made,     // the surface of the union
  Open,     // the faces do not close, so there is no inside
  TooMuch,  // more crossings than the limit
  Cancelled,
};

/// The surface of what a mesh encloses.
struct Union {
  Outcome outcome = Outcome::AsItWas;
  std::int64_t crossings = 0;  // pairs of faces with more than corners and edges of theirs in common
  std::int64_t dropped = 0;    // faces that lay within bodies
};

/// Makes of a mesh that crosses itself, or whose parts do, the surface of their union: inside is where the winding
/// number is above 0, so a shell that is turned inwards within another is a hollow, and one that is not is swallowed.
/// triangles: of each face three different corners. Around each edge they go as often one way as the other, or the
/// outcome is Open; a part may touch another, and faces may lie on each other. Changed where the outcome is Made alone:
/// then each edge has two faces, corners of the mesh keep their place to the bit, and new ones are within two floats of
/// where planes meet. Which faces meet where, and what is inside, is decided exactly on a grid of 6e-8 of its extent;
/// what is shorter or narrower than `least` is then drawn together. wide: by how much bodies are taken for larger,
/// along their corners' normals, so that gaps between them close that nobody meant; corners of the mesh stay where they
/// are. The same for the same, to the bit. Cost: of the crossings, some 10 us each, and of a search for them. Sources:
/// Zhou et al. 2016, Mesh arrangements for solid geometry; Jacobson et al. 2013, for the winding number.
Union unite(mesh::Triangles& triangles, double least, double wide, const TaskMonitor& watch);

}  // namespace underact::mesh_union
