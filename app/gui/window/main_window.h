#pragma once
#include <QMainWindow>
#include <memory>
#include <vector>

#include "app/gui/window/features.h"
#include "app/gui/window/services.h"

namespace underact::gui {

class Docks;
class FramePacer;
class DropOverlay;
class StopBanner;
class DeferredStyleSheet;
class WindowWatch;
struct Purpose;

/// The window: the view in the middle and the features around it. Each frame it hands the servo's newest snapshot to
/// all of them.
class MainWindow : public QMainWindow {
  Q_OBJECT
 public:
  explicit MainWindow(const WindowParts& given, std::vector<FeatureRow> rows = features());
  ~MainWindow() override;

  Actions& actions() { return *services_.actions; }
  Document& document() { return *services_.document; }
  SceneView& view() { return *services_.view; }
  Player& player() { return *services_.player; }
  /// One frame: fetches every tick since the last frame and shows the newest snapshot. Called by the pacer.
  void frame();

 protected:
  bool event(QEvent* event) override;
  void showEvent(QShowEvent* event) override;
  void closeEvent(QCloseEvent* event) override;
  void dragEnterEvent(QDragEnterEvent* event) override;
  void dragMoveEvent(QDragMoveEvent* event) override;
  void dragLeaveEvent(QDragLeaveEvent* event) override;
  void dropEvent(QDropEvent* event) override;

 private:
  void drain();  // gives everybody the ticks since the last time
  void buildFeatures();
  void buildBars();
  void choosePurpose(const QString& key);
  const Purpose& purpose() const;
  void presentMode(const servo::Snapshot& snapshot);
  void sceneOpened();
  void updateTitle();
  void setTheme(const Theme& theme);
  QStringList busyReason() const;
  void restore();
  void remember();

  const WindowParts given_;
  const std::vector<FeatureRow> rows_;
  const std::vector<HelpPage> pages_;
  Settings settings_;
  Services services_;
  FramePacer* pacer_;
  DeferredStyleSheet* sheets_;
  std::unique_ptr<Docks> docks_;
  ServoListeners listeners_;
  bool arranged_ = false;
  StopBanner* banner_ = nullptr;
  DropOverlay* drop_ = nullptr;
  QString fault_;                       // the sentence announced last
  std::unique_ptr<WindowWatch> watch_;  // last: its threads end before what they reach
};

}  // namespace underact::gui
