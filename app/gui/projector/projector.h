#pragma once
#include <QFont>
#include <QObject>
#include <QSize>

#include "app/gui/feature/feature.h"
#include "app/gui/kit/window_chrome.h"

class QToolBar;

namespace underact::gui {

class SceneView;

/// The window for a class that watches from a distance: the view with a large gauge, large text, black on white or
/// white on black, panels hidden. Switching it off restores the window.
class Projector : public QObject, public ServoListener {
  Q_OBJECT
 public:
  Projector(Actions& actions, SceneView& view, ThemeWatcher& theme, QMainWindow* window);
  void remember(Settings& settings) override;
  bool isOn() const { return chrome_.isOff(); }
  void setOn(bool on);

 private:
  QMainWindow* window_;
  SceneView& view_;
  ThemeWatcher& theme_;
  WindowChrome chrome_;
  QFont view_font_, tools_font_;
  QSize icons_;
};

}  // namespace underact::gui
