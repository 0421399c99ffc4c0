#pragma once
#include <string>
#include <vector>

#include "core/base/result.h"
#include "core/base/task_monitor.h"
#include "core/scene/description.h"
#include "core/tick/program.h"

namespace underact::scene {

/// The path of the file of a mesh or a curve: fileMeant() from the folder of the scene's own file.
std::string pathOf(const std::string& file, const Description& scene);

/// Loads the surface of each mesh that has none, from its file or from the cache, and the points of each curve. Takes
/// seconds for millions of triangles; reports progress and can be cancelled. Any thread but the servo's. Problems, each
/// with its constraint's place: those of mesh_file::loadMesh(); contents that do not match the checksum.
Problems loadMeshes(Description& scene, const TaskMonitor& monitor = {});

/// Loads those of a recorded scene, which names its meshes and curves without their folders: they are looked for beside
/// the session, then in each of the folders, by their whole name and by its last part. The first file that can be read
/// and matches the checksum is taken, and its path replaces the name. Problems: as loadMeshes(); a file that is in none
/// of the folders, with the way out.
Problems loadRecordedMeshes(Description& scene, const std::vector<std::string>& folders,
                            const TaskMonitor& monitor = {});

/// Whether a mesh of the scene has no surface yet, or a curve no points.
bool lacksMeshes(const Description& scene);

/// loadMeshes() and compile() in one.
Result<tick::TickProgram> loadAndCompile(Description& scene, const TaskMonitor& monitor = {});

/// The scene as a recording keeps it: each mesh and curve with its checksum, and without folders of the person's disk.
/// A file below the scene's own folder keeps its relative path; of any other only the name is kept. A replay finds it
/// by pathOf(). An arm from a file is kept with the whole content of that file.
Description withoutFolders(Description scene);

}  // namespace underact::scene
