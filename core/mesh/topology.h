#pragma once
#include <vector>

#include "core/mesh/triangles.h"

namespace underact::mesh {

/// How faces meet.
struct Topology {
  std::vector<Face> neighbours;  // of each face across AB, BC, CA; -1: none, or more than one, or one wound against it
  bool is_closed = false;        // each edge has two faces that go along it oppositely
};

/// faces: of three different corners each. Sorts the edges: n log n.
Topology topologyOf(const std::vector<Face>& faces);

/// For each corner the faces that have it: those of corner k are faces[begins[k]] to before faces[begins[k + 1]].
struct CornerFaces {
  std::vector<std::int32_t> begins, faces;
};
CornerFaces facesAtCorners(const std::vector<Face>& faces, std::size_t corners);

}  // namespace underact::mesh
