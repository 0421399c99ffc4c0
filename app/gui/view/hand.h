#pragma once
#include <QObject>
#include <QString>
#include <optional>

#include "core/servo/snapshot.h"
#include "core/sim/hand.h"

namespace underact::device {
class SimulatedArm;
}

namespace underact::gui {

class SceneView;

/// Passes mouse and key input of the view on to the simulated hand. The mouse holds the stylus while its button is
/// down; then the fingers are loose, and the scene moves the stylus. The keys hold it until letGo(). At first nobody
/// holds it.
class Hand : public QObject {
  Q_OBJECT
 public:
  /// arm: null for a real arm; then nothing can be grabbed.
  Hand(SceneView* view, device::SimulatedArm* arm, QObject* parent);
  ~Hand() override;  // releases the stylus buttons
  void present(const servo::Snapshot& snapshot);
  /// While a replay moves the stylus, input is ignored.
  void setReplaying(bool on);
  /// While another arm replaces the simulated one.
  void setAbsent(bool on);
  /// Whether the hand is being moved now.
  bool moves() const { return moving_; }

  /// The arm, while a hand may move it; otherwise null.
  const device::SimulatedArm* arm() const { return isThere() ? arm_ : nullptr; }
  /// Where the hand holds the stylus, or where the stylus is. Not for a real arm.
  sim::HandSetpoint setpoint() const;
  /// Another hand than the view's moves the stylus there and presses these buttons.
  void moveTo(const sim::HandSetpoint& setpoint);
  /// The simulated arm stands at rest with these joints, rad or m, and the hand is there; none: where it began. Not for
  /// a real arm, and not while a replay moves the stylus.
  void standAt(const std::optional<arm::JointAngles>& q);
  /// Whether the hand holds the stylus where the mouse leaves it, from now on.
  void setKeepsHolding(bool on);
  bool keepsHolding() const { return keeps_holding_; }
  /// The fingers become loose, unless the stylus is being moved.
  void letGo();
  void rest() { moving_ = false; }
  void press(unsigned stylus_buttons);

 private:
  void take(const sim::HandSetpoint& setpoint);
  void showHint();
  bool isThere() const { return arm_ != nullptr && !replaying_ && !absent_; }

  SceneView* view_;
  device::SimulatedArm* arm_;
  Vec3 tip_p_WT_;
  bool moving_ = false;
  bool keeps_holding_ = false;
  bool replaying_ = false;
  bool absent_ = false;
  bool faulted_ = false;
};

}  // namespace underact::gui
