#include "app/gui/ghost/ghost_load.h"

#include <QObject>
#include <memory>
#include <utility>

#include "app/gui/model/recorded_files.h"
#include "app/gui/view/drawn_mesh.h"
#include "core/arm/preset.h"
#include "core/scene/edit.h"
#include "core/scene/mirror.h"
#include "core/scene/scene_arm.h"
#include "device/recorded.h"

namespace underact::gui {
namespace {

Problems oneProblem(const QString& sentence, const std::string& path) {
  return {{sentence.toStdString(), {path}}};
}

ghost::Trajectory pathOf(const device::Recorded& recorded, const arm::Geometry& geometry) {
  ghost::TrajectoryBuilder maker(geometry, recorded.rate_hz);
  for (const device::RecordedRow& row : recorded.rows) maker.add(row.q_rad, row.begins_anew);
  return maker.take();
}

/// The files of a recorded scene have other names than those of the open scene: their content is compared.
void takeNames(scene::Shape& shape, const scene::Shape& recorded) {
  auto* mesh = std::get_if<scene::Mesh>(&shape);
  const auto* recorded_mesh = std::get_if<scene::Mesh>(&recorded);
  if (mesh != nullptr && recorded_mesh != nullptr && mesh->loaded_checksum == recorded_mesh->loaded_checksum) {
    mesh->file = recorded_mesh->file;
    mesh->checksum = recorded_mesh->checksum;
  }
  auto* curve = std::get_if<scene::Curve>(&shape);
  const auto* recorded_curve = std::get_if<scene::Curve>(&recorded);
  if (curve == nullptr || recorded_curve == nullptr || !curve->points || !recorded_curve->points) return;
  if (*curve->points == *recorded_curve->points) curve->file = recorded_curve->file;
}

}  // namespace

Result<LoadedGhost> loadGhost(const std::string& path, const TaskMonitor& monitor) {
  device::LoadWatch reading;
  reading.cancelled = monitor.cancelled;
  reading.files_in = recordedFilesFolders();
  if (monitor.progress) reading.progress = [&monitor](double share) { monitor.progress("", share); };
  Result<std::shared_ptr<const device::Recorded>> read = device::loadRecorded(path, reading);
  if (!read) return read.problems();
  const device::Recorded& recorded = *read.value();
  const device::RecordedScene* const first = recorded.sceneAt(0);
  const arm::Preset* const preset = first != nullptr ? scene::findArm(first->scene) : arm::findPreset(recorded.arm);
  if (preset == nullptr)
    return oneProblem(QObject::tr("This program does not know the session's arm “%1”.").arg(recorded.arm.c_str()),
                      path);
  const arm::MirrorPlane mirror = first != nullptr ? scene::mirrorPlaneOf(first->scene) : arm::MirrorPlane{};
  LoadedGhost ghost{recorded.name, path, pathOf(recorded, preset->geometry), mirror, {}, recorded.damage};
  if (ghost.trajectory.rows.size() < 2)
    return oneProblem(QObject::tr("This session has only one tick: there is nothing to follow."), path);
  if (first != nullptr) ghost.scene = first->scene;
  if (ghost.scene) makeDrawnMeshes(*ghost.scene, monitor);
  return ghost;
}

bool hasSameConstraints(const scene::Description& recorded, scene::Description other) {
  if (other.constraints.size() != recorded.constraints.size()) return false;
  other = scene::withArmOf(recorded, std::move(other));
  other.title = recorded.title;
  other.about = recorded.about;
  other.control = recorded.control;
  other.simulation = recorded.simulation;
  for (std::size_t index = 0; index < other.constraints.size(); ++index) {
    scene::Constraint& one = other.constraints[index];
    const scene::Constraint& was = recorded.constraints[index];
    one.control = was.control;
    takeNames(one.shape, was.shape);
  }
  return scene::isSame(recorded, other);
}

}  // namespace underact::gui
