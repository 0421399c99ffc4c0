#pragma once
#include <QByteArray>
#include <QHash>
#include <QString>

#include "app/gui/feature/panel.h"
#include "app/gui/view/scene_view.h"
#include "core/lesson/lesson.h"

class QMainWindow;

namespace underact::gui {

struct LessonParts {
  Document& document;
  Actions& actions;
  SceneView& view;
  Player& player;
};

/// What the window was like before a lesson, what a lesson makes of it, and the way back: scene, layers,
/// camera, docks.
class LessonPlace {
 public:
  /// panel: the one that lessons are shown in.
  LessonPlace(const LessonParts& parts, Panel& panel) : parts_(parts), panel_(panel) {}

  /// Keeps scene, layers, camera and docks. Asks what becomes of edits of the scene. false: everything stays as it is.
  bool keep();
  /// Opens the scene of a step, where it names one or another one is open, and shows what it asks for.
  bool arrange(const lesson::Lesson& lesson, std::size_t step);
  /// The window is as it was when it was kept. A scene that was opened meanwhile by hand stays.
  void putBack();

 private:
  bool openScene(const QString& path);
  void showLayers(const std::vector<std::string>& layers);
  void showPanels(const std::vector<std::string>& panels);
  QMainWindow* window() const;
  /// The lesson's own scene is open: what was changed in it was an exercise, and nobody is asked about it.
  void letGoOfExercise();

  LessonParts parts_;
  Panel& panel_;
  scene::Description scene_;  // of before; no constraint: there was none
  QString path_;              // its file; empty: it has none
  QString shown_;             // the lesson's scene that was opened last
  QHash<QString, bool> layers_;
  Viewpoint viewpoint_;
  QByteArray docks_;
};

}  // namespace underact::gui
