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

/// Hands what the mouse and the keys do in the view on to the simulated hand.
class Hand : public QObject {
  Q_OBJECT
 public:
  /// arm: null where a real one is there; then nothing can be grabbed.
  Hand(SceneView* view, device::SimulatedArm* arm, QObject* parent);
  ~Hand() override;  // lets go of the stylus' buttons
  void present(const servo::Snapshot& snapshot);
  /// While a recording moves the stylus nobody else does.
  void setReplaying(bool on);
  /// While another arm is in the simulated one's place.
  void setAbsent(bool on);
  /// Somebody moves it just now.
  bool moves() const { return moving_; }

  /// The arm, while a hand may move it; else null.
  const device::SimulatedArm* arm() const { return isThere() ? arm_ : nullptr; }
  /// A hand that is not the view's wants the stylus there, and holds these of its buttons.
  void moveTo(const sim::HandWish& wish);
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
