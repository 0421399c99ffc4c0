#include "core/scene/load_meshes.h"

#include <algorithm>
#include <filesystem>
#include <map>
#include <mutex>
#include <span>
#include <utility>

#include "core/base/translate.h"
#include "core/curve/points.h"
#include "core/json/text.h"
#include "core/mesh_file/digest.h"
#include "core/mesh_file/load.h"
#include "core/scene/compile.h"
#include "core/scene/mesh_names.h"
#include "core/scene/scene_arm.h"

namespace underact::scene {
namespace {

namespace fs = std::filesystem;

/// The origin of a surface in use. A replay compiles the same mesh for every edit; a scene may have it twice.
struct InUse {
  std::uintmax_t bytes = 0;
  fs::file_time_type written;
  std::string checksum;
  std::weak_ptr<const mesh::Surface> surface;
  std::shared_ptr<const mesh_file::Facts> facts;
};

class SurfacesInUse {
 public:
  /// Finds the surface of a file; false where the file has changed, or the surface is no longer held.
  bool find(const std::string& path, Mesh& mesh) {
    const std::scoped_lock lock(mutex_);
    const auto found = by_path_.find(path);
    if (found == by_path_.end()) return false;
    const InUse now = stampOf(path);
    if (now.bytes != found->second.bytes || now.written != found->second.written) return false;
    mesh.surface = found->second.surface.lock();
    mesh.loaded_checksum = found->second.checksum;
    mesh.facts = found->second.facts;
    return mesh.surface != nullptr;
  }
  void keep(const std::string& path, InUse stamp, const Mesh& mesh) {
    const std::scoped_lock lock(mutex_);
    stamp.checksum = mesh.loaded_checksum;
    stamp.surface = mesh.surface;
    stamp.facts = mesh.facts;
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

/// Checks that the mesh is the one that the scene means; else it loses its surface again.
Problems checked(Mesh& mesh, const SourceLocation& place) {
  if (mesh.checksum.empty() || mesh.checksum == mesh.loaded_checksum) return {};
  mesh.surface.reset();
  return {
      {phrase(TRANSLATE_NOOP("problem",
                             "The mesh %1 is not the one that the scene was made with: its checksum differs. Restore "
                             "that file, or remove \"checksum\" to use this one."),
              {json::shown(mesh.file)}),
       place}};
}

Problems load(Mesh& mesh, const Description& scene, const SourceLocation& place, const TaskMonitor& monitor) {
  const std::string path = pathOf(mesh.file, scene);
  if (surfacesInUse().find(path, mesh)) return checked(mesh, place);
  InUse stamp = SurfacesInUse::stampOf(path);  // before reading: a file that changes meanwhile is read again
  Result<mesh_file::Loaded> loaded = mesh_file::loadMesh(path, monitor);
  if (!loaded) {
    Problems problems = withNearest(loaded.problems(), mesh.file, scene);
    for (Problem& problem : problems) {
      if (place.file.empty()) continue;
      problem.sentence = phrase(TRANSLATE_NOOP("problem", "The mesh %1: %2"), {path, problem.sentence});
      problem.place = place;
    }
    return problems;
  }
  mesh.surface = loaded.value().surface;
  mesh.loaded_checksum = loaded.value().checksum;
  mesh.facts = std::make_shared<const mesh_file::Facts>(loaded.value().facts);
  surfacesInUse().keep(path, std::move(stamp), mesh);
  return checked(mesh, place);
}

Problems load(Curve& curve, const Description& scene, const SourceLocation& place, const TaskMonitor& monitor) {
  const std::string path = pathOf(curve.file, scene);
  const Result<std::string> text = curve::readPointsText(path);
  if (!text) return withNearest(text.problems(), curve.file, scene);
  mesh_file::Digest digest;
  digest.add(std::as_bytes(std::span(text.value())));
  curve.loaded_checksum = digest.text();
  if (!curve.checksum.empty() && curve.checksum != curve.loaded_checksum)
    return {{phrase(TRANSLATE_NOOP("problem",
                                   "The curve %1 is not the one that the scene was made with: its checksum differs. "
                                   "Restore that file, or remove \"checksum\" to use this one."),
                    {json::shown(curve.file)}),
             place}};
  Result<std::vector<Vec3>> points = curve::parsePoints(text.value(), path, monitor, &curve.note);
  if (!points) return points.problems();  // each with its line
  curve.points = std::make_shared<const std::vector<Vec3>>(std::move(points).value());
  return {};
}

/// The files of that name beside the session and in the folders.
std::vector<std::string> foundOf(const std::string& name, const Description& scene,
                                 const std::vector<std::string>& folders) {
  const fs::path file(name), beside = fs::path(scene.file).parent_path();
  std::vector<fs::path> places{file.is_absolute() ? file : beside / file, beside / file.filename()};
  for (const fs::path folder : folders) {
    if (folder.empty()) continue;
    if (!file.is_absolute()) places.push_back(folder / file);
    places.push_back(folder / file.filename());
  }
  std::vector<std::string> found;
  std::error_code error;
  for (const fs::path& place : places) {
    const std::string path = fileMeant(place.parent_path(), place.filename());
    if (fs::exists(path, error)) found.push_back(path);
  }
  return found;
}

Problems notFound(const std::string& name, const Description& scene, const std::vector<std::string>& folders) {
  std::vector<std::string> looked{fs::path(scene.file).parent_path().string()};
  for (const std::string& folder : folders) {
    if (!folder.empty() && std::find(looked.begin(), looked.end(), folder) == looked.end()) looked.push_back(folder);
  }
  return {
      {phrase(TRANSLATE_NOOP("problem",
                             "The file %1 was not found in %2. A recording stores the names of its meshes and curves, "
                             "not their folders. Put the file beside the session, or choose its folder: in the window "
                             "with Replay, Folder with meshes and curves; on the command line with --files FOLDER."),
              {json::shown(name), json::listed(looked, "and")}),
       {scene.file}}};
}

template <class FromFile>
Problems loadFound(FromFile& shape, const Description& scene, const SourceLocation& place,
                   const std::vector<std::string>& folders, const TaskMonitor& monitor) {
  const std::string name = shape.file;
  Problems first = notFound(name, scene, folders);
  bool any = false;
  for (const std::string& path : foundOf(name, scene, folders)) {
    shape.file = fs::absolute(path).string();
    Problems problems = load(shape, scene, place, monitor);
    if (problems.empty() || monitor.isCancelled()) return problems;
    if (!std::exchange(any, true)) first = std::move(problems);
    shape.file = name;
  }
  return first;
}

bool lacksFile(const Shape& shape) {
  const auto* const mesh = std::get_if<Mesh>(&shape);
  const auto* const curve = std::get_if<Curve>(&shape);
  return (mesh != nullptr && mesh->surface == nullptr) || (curve != nullptr && curve->points == nullptr);
}

/// Calls load(shape, place, watch) for each mesh and each curve that is not loaded, with its share of the whole.
template <class Load>
Problems loadEach(Description& scene, const TaskMonitor& monitor, const Load& load_one) {
  Problems problems;
  double count = 0.0, done = 0.0;
  for (const Constraint& constraint : scene.constraints) {
    count += lacksFile(constraint.shape) ? 1.0 : 0.0;
  }
  for (Constraint& constraint : scene.constraints) {
    if (!lacksFile(constraint.shape)) continue;
    auto* const mesh = std::get_if<Mesh>(&constraint.shape);
    auto* const curve = std::get_if<Curve>(&constraint.shape);
    TaskMonitor part = monitor;
    part.progress = [&](const char* step, double share) { monitor.report(step, (done + share) / count); };
    const Problems found =
        mesh != nullptr ? load_one(*mesh, constraint.place, part) : load_one(*curve, constraint.place, part);
    problems.insert(problems.end(), found.begin(), found.end());
    if (monitor.isCancelled()) break;
    done += 1.0;
  }
  return problems;
}

std::string withoutFolder(const std::string& written, const Description& scene) {
  const std::string name = plainName(fs::path(scene.file).parent_path(), written);
  const fs::path file(name);
  const bool is_below = file.is_relative() && std::find(file.begin(), file.end(), fs::path("..")) == file.end();
  return is_below ? name : file.filename().string();
}

}  // namespace

std::string pathOf(const std::string& name, const Description& scene) {
  return fileMeant(fs::path(scene.file).parent_path(), name);
}

bool lacksMeshes(const Description& scene) {
  return std::any_of(scene.constraints.begin(), scene.constraints.end(),
                     [](const Constraint& constraint) { return lacksFile(constraint.shape); });
}

Problems loadMeshes(Description& scene, const TaskMonitor& monitor) {
  return loadEach(scene, monitor, [&](auto& shape, const SourceLocation& place, const TaskMonitor& part) {
    return load(shape, scene, place, part);
  });
}

Problems loadRecordedMeshes(Description& scene, const std::vector<std::string>& folders, const TaskMonitor& monitor) {
  return loadEach(scene, monitor, [&](auto& shape, const SourceLocation& place, const TaskMonitor& part) {
    return loadFound(shape, scene, place, folders, part);
  });
}

Result<tick::TickProgram> loadAndCompile(Description& scene, const TaskMonitor& monitor) {
  Problems problems = loadMeshes(scene, monitor);
  if (!problems.empty()) return problems;
  return compile(scene);
}

Description withoutFolders(Description scene) {
  if (isArmFile(scene.arm)) {
    scene.arm = withoutFolder(scene.arm, scene);
    scene.arm_text = armTextOf(scene);
  }
  for (Constraint& constraint : scene.constraints) {
    auto* const mesh = std::get_if<Mesh>(&constraint.shape);
    auto* const curve = std::get_if<Curve>(&constraint.shape);
    if (mesh != nullptr) mesh->file = withoutFolder(mesh->file, scene);
    if (curve != nullptr) curve->file = withoutFolder(curve->file, scene);
    if (mesh != nullptr && !mesh->loaded_checksum.empty()) mesh->checksum = mesh->loaded_checksum;
    if (curve != nullptr && !curve->loaded_checksum.empty()) curve->checksum = curve->loaded_checksum;
  }
  return scene;
}

}  // namespace underact::scene
