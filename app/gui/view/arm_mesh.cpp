#include "app/gui/view/arm_mesh.h"

#include <QtGlobal>
#include <algorithm>
#include <filesystem>
#include <map>
#include <mutex>
#include <optional>
#include <set>
#include <string>
#include <utility>

#include "app/gui/view/drawn_mesh.h"
#include "core/arm/solid_place.h"
#include "core/json/text.h"
#include "core/mesh_file/read_file.h"
#include "core/mesh_file/repair.h"

namespace underact::gui {
namespace {

namespace fs = std::filesystem;

/// The meshes in use: an edit of the scene draws the same arm, and a second arm may be one of the same kind.
class ArmMeshesInUse {
 public:
  std::shared_ptr<const ArmMesh> find(const std::string& path, std::size_t max) {
    const std::scoped_lock lock(mutex_);
    std::erase_if(by_path_, [](const auto& one) { return one.second.mesh.expired(); });
    const auto found = by_path_.find({path, max});
    if (found == by_path_.end() || found->second.stamp != stampOf(path)) return nullptr;
    return found->second.mesh.lock();
  }
  using Stamp = std::pair<std::uintmax_t, fs::file_time_type>;
  void keep(const std::string& path, std::size_t max, Stamp stamp, const std::shared_ptr<const ArmMesh>& mesh) {
    const std::scoped_lock lock(mutex_);
    by_path_[{path, max}] = {stamp, mesh};
  }
  static Stamp stampOf(const std::string& path) {
    std::error_code error;
    const std::uintmax_t bytes = fs::file_size(path, error);
    return {bytes, fs::last_write_time(path, error)};
  }

 private:
  struct Kept {
    Stamp stamp;
    std::weak_ptr<const ArmMesh> mesh;
  };
  std::mutex mutex_;
  std::map<std::pair<std::string, std::size_t>, Kept> by_path_;
};

ArmMeshesInUse& meshesInUse() {
  static ArmMeshesInUse meshes;
  return meshes;
}

Result<std::shared_ptr<const ArmMesh>> readMesh(const std::string& path, std::size_t max, const TaskMonitor& monitor) {
  const Result<mesh_file::Input> input = mesh_file::Input::open(path);
  if (!input) return input.problems();
  if (input.value().bytes() > kLargestArmMesh)
    return Problems{{phrase(QT_TRANSLATE_NOOP("problem", "The file is larger than 64 MiB."))}};
  Result<mesh_file::RawMesh> raw = mesh_file::readFile(input.value(), monitor);
  if (!raw) return raw.problems();
  std::optional<mesh_file::Repaired> repaired = mesh_file::repair(std::move(raw.value().triangles), monitor);
  ArmMesh mesh;
  if (repaired) mesh.body = bodyOf(repaired->triangles, monitor, max);
  if (mesh.body == nullptr) return Problems{{mesh_file::kCancelled}};
  if (mesh.body->GetNumberOfPolys() == 0)
    return Problems{{phrase(QT_TRANSLATE_NOOP("problem", "The file contains nothing to draw."))}};
  mesh.origin = raw.value().origin_M;
  double bounds[6];
  mesh.body->GetBounds(bounds);
  mesh.low = mesh.origin + Vec3(bounds[0], bounds[2], bounds[4]);
  mesh.high = mesh.origin + Vec3(bounds[1], bounds[3], bounds[5]);
  return std::make_shared<const ArmMesh>(std::move(mesh));
}

}  // namespace

std::size_t countMeshes(const arm::Model& model) {
  return static_cast<std::size_t>(
      std::count_if(model.solids.begin(), model.solids.end(),
                    [](const arm::LinkSolid& solid) { return std::holds_alternative<arm::MeshSolid>(solid.form); }));
}

ArmMeshes readArmMeshes(const arm::Model& model, const TaskMonitor& monitor) {
  ArmMeshes meshes;
  meshes.of_solids.resize(model.solids.size());
  const std::size_t max = std::min(kMaxDrawn, kMaxArmTriangles / std::max<std::size_t>(countMeshes(model), 1));
  std::set<std::string> failed;  // files: several solids may name one
  for (std::size_t index = 0; index < model.solids.size() && !monitor.isCancelled(); ++index) {
    const auto* const solid = std::get_if<arm::MeshSolid>(&model.solids[index].form);
    if (solid == nullptr) continue;
    const Result<std::string> path = arm::fileOfSolid(model, *solid);
    if (!path) {
      meshes.problems.push_back(path.problems().front());
      continue;
    }
    if (failed.contains(path.value())) continue;  // told already
    meshes.of_solids[index] = meshesInUse().find(path.value(), max);
    if (meshes.of_solids[index] != nullptr) continue;
    const ArmMeshesInUse::Stamp stamp = ArmMeshesInUse::stampOf(path.value());  // before reading
    Result<std::shared_ptr<const ArmMesh>> mesh = readMesh(path.value(), max, monitor);
    if (monitor.isCancelled()) break;
    if (mesh) {
      meshes.of_solids[index] = std::move(mesh).value();
      meshesInUse().keep(path.value(), max, stamp, meshes.of_solids[index]);
      continue;
    }
    const Sentence sentence = phrase(QT_TRANSLATE_NOOP("problem", "The mesh %1 is not drawn: %2"),
                                     {json::shown(solid->name), mesh.problems().front().sentence});
    meshes.problems.push_back({sentence, solid->place});
    failed.insert(path.value());
  }
  return meshes;
}

}  // namespace underact::gui
