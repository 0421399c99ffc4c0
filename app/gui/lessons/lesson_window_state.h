#pragma once
#include <QByteArray>
#include <QHash>
#include <QString>

#include "app/gui/feature/panel.h"
#include "app/gui/model/servo_facts.h"
#include "app/gui/view/scene_view.h"
#include "core/lesson/lesson.h"

class QMainWindow;

namespace underact::gui {

struct LessonParts {
  Document& document;
  Actions& actions;
  SceneView& view;
  Player& player;
  ServoFacts servo;
  Hand& hand;
};

/// Saves scene, layers, camera and docks before a lesson, arranges them for its steps, and restores them afterwards.
class LessonWindowState {
 public:
  /// panel: shows the lessons.
  LessonWindowState(const LessonParts& parts, Panel& panel) : parts_(parts), panel_(panel) {}

  /// Saves scene, layers, camera and docks. Asks what to do with unsaved edits. false: nothing has changed.
  bool keep();
  /// Sets all that the step needs, whatever was before: its scene as in the file, the arm's pose, layers, panels and
  /// view. A step that continues leaves scene and arm as they are, if its scene is open.
  bool arrange(const lesson::Lesson& lesson, std::size_t step);
  /// Restores the window as saved by keep(). A scene that the user has opened meanwhile stays.
  void putBack();

 private:
  bool openScene(const QString& path);
  void showLayer(const char* name, bool on);
  void showPanels(const std::vector<std::string>& panels);
  QMainWindow* window() const;
  /// Discards edits of the lesson's own scene without asking: they were part of the exercise.
  void discardExercise();

  LessonParts parts_;
  Panel& panel_;
  scene::Description scene_;  // from before; without constraints: none was open
  QString path_;              // its file; empty: it has none
  QString shown_;             // the scene that the lesson opened last
  QHash<QString, bool> layers_;
  Viewpoint viewpoint_;
  QByteArray docks_;
};

}  // namespace underact::gui
