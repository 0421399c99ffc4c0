#pragma once
#include <functional>
#include <vector>

#include "app/gui/feature/help_page.h"
#include "app/gui/kit/theme.h"
#include "app/gui/model/servo_facts.h"

class QBoxLayout;
class QMainWindow;

namespace underact::device {
class ChosenArm;
class SimulatedArm;
namespace input {
class DeviceEnumerator;
}
}  // namespace underact::device

namespace underact::gui {

class Actions;
class ArmChoice;
class ArmInUse;
class Document;
class Hand;
class LoadStrip;
class Player;
class RecentFiles;
class Recording;
class Remark;
class SceneFiles;
class SceneView;
class SecondArm;
class ServoRate;
class StatusLine;
class WindowScene;
struct Settings;

/// What the window gives its features. It outlives them.
struct FeatureParts {
  QMainWindow* window;
  QBoxLayout& middle;  // contains the view; strips are added below
  ServoFacts servo;
  ServoControl control;
  Document& document;
  SceneFiles& files;
  RecentFiles& recent;
  LoadStrip& loads;
  Actions& actions;
  SceneView& view;
  StatusLine& status;
  Hand& hand;  // that of the view
  Player& player;
  Recording& recording;
  WindowScene& steered;  // the scene for programs that steer it
  ServoRate& rate;
  ArmInUse& arm_in_use;                                 // model of the simulated arm
  ArmChoice& arms;                                      // the arm that the servo drives
  SecondArm& second;                                    // the second arm
  Remark& where_it_stands;                              // where the arm is on the desk, in a sentence
  device::ChosenArm* chosen;                            // behind the host if arms can be exchanged, else null
  std::vector<device::input::DeviceEnumerator*> hands;  // controllers and 3D mice
  ThemeWatcher& theme;
  const Settings& settings;                  // saved when a window was last closed
  const std::vector<HelpPage>& pages;        // of the guide, for each part of the window
  std::function<QStringList()> busy_reason;  // of all features, see ServoListener::busyReason()
};

}  // namespace underact::gui
