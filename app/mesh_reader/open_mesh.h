#pragma once
#include <functional>
#include <string>

#include "app/mesh_reader/polygons.h"
#include "app/mesh_reader/prepare.h"
#include "core/base/sentence.h"
#include "core/mesh_file/format.h"

namespace underact::mesh_reader {

struct OpenMeshResult {
  Polygons polygons;
  std::int64_t normals = 0, normals_against = 0;  // of faces, where the format gives them
  Sentence problem;                               // empty: none
};

/// What OpenMesh reads from a file. progress: 0 to 1, in order. It may use up all memory: then there is a problem.
OpenMeshResult readWithOpenMesh(mesh_file::Format format, const Prepared& prepared,
                                const std::function<void(double share)>& progress);

}  // namespace underact::mesh_reader
