#pragma once
#include <QObject>

#include "app/gui/mesh/mesh_dialog.h"
#include "core/base/result.h"

namespace underact::gui {

class Actions;
class Document;
class LoadStrip;
class SceneFiles;

/// Meshes from files: loaded in another thread, asked about, and put into a scene; and the report on one that is there.
class MeshFiles : public QObject {
  Q_OBJECT
 public:
  MeshFiles(Document& document, SceneFiles& scenes, LoadStrip& loads, QWidget* window);
  void add(const QString& path);
  void chooseAndAdd();
  /// Of the scene's mesh at index, or its first one. false: there is none.
  bool showReport(std::optional<std::size_t> index);

 private:
  void load(const QString& path, std::optional<double> mm_per_unit);
  void ask(const QString& path, const mesh_file::Loaded& loaded, std::optional<double> mm_per_unit);
  void tell(const QString& path, const Problems& problems);

  Document& document_;
  SceneFiles& scenes_;
  LoadStrip& loads_;
  QWidget* window_;
};

/// By the end of its name; what is in it is seen when it is loaded.
bool isMeshFile(const QString& path);

/// As a scene holds it: in the middle of the workspace where it would lie outside of it.
scene::Constraint constraintOf(const QString& path, const mesh_file::Loaded& loaded, const MeshWish& wish);

/// "mesh.add", "mesh.report"
void addMeshActions(Actions& actions, MeshFiles& files);

}  // namespace underact::gui
