#include "core/scene/load_meshes.h"

#include <filesystem>
#include <map>
#include <mutex>

#include "core/json/text.h"
#include "core/mesh_file/load.h"
#include "core/scene/compile.h"

namespace underact::scene {
namespace {

namespace fs = std::filesystem;

/// What a surface in use was made of. A replay compiles the same mesh anew for every edit; a scene may hold it twice.
struct InUse {
  std::uintmax_t bytes = 0;
  fs::file_time_type written;
  std::string checksum;
  std::weak_ptr<const mesh::Surface> surface;
};

class SurfacesInUse {
 public:
  /// Empty where the file is another by now, or nobody holds its surface.
  bool find(const std::string& path, Mesh& mesh) {
    const std::scoped_lock lock(mutex_);
    const auto found = by_path_.find(path);
    if (found == by_path_.end()) return false;
    const InUse now = stampOf(path);
    if (now.bytes != found->second.bytes || now.written != found->second.written) return false;
    mesh.surface = found->second.surface.lock();
    mesh.loaded_checksum = found->second.checksum;
    return mesh.surface != nullptr;
  }
  void keep(const std::string& path, InUse stamp, const mesh_file::Loaded& loaded) {
    const std::scoped_lock lock(mutex_);
    stamp.checksum = loaded.checksum;
    stamp.surface = loaded.surface;
    by_path_[path] = std::move(stamp);
  }
  static InUse stampOf(const std::string& path) {
    std::error_code error;
    InUse stamp;
    stamp.bytes = fs::file_size(path, error);
    stamp.written = fs::last_write_time(path, error);
    return stamp;
  }

 private:
  std::mutex mutex_;
  std::map<std::string, InUse> by_path_;
};

SurfacesInUse& surfacesInUse() {
  static SurfacesInUse surfaces;
  return surfaces;
}

/// That the mesh is the one that the scene means; else it has no surface again.
Problems checked(Mesh& mesh, const Place& place) {
  if (mesh.checksum.empty() || mesh.checksum == mesh.loaded_checksum) return {};
  mesh.surface.reset();
  return {{"The mesh " + json::shown(mesh.file) +
               " is not the one that the scene was made with: its content has another checksum. Bring that file back, "
               "or take \"checksum\" away to go on with this one.",
           place}};
}

Problems load(Mesh& mesh, const Description& scene, const Place& place, const mesh::Watch& watch) {
  const std::string path = pathOf(mesh, scene);
  if (surfacesInUse().find(path, mesh)) return checked(mesh, place);
  InUse stamp = SurfacesInUse::stampOf(path);  // before: a file that changes meanwhile is read again next time
  Result<mesh_file::Loaded> loaded = mesh_file::loadMesh(path, watch);
  if (!loaded) {
    Problems problems = loaded.problems();
    for (Problem& problem : problems) {
      if (!place.file.empty()) problem.place = place;
    }
    return problems;
  }
  surfacesInUse().keep(path, std::move(stamp), loaded.value());
  mesh.surface = loaded.value().surface;
  mesh.loaded_checksum = loaded.value().checksum;
  return checked(mesh, place);
}

}  // namespace

std::string pathOf(const Mesh& mesh, const Description& scene) {
  const fs::path file(mesh.file);
  return file.is_absolute() ? mesh.file : (fs::path(scene.file).parent_path() / file).string();
}

bool lacksMeshes(const Description& scene) {
  for (const Constraint& constraint : scene.constraints) {
    const auto* const mesh = std::get_if<Mesh>(&constraint.shape);
    if (mesh != nullptr && mesh->surface == nullptr) return true;
  }
  return false;
}

Problems loadMeshes(Description& scene, const mesh::Watch& watch) {
  Problems problems;
  double count = 0.0, done = 0.0;
  for (const Constraint& constraint : scene.constraints) {
    const auto* const mesh = std::get_if<Mesh>(&constraint.shape);
    count += mesh != nullptr && mesh->surface == nullptr ? 1.0 : 0.0;
  }
  for (Constraint& constraint : scene.constraints) {
    auto* const mesh = std::get_if<Mesh>(&constraint.shape);
    if (mesh == nullptr || mesh->surface != nullptr) continue;
    mesh::Watch part = watch;
    part.progress = [&](const char* step, double share) { watch.tell(step, (done + share) / count); };
    const Problems found = load(*mesh, scene, constraint.place, part);
    problems.insert(problems.end(), found.begin(), found.end());
    if (watch.isCancelled()) break;
    done += 1.0;
  }
  return problems;
}

Result<tick::TickProgram> loadAndCompile(Description& scene, const mesh::Watch& watch) {
  Problems problems = loadMeshes(scene, watch);
  if (!problems.empty()) return problems;
  return compile(scene);
}

Description withWholePaths(Description scene) {
  for (Constraint& constraint : scene.constraints) {
    auto* const mesh = std::get_if<Mesh>(&constraint.shape);
    if (mesh == nullptr) continue;
    std::error_code error;
    const fs::path whole = fs::absolute(pathOf(*mesh, scene), error);
    if (!error) mesh->file = whole.lexically_normal().string();
    if (!mesh->loaded_checksum.empty()) mesh->checksum = mesh->loaded_checksum;
  }
  return scene;
}

}  // namespace underact::scene
