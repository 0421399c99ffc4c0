#include "app/gui/mesh/mesh_files.h"

#include <QCoreApplication>
#include <QFileInfo>
#include <cmath>
#include <memory>
#include <utility>

#include "app/gui/files/load_strip.h"
#include "app/gui/files/scene_files.h"
#include "app/gui/kit/actions.h"
#include "app/gui/kit/file_question.h"
#include "app/gui/kit/problems_dialog.h"
#include "app/gui/kit/words.h"
#include "app/gui/model/document.h"
#include "app/gui/view/drawn_mesh.h"
#include "app/gui/view/file_constraint.h"
#include "core/scene/edit.h"
#include "core/scene/load_meshes.h"

namespace underact::gui {
namespace {

const QStringList& suffixes() {
  static const QStringList kAll{"stl", "obj", "ply", "off"};
  return kAll;
}

/// From the mesh's origin to the middle of its bounds, mm.
Vec3 middleOf(const mesh_file::Facts& facts, double mm_per_unit) {
  Vec3 middle_mm;
  for (std::size_t axis = 0; axis < 3; ++axis)
    middle_mm[static_cast<Eigen::Index>(axis)] = 0.5 * mm_per_unit * (facts.low[axis] + facts.high[axis]);
  return middle_mm;
}

}  // namespace

bool isMeshFile(const QString& path) {
  return suffixes().contains(QFileInfo(path).suffix().toLower());
}

scene::Constraint constraintOf(const QString& path, const mesh_file::Loaded& loaded, const MeshWish& wish) {
  scene::Mesh mesh;
  mesh.file = QFileInfo(path).absoluteFilePath().toStdString();
  mesh.scale_mm_per_unit = wish.mm_per_unit;
  mesh.surface = loaded.surface;
  mesh.loaded_checksum = loaded.checksum;
  mesh.X_WM = placeWithin(middleOf(loaded.facts, wish.mm_per_unit));
  scene::Constraint constraint;
  constraint.name = QFileInfo(path).completeBaseName().toStdString();
  constraint.shape = std::move(mesh);
  constraint.side = wish.side;
  constraint.friction = wish.friction;
  return constraint;
}

MeshFiles::MeshFiles(Document& document, SceneFiles& scenes, LoadStrip& loads, QWidget* window)
    : QObject(window), document_(document), scenes_(scenes), loads_(loads), window_(window) {}

void MeshFiles::add(const QString& path) {
  load(path, {});
}

void MeshFiles::chooseAndAdd() {
  askForFile(window_, "dialog.add_mesh", tr("Add a mesh"), {},
             tr("Meshes (*.stl *.obj *.ply *.off *.STL *.OBJ *.PLY *.OFF);;All files (*)"),
             [this](const QString& path) { add(path); });
}

bool MeshFiles::showReport(std::optional<std::size_t> index) {
  const scene::Description& scene = document_.scene();
  for (std::size_t one = index.value_or(0); one < scene.constraints.size(); ++one) {
    const auto* const mesh = std::get_if<scene::Mesh>(&scene.constraints[one].shape);
    if (mesh != nullptr) {
      load(QString::fromStdString(scene::pathOf(mesh->file, scene)), std::abs(mesh->scale_mm_per_unit));
      return true;
    }
    if (index) return false;
  }
  return false;
}

void MeshFiles::load(const QString& path, std::optional<double> mm_per_unit) {
  const auto loaded = std::make_shared<std::optional<Result<mesh_file::Loaded>>>();
  loads_.begin(
      tr("Loading %1").arg(QFileInfo(path).fileName()),
      [loaded, file = path.toStdString()](const Watch& watch) {
        *loaded = mesh_file::loadMesh(file, watch);
        if (!**loaded || watch.isCancelled()) return;
        watch.tell(QT_TRANSLATE_NOOP("step of work", "Preparing the picture"), 1.0);
        static_cast<void>(drawnMesh((*loaded)->value().surface, watch));
      },
      [this, loaded, path, mm_per_unit] {
        if (**loaded)
          ask(path, (*loaded)->value(), mm_per_unit);
        else
          tell(path, (*loaded)->problems());
      });
}

void MeshFiles::ask(const QString& path, const mesh_file::Loaded& loaded, std::optional<double> mm_per_unit) {
  auto* dialog = new MeshDialog(path, loaded, mm_per_unit, document_.isOpen(), window_);
  connect(dialog, &MeshDialog::addAsked, this, [this, dialog, path, loaded] {
    const scene::Constraint added = document_.throughMirror(constraintOf(path, loaded, dialog->wish()));
    const scene::Description with = scene::withAdded(document_.scene(), added);
    const Problems problems =
        document_.edit(with, tr("mesh %1").arg(QFileInfo(path).fileName()), document_.newGesture());
    dialog->setRefusal(sentencesOf(problems));
    if (problems.empty()) dialog->close();
  });
  connect(dialog, &MeshDialog::newSceneAsked, this, [this, dialog, path, loaded] {
    const QString about = tr("The mesh %1.").arg(QFileInfo(path).fileName());
    if (scenes_.openLoaded(sceneOfFile(path, about, constraintOf(path, loaded, dialog->wish())))) dialog->close();
  });
  dialog->show();
  dialog->raise();
  dialog->activateWindow();
}

void MeshFiles::tell(const QString& path, const Problems& problems) {
  const QString what = tr("“%1” was not loaded. The scene stays as it is.").arg(QFileInfo(path).fileName());
  showProblemsBox("dialog.mesh_problems", tr("Mesh not loaded"), what, problems, window_);
}

void addMeshActions(Actions& actions, MeshFiles& files) {
  const auto tr = [](const char* text) { return QCoreApplication::translate("underact::gui", text); };
  actions.add({"mesh.add", tr("Add &mesh…"), QKeySequence("Ctrl+M"),
               tr("Loads an STL, OBJ, PLY or OFF file, and adds it to the scene or makes a new one of it."), "open"},
              [&files](const QVariantList& path) {
                if (path.isEmpty())
                  files.chooseAndAdd();
                else
                  files.add(path.first().toString());
                return true;
              });
  actions.add(
      {"mesh.report", tr("Mesh &report"), QKeySequence("Ctrl+Shift+M"),
       tr("What was found in the file of the scene's mesh, what was repaired, and how it can be felt.")},
      [&files](const QVariantList& index) {
        return files.showReport(index.isEmpty() ? std::nullopt : std::optional(index.first().value<std::size_t>()));
      });
}

}  // namespace underact::gui
