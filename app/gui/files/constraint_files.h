#pragma once
#include <QObject>
#include <functional>
#include <memory>

#include "app/gui/kit/actions.h"
#include "core/base/result.h"
#include "core/base/task_monitor.h"
#include "core/scene/description.h"

namespace underact::gui {

class AddDialog;
class Document;
class LoadStrip;
class SceneFiles;

/// What distinguishes the kinds of files whose content becomes a constraint.
struct ConstraintFileKind {
  /// Makes the dialog about the content.
  using Ask = std::function<AddDialog*(bool can_add, QWidget* parent)>;
  using Read = std::function<Result<Ask>(const QString& path, const TaskMonitor& monitor)>;
  using Made = std::shared_ptr<const void>;

  QString key;  // "mesh": its action is mesh.add, its dialogs are dialog.add_mesh and dialog.mesh_problems
  QStringList suffixes;
  QString choose, filter, not_loaded;  // titles; filter: %1 for the patterns
  QString edit, about;                 // "mesh %1" to undo, "The mesh %1." of a new scene
  Read read;                           // in another thread
  /// In another thread: prepares what compiling the scene needs, kept as long as it is held. None: nothing takes long.
  std::function<Result<Made>(const scene::Shape& shape)> make = {};
};

/// Files whose content becomes a constraint: read in another thread, shown in a dialog, and added to a scene.
class ConstraintFiles : public QObject {
  Q_OBJECT
 public:
  ConstraintFiles(ConstraintFileKind kind, Document& document, SceneFiles& scenes, LoadStrip& loads, QWidget* window);
  /// "mesh.add": loads the given file, or asks for one.
  void addAction(Actions& actions, const ActionInfo& info);
  /// Reads a file and opens the dialog on it; read: another reader than that of its kind if it is only shown.
  void load(const QString& path, const ConstraintFileKind::Read& read);

 signals:
  void added();  // to the scene, or to a new one

 private:
  /// What a button of the dialog does with the constraint; false: the dialog stays open.
  using Use = std::function<bool(AddDialog& dialog, const scene::Constraint& constraint)>;
  void choose();
  void ask(const QString& name, AddDialog* dialog);
  void take(const QString& name, AddDialog* dialog, const Use& use);

  const ConstraintFileKind kind_;
  Document& document_;
  SceneFiles& scenes_;
  LoadStrip& loads_;
  QWidget* window_;
};

}  // namespace underact::gui
