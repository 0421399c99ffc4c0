#pragma once
#include <functional>
#include <memory>
#include <vector>

#include "app/gui/feature/feature.h"
#include "app/gui/model/settings.h"
#include "app/gui/view/view_memory.h"

namespace underact::device {
class ReplayedArm;
}

namespace underact::gui {

/// What a window needs; made by main() and by the stories.
struct WindowParts {
  servo::Host& host;
  device::SimulatedArm* arm;  // the host's first arm if it is the simulated one, else null
  ThemeWatcher& theme;
  device::ReplayedArm* replay = nullptr;                     // the host's device if it can replay, else null
  device::ChosenArm* chosen = nullptr;                       // behind the host if arms can be exchanged, else null
  std::vector<device::input::DeviceEnumerator*> hands = {};  // controllers and 3D mice; they outlive the window
  double busy_limit_s = 0.0;  // see WindowWatch; 0: time by count, as in tests: nobody watches
};

/// What all features of a window share, made and connected once. The window owns it all.
struct Services {
  Services(const WindowParts& given, const Settings& settings, QMainWindow* window);
  /// For the features.
  FeatureParts parts(const WindowParts& given, const Settings& settings, const std::vector<HelpPage>& pages,
                     std::function<QStringList()> busy_reason) const;
  void remember(Settings& settings) const;
  /// Shows the force limit: that of the scene's arm times the share that is let through now.
  void presentForceLimit() const;

  QMainWindow* window;
  servo::Host& host;
  Actions* actions;
  Document* document;
  RecentFiles* recent;
  LoadStrip* loads;
  SceneFiles* files;
  SceneView* view;
  std::unique_ptr<ViewMemory> view_memory;
  Player* player;
  Recording* recording;
  WindowScene* steered;
  ServoRate* rate;
  ArmChoice* arms;
  SecondArm* second;
  ArmInUse* arm_in_use;
  Hand* hand;
  StatusLine* status;
  Remark* where_it_stands;
  QBoxLayout* middle = nullptr;

 private:
  void buildMiddle();
  void buildStatus(const WindowParts& given);
  void connectThem(const WindowParts& given);
};

}  // namespace underact::gui
