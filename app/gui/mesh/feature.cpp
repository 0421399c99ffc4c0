#include "app/gui/feature/feature.h"

#include <QBoxLayout>
#include <QCoreApplication>
#include <QMainWindow>
#include <cmath>
#include <utility>

#include "app/gui/files/constraint_files.h"
#include "app/gui/kit/words.h"
#include "app/gui/mesh/mesh_dialog.h"
#include "app/gui/mesh/section_strip.h"
#include "app/gui/model/document.h"
#include "app/gui/view/drawn_mesh.h"
#include "core/scene/load_meshes.h"

namespace underact::gui {
namespace {

const QStringList kMeshSuffixes{"stl", "obj", "ply", "off"};

/// mm_per_unit: of a mesh of the scene, for its report; none: the mesh is to be added.
ConstraintFileKind::Read readMesh(std::optional<double> mm_per_unit) {
  return [mm_per_unit](const QString& path, const TaskMonitor& monitor) -> Result<ConstraintFileKind::Ask> {
    Result<mesh_file::Loaded> loaded = mesh_file::loadMesh(path.toStdString(), monitor);
    if (!loaded) return loaded.problems();
    if (!monitor.isCancelled()) {
      monitor.report(QT_TRANSLATE_NOOP("step of work", "Preparing the picture"), 1.0);
      static_cast<void>(drawnMesh(loaded.value().surface, monitor));
    }
    return ConstraintFileKind::Ask(
        [path, mm_per_unit, mesh = std::move(loaded).value()](bool can_add, QWidget* parent) {
          return new MeshDialog(path, mesh, mm_per_unit, can_add, parent);
        });
  };
}

/// The report of the mesh at index, or of the first mesh. False: there is none.
bool showReport(ConstraintFiles& files, const scene::Description& scene, std::optional<std::size_t> index) {
  for (std::size_t one = index.value_or(0); one < scene.constraints.size(); ++one) {
    const auto* const mesh = std::get_if<scene::Mesh>(&scene.constraints[one].shape);
    if (mesh != nullptr) {
      files.load(QString::fromStdString(scene::pathOf(mesh->file, scene)), readMesh(std::abs(mesh->scale_mm_per_unit)));
      return true;
    }
    if (index) return false;
  }
  return false;
}

void makeMesh(const FeatureParts& parts, ServoListeners& listeners) {
  auto* files = new ConstraintFiles({.key = "mesh",
                                     .suffixes = kMeshSuffixes,
                                     .choose = tr("Add a mesh"),
                                     .filter = tr("Meshes (%1);;All files (*)"),
                                     .not_loaded = tr("Mesh not loaded"),
                                     .edit = tr("mesh %1"),
                                     .about = tr("The mesh %1."),
                                     .read = readMesh({})},
                                    parts.document, parts.files, parts.loads, parts.window);
  files->addAction(
      parts.actions,
      {"mesh.add", tr("Add &mesh…"), QKeySequence("Ctrl+M"),
       tr("Loads an STL, OBJ, PLY or OFF file and adds it to the scene, or makes a new scene of it."), "open"});
  parts.actions.add(
      {"mesh.report",
       tr("Mesh &report"),
       {},
       tr("What the file of the scene's mesh contains, what was repaired, and how the mesh can be felt.")},
      [files, &document = parts.document](const QVariantList& index) {
        return showReport(*files, document.scene(),
                          index.isEmpty() ? std::nullopt : std::optional(index.first().value<std::size_t>()));
      });
  auto* section = new SectionStrip(parts.view, parts.actions, parts.middle.parentWidget());
  parts.middle.addWidget(section);
  listeners.push_back(section);
}

}  // namespace

FeatureRow meshFeature() {
  return {.pages = {{"section", "meshes"},
                    {"dialog.add_mesh", "meshes"},
                    {"dialog.mesh", "meshes"},
                    {"dialog.mesh_problems", "meshes"}},
          .make = makeMesh,
          .opens = FileKind::Mesh,
          .open_action = "mesh.add"};
}

}  // namespace underact::gui
