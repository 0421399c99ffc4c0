#pragma once
#include <QWidget>

#include "core/base/result.h"
#include "core/scene/description.h"

class QComboBox;

namespace underact::gui {

class Document;

/// The scene with another arm: one that ships, by name, or the file at that path. Problems: its file's; the scene does
/// not fit it.
Result<scene::Description> withArm(scene::Description scene, const QString& name_or_path);

/// Which arm the scene is for: those that ship, or a file. A choice is an edit of the scene.
class SceneArmBox : public QWidget {
  Q_OBJECT
 public:
  SceneArmBox(Document& document, QWidget* window, QWidget* parent = nullptr);
  /// Gives the scene that arm; problems are shown. false: there were some, and the arm stays.
  bool take(const QString& name_or_path);
  void chooseFile();

 private:
  void present();

  Document& document_;
  QWidget* window_;
  QComboBox* arms_;
};

}  // namespace underact::gui
