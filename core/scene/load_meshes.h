#pragma once
#include <string>

#include "core/base/result.h"
#include "core/mesh/watch.h"
#include "core/scene/description.h"
#include "core/tick/program.h"

namespace underact::scene {

/// Where the file of a mesh or a curve is: as it stands, where that is absolute; else from the folder of the scene's
/// own file.
std::string pathOf(const std::string& file, const Description& scene);

/// Gives each mesh of the scene that has none its surface, from its file or from the cache, and each curve its points.
/// Takes seconds for millions of triangles: tells its steps, ends early where it is asked to. Any thread but the
/// servo's. Problems, each with its constraint's place: those of mesh_file::loadMesh(); the content is not the one of
/// the checksum.
Problems loadMeshes(Description& scene, const mesh::Watch& watch = {});

/// Whether a mesh of the scene has no surface yet, or a curve no points.
bool lacksMeshes(const Description& scene);

/// loadMeshes() and compile() in one.
Result<tick::TickProgram> loadAndCompile(Description& scene, const mesh::Watch& watch = {});

/// The scene with each mesh's file as an absolute path and with its checksum: what a recording keeps, so that it finds
/// the same mesh from wherever it is replayed.
Description withWholePaths(Description scene);

}  // namespace underact::scene
