#include "app/gui/view/hand.h"

#include "app/gui/view/scene_view.h"
#include "device/simulated_arm.h"

namespace underact::gui {

Hand::Hand(SceneView* view, device::SimulatedArm* arm, QObject* parent) : QObject(parent), view_(view), arm_(arm) {
  view_->setHandAvailable(arm_ != nullptr);
  if (arm_ == nullptr) return;
  connect(view_, &SceneView::handGrabbed, this, [this] {
    moving_ = true;
    view_->setHandSetpoint(arm_->setpoint());  // starts at the hand, not at the tip, which contact holds back
  });
  connect(view_, &SceneView::handMoved, this, [this](const sim::HandSetpoint& setpoint) {
    moving_ = true;  // the keys move it without grabbing
    arm_->setSetpoint(setpoint);
  });
  connect(view_, &SceneView::handReleased, this, [this] { moving_ = false; });
}

Hand::~Hand() {
  if (arm_ != nullptr) arm_->holdButtons(0);
}

void Hand::present(const servo::Snapshot& snapshot) {
  if (arm_ == nullptr) return;
  const bool faulted = snapshot.mode == servo::Mode::Faulted;
  if (faulted == faulted_) return;
  faulted_ = faulted;
  showHint();
}

void Hand::setReplaying(bool on) {
  replaying_ = on;
  moving_ = false;
  view_->setHandAvailable(isThere());
  showHint();
}

void Hand::setAbsent(bool on) {
  absent_ = on;
  moving_ = false;
  view_->setHandAvailable(isThere());
  showHint();
}

void Hand::moveTo(const sim::HandSetpoint& setpoint) {
  if (!isThere()) return;
  moving_ = true;
  arm_->setSetpoint(setpoint);
  view_->setHandSetpoint(setpoint);  // a drag continues from there
}

void Hand::press(unsigned stylus_buttons) {
  if (arm_ != nullptr) arm_->holdButtons(isThere() ? stylus_buttons : 0U);
}

void Hand::showHint() {
  // One line at a time: a fault takes precedence.
  view_->setHint(replaying_ && !faulted_ ? tr("Replay: no force is sent to the arm.") : QString());
}

}  // namespace underact::gui
