#pragma once
#include <functional>
#include <vector>

#include "app/gui/feature/feature.h"
#include "app/gui/model/settings.h"

namespace underact::device {
class ReplayedArm;
}

namespace underact::gui {

/// What a window works with; made by main(), and by the stories.
struct WindowParts {
  servo::Host& host;
  device::SimulatedArm* arm;  // the arm behind the host at first, where it is the simulated one; else null
  ThemeWatcher& theme;
  device::ReplayedArm* replay = nullptr;         // the host's device, where it can replay; else null
  device::ChosenArm* chosen = nullptr;           // behind the host, where arms can be exchanged; else null
  std::vector<device::hands::Port*> hands = {};  // controllers and 3D mice; they outlive the window
};

/// What all features of a window share, made once and told of one another. The window owns every one of them.
struct Services {
  Services(const WindowParts& given, const Settings& settings, QMainWindow* window);
  /// For the features.
  FeatureParts parts(const WindowParts& given, const Settings& settings, const std::vector<HelpPage>& pages,
                     std::function<QStringList()> why_busy) const;
  void remember(Settings& settings) const;
  /// Of the arm that the scene is for, and what of its force is let through now.
  void presentForceLimit() const;

  QMainWindow* window;
  servo::Host& host;
  Actions* actions;
  Document* document;
  RecentFiles* recent;
  LoadStrip* loads;
  SceneFiles* files;
  SceneView* view;
  Player* player;
  Recording* recording;
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
