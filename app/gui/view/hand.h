#pragma once
#include <QObject>
#include <QString>

#include "core/servo/snapshot.h"
#include "core/sim/hand.h"

namespace underact::device {
class SimulatedArm;
}

namespace underact::gui {

class SceneView;

/// Passes mouse and key input of the view on to the simulated hand.
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
  /// Another hand than the view's moves the stylus there and presses these buttons.
  void moveTo(const sim::HandSetpoint& setpoint);
  void rest() { moving_ = false; }
  void press(unsigned stylus_buttons);

 private:
  void showHint();
  bool isThere() const { return arm_ != nullptr && !replaying_ && !absent_; }

  SceneView* view_;
  device::SimulatedArm* arm_;
  bool moving_ = false;
  bool replaying_ = false;
  bool absent_ = false;
  bool faulted_ = false;
};

}  // namespace underact::gui
