#pragma once
#include <QHash>
#include <QMainWindow>
#include <vector>

#include "app/gui/settings.h"
#include "core/servo/host.h"

namespace underact::device {
class ChosenArm;
class ReplayedArm;
class SimulatedArm;
namespace hands {
class Port;
}
}  // namespace underact::device

namespace underact::gui {

class Actions;
class ArmChoice;
class ArmInUse;
class CompareTool;
class CurveFiles;
class Document;
class FaultWatch;
class FramePacer;
class GhostHand;
class GhostStrip;
class GuideTool;
class Hand;
class MovingHands;
class IdentifyTool;
class LateSheets;
class LiveData;
class LoadStrip;
class MeshFiles;
class Panel;
class Player;
class Projector;
class RecentFiles;
class RegistrationTool;
class ReplayBar;
class SceneFiles;
class SceneView;
class SecondArm;
class SectionStrip;
class ServoRate;
class StatusLine;
class Tour;
class VisitorMode;
class Welcome;

/// What a window works with; made by main(), and by the stories.
struct WindowParts {
  servo::Host& host;
  device::SimulatedArm* arm;  // the arm behind the host at first, where it is the simulated one; else null
  ThemeWatcher& theme;
  device::ReplayedArm* replay = nullptr;         // the host's device, where it can replay; else null
  device::ChosenArm* chosen = nullptr;           // behind the host, where arms can be exchanged; else null
  std::vector<device::hands::Port*> hands = {};  // controllers and 3D mice; they outlive the window
};

/// The window: the view in the middle, panels around it, and each frame what the servo last said handed to all of them.
class MainWindow : public QMainWindow {
  Q_OBJECT
 public:
  explicit MainWindow(const WindowParts& parts);
  ~MainWindow() override;

  Actions& actions() { return *actions_; }
  Document& document() { return *document_; }
  SceneView& view() { return *view_; }
  VisitorMode& visitors() { return *visitors_; }
  Player& player() { return *player_; }
  GhostHand& ghost() { return *ghost_; }
  /// One frame: shows the newest snapshot and fetches every tick since the last frame. The pacer calls it.
  void frame();

 public slots:
  /// Replays a recorded session.
  void openSession(const QString& path);

 protected:
  bool event(QEvent* event) override;
  void showEvent(QShowEvent* event) override;
  void closeEvent(QCloseEvent* event) override;
  void dragEnterEvent(QDragEnterEvent* event) override;
  void dropEvent(QDropEvent* event) override;

 private:
  void addActions();
  void addHelpActions();
  void buildView();
  void buildGuests();
  void buildDocks();
  void arrangeDocks();
  void orderTabs();
  void connectDocument();
  void connectPlayer();
  void connectGhost();
  void connectRate();
  void connectArms();
  void tellOfSession(const QString& what, const Problems& problems);
  void replayBegins();
  void replayEnds();
  void setTheme(const Theme& theme);
  void showFrame(const servo::Snapshot& snapshot);
  void presentMode(const servo::Snapshot& snapshot);
  void showForceLimit();
  void updateTitle();
  void restore();
  void remember();

  WindowParts parts_;
  Settings settings_;
  Actions* actions_;
  Document* document_;
  RecentFiles* recent_;
  LoadStrip* loads_;
  SceneFiles* files_;
  MeshFiles* mesh_files_;
  CurveFiles* curve_files_;
  SceneView* view_;
  Player* player_;
  GhostHand* ghost_;
  ServoRate* rate_;
  ArmChoice* arms_;
  SecondArm* second_;
  RegistrationTool* registration_;
  CompareTool* compare_ = nullptr;
  SectionStrip* section_ = nullptr;
  ReplayBar* replay_bar_ = nullptr;
  GhostStrip* ghost_strip_ = nullptr;
  Hand* hand_ = nullptr;
  MovingHands* hands_ = nullptr;
  StatusLine* status_ = nullptr;
  FaultWatch* faults_;
  LiveData* live_;
  FramePacer* pacer_;
  ArmInUse* arm_in_use_;
  IdentifyTool* identify_;
  GuideTool* guide_;
  LateSheets* sheets_;
  QHash<QString, QDockWidget*> docks_;
  QHash<QString, Panel*> panels_;
  bool arranged_ = false;
  QString fault_;  // the sentence that was last said
  Welcome* welcome_ = nullptr;
  Tour* tour_ = nullptr;
  Projector* projector_ = nullptr;
  VisitorMode* visitors_ = nullptr;
};

}  // namespace underact::gui
