#include "app/gui/lessons/lesson_window_state.h"

#include <QAction>
#include <QDockWidget>
#include <QFileInfo>
#include <QMainWindow>
#include <algorithm>

#include "app/gui/kit/actions.h"
#include "app/gui/model/document.h"
#include "app/gui/model/scene_library.h"
#include "core/lesson/window_names.h"

namespace underact::gui {
namespace {

constexpr int kTextLines = 24;   // initial width of a lesson's text, in line heights
constexpr int kPanelLines = 20;  // and of the panels on the other side

QString layerAction(const char* name) {
  return QString("layer.%1").arg(name);
}

}  // namespace

QMainWindow* LessonWindowState::window() const {
  return qobject_cast<QMainWindow*>(panel_.window());
}

bool LessonWindowState::keep() {
  if (!parts_.actions.perform("scene.settle")) return false;
  path_ = parts_.document.path();
  scene_ = parts_.document.isOpen() ? parts_.document.asWritten() : scene::Description{};
  shown_.clear();
  for (const char* name : lesson::layerNames()) {
    layers_[layerAction(name)] = parts_.actions.find(layerAction(name))->isChecked();
  }
  viewpoint_ = parts_.view.viewpoint();
  docks_ = window()->saveState();
  parts_.document.undoStack().setClean();  // the user has been asked already
  parts_.document.keepAsWritten(true);
  return true;
}

bool LessonWindowState::arrange(const lesson::Lesson& lesson, std::size_t step) {
  const lesson::Step& now = lesson.steps[step];
  const QString path = QFileInfo(QString::fromStdString(lesson::sceneFileOf(lesson, step, sceneFolder().toStdString())))
                           .absoluteFilePath();
  if ((!now.scene.empty() || parts_.document.path() != path) && !openScene(path)) return false;
  showLayers(now.layers);
  showPanels(now.panels);
  if (!now.camera.empty()) parts_.actions.perform("view." + QString::fromStdString(now.camera));
  return true;
}

bool LessonWindowState::openScene(const QString& path) {
  discardExercise();
  if (!parts_.actions.perform("scene.open", path)) return false;
  shown_ = path;
  return true;
}

void LessonWindowState::discardExercise() {
  if (!shown_.isEmpty() && parts_.document.path() == shown_) parts_.document.undoStack().setClean();
}

void LessonWindowState::showLayers(const std::vector<std::string>& layers) {
  for (const char* name : lesson::layerNames()) {
    const bool wanted = std::find(layers.begin(), layers.end(), name) != layers.end();
    const QString action = layerAction(name);
    const bool on = wanted || layers_.value(action);
    if (parts_.actions.find(action)->isChecked() != on) parts_.actions.perform(action, on);
  }
}

/// The lesson alone on the left, the panels of the step on the right, so that both are visible beside the view.
void LessonWindowState::showPanels(const std::vector<std::string>& panels) {
  QMainWindow* const main = window();
  auto* const own = qobject_cast<QDockWidget*>(panel_.parentWidget());
  QDockWidget* first = nullptr;
  for (QDockWidget* const dock : docksOf(main)) {
    if (dock == own) continue;
    const bool wanted = std::find(panels.begin(), panels.end(), keyOf(dock).toStdString()) != panels.end();
    if (wanted && homeOf(dock) != Qt::BottomDockWidgetArea) {
      main->addDockWidget(Qt::RightDockWidgetArea, dock);
      if (first != nullptr) main->tabifyDockWidget(first, dock);
      if (first == nullptr) first = dock;
    }
    dock->setVisible(wanted);
  }
  panel_.bringForward();
  const int line = main->fontMetrics().height();
  main->resizeDocks({own}, {kTextLines * line}, Qt::Horizontal);
  if (first == nullptr) return;
  first->raise();
  main->resizeDocks({first}, {kPanelLines * line}, Qt::Horizontal);
}

void LessonWindowState::putBack() {
  const bool is_lessons = parts_.document.path() == shown_;
  discardExercise();
  parts_.document.keepAsWritten(false);
  if (is_lessons && !path_.isEmpty()) {
    parts_.actions.perform("scene.open", path_);
  } else if (is_lessons && !scene_.constraints.empty()) {
    static_cast<void>(parts_.document.open(scene_));  // it was in effect before
  }
  showLayers({});
  window()->restoreState(docks_);
  parts_.view.setViewpoint(viewpoint_);
}

}  // namespace underact::gui
