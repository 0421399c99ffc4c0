#pragma once
#include <QWidget>
#include <cstdint>

#include "app/gui/theme.h"
#include "core/servo/host.h"

namespace underact::gui {

class Actions;
class ArmChoice;
class ArmInUse;
class Document;
class MovingHands;
class Player;
class RecentFiles;
class RegistrationTool;
class SceneView;
class SecondArm;
class ServoRate;

/// What a panel may use. Commands go through actions and document; what is shown comes by present().
struct PanelParts {
  servo::Host& host;
  Document& document;
  RecentFiles& recent;
  Actions& actions;
  SceneView& view;
  Player& player;
  ServoRate& rate;
  ArmInUse& arm_in_use;  // what a simulated arm is made of
  ArmChoice& arms;       // which arm it is
  SecondArm& second;
  RegistrationTool& registration;  // where the arms stand
  MovingHands& hands;
};

/// By the arm's clock, between two times that a panel writes numbers which change with every tick.
inline constexpr std::int64_t kBetweenNumbers_ns = 100'000'000;

/// A widget in a dock that shows what the servo does, or lets it be changed.
class Panel : public QWidget {
  Q_OBJECT
 public:
  using QWidget::QWidget;
  virtual void present(const servo::Snapshot&) {}  // each frame
  virtual void add(const servo::TickRecord&) {}    // every tick, in order
  virtual void setTheme(const Theme&) {}
  /// Its dock is opened, and stands before those that share its place.
  void bringForward();
  /// Not hidden, nor behind another tab (where Qt leaves it visible, outside the window). visibleRegion() would not do:
  /// it is empty wherever opaque children cover all of a widget.
  bool isSeen() const;
};

}  // namespace underact::gui
