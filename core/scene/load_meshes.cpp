#include "core/scene/load_meshes.h"

#include <algorithm>
#include <filesystem>
#include <map>
#include <mutex>

#include "core/base/translate.h"
#include "core/curve/points.h"
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
  return {
      {said(QT_TRANSLATE_NOOP(
                "problem",
                "The mesh %1 is not the one that the scene was made with: its content has another checksum. Bring that "
                "file back, or take \"checksum\" away to go on with this one."),
            {json::shown(mesh.file)}),
       place}};
}

Problems load(Mesh& mesh, const Description& scene, const Place& place, const mesh::Watch& watch) {
  const std::string path = pathOf(mesh.file, scene);
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

Problems load(Curve& curve, const Description& scene, const mesh::Watch& watch) {
  Result<std::vector<Vec3>> points = curve::readPoints(pathOf(curve.file, scene), watch);
  if (!points) return points.problems();  // each with its line
  curve.points = std::make_shared<const std::vector<Vec3>>(std::move(points).value());
  return {};
}

bool lacksFile(const Shape& shape) {
  const auto* const mesh = std::get_if<Mesh>(&shape);
  const auto* const curve = std::get_if<Curve>(&shape);
  return (mesh != nullptr && mesh->surface == nullptr) || (curve != nullptr && curve->points == nullptr);
}

std::string wholePath(const std::string& file, const Description& scene) {
  std::error_code error;
  const fs::path whole = fs::absolute(pathOf(file, scene), error);
  return error ? file : whole.lexically_normal().string();
}

}  // namespace

std::string pathOf(const std::string& name, const Description& scene) {
  const fs::path file(name);
  return file.is_absolute() ? name : (fs::path(scene.file).parent_path() / file).string();
}

bool lacksMeshes(const Description& scene) {
  return std::any_of(scene.constraints.begin(), scene.constraints.end(),
                     [](const Constraint& constraint) { return lacksFile(constraint.shape); });
}

Problems loadMeshes(Description& scene, const mesh::Watch& watch) {
  Problems problems;
  double count = 0.0, done = 0.0;
  for (const Constraint& constraint : scene.constraints) {
    count += lacksFile(constraint.shape) ? 1.0 : 0.0;
  }
  for (Constraint& constraint : scene.constraints) {
    if (!lacksFile(constraint.shape)) continue;
    auto* const mesh = std::get_if<Mesh>(&constraint.shape);
    auto* const curve = std::get_if<Curve>(&constraint.shape);
    mesh::Watch part = watch;
    part.progress = [&](const char* step, double share) { watch.tell(step, (done + share) / count); };
    const Problems found = mesh != nullptr ? load(*mesh, scene, constraint.place, part) : load(*curve, scene, part);
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
    auto* const curve = std::get_if<Curve>(&constraint.shape);
    if (mesh != nullptr) mesh->file = wholePath(mesh->file, scene);
    if (curve != nullptr) curve->file = wholePath(curve->file, scene);
    if (mesh != nullptr && !mesh->loaded_checksum.empty()) mesh->checksum = mesh->loaded_checksum;
  }
  return scene;
}

}  // namespace underact::scene
