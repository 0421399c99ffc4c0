#include "app/gui/lessons/lesson_window_state.h"

#include <QAction>
#include <QDockWidget>
#include <QFileInfo>
#include <QMainWindow>
#include <algorithm>

#include "app/gui/kit/actions.h"
#include "app/gui/model/document.h"
#include "app/gui/model/scene_library.h"
#include "app/gui/view/hand.h"
#include "core/lesson/layers.h"
#include "core/lesson/stage.h"
#include "core/lesson/window_names.h"
#include "core/scene/scene_arm.h"

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
  const bool is_there = parts_.document.path() == path;
  const bool is_fresh = is_there && !parts_.document.modified();
  if (!(is_there && now.continues) && !is_fresh && !openScene(path)) return false;
  if (!(is_there && now.continues)) parts_.hand.standAt(lesson::startOf(now, scene::armOf(parts_.document.scene())));
  const Layers shown;  // those of a first start, not of whoever was here before
  for (const lesson::Layer& layer : lesson::layers()) {
    const bool wanted = std::find(now.layers.begin(), now.layers.end(), layer.name) != now.layers.end();
    showLayer(layer.name, wanted || shown.*layer.shown);
  }
  parts_.actions.perform("solution.show", 0);  // the ghost of another step is not of this one
  showPanels(now.panels);
  parts_.actions.perform("view." + (now.camera.empty() ? QString("home") : QString::fromStdString(now.camera)));
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

void LessonWindowState::showLayer(const char* name, bool on) {
  const QString action = layerAction(name);
  if (parts_.actions.find(action)->isChecked() != on) parts_.actions.perform(action, on);
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
  for (const char* name : lesson::layerNames()) showLayer(name, layers_.value(layerAction(name)));
  parts_.actions.perform("solution.show", 0);
  window()->restoreState(docks_);
  parts_.view.setViewpoint(viewpoint_);
}

}  // namespace underact::gui
