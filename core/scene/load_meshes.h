#pragma once
#include <string>
#include <vector>

#include "core/base/result.h"
#include "core/base/watch.h"
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
Problems loadMeshes(Description& scene, const Watch& watch = {});

/// The same of a recorded scene, which names its meshes and curves without their folders: they are looked for beside
/// the session, then in each of the folders, by their whole name and by the last part of it. Of several that are there
/// the first that can be read and has the checksum is taken, and its path put in place of the name. Problems: as
/// loadMeshes(); a file that is in none of them, with the way out.
Problems loadRecordedMeshes(Description& scene, const std::vector<std::string>& folders, const Watch& watch = {});

/// Whether a mesh of the scene has no surface yet, or a curve no points.
bool lacksMeshes(const Description& scene);

/// loadMeshes() and compile() in one.
Result<tick::TickProgram> loadAndCompile(Description& scene, const Watch& watch = {});

/// The scene as a recording keeps it: each mesh with its checksum, and no folder of the person's disk in it. A file
/// below the scene's own folder keeps its way from there; of any other the name alone is kept. A replay finds it by
/// pathOf().
Description withoutFolders(Description scene);

}  // namespace underact::scene
