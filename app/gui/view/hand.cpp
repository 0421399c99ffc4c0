#include "app/gui/view/hand.h"

#include "app/gui/view/scene_view.h"
#include "device/simulated_arm.h"

namespace underact::gui {

Hand::Hand(SceneView* view, device::SimulatedArm* arm, QObject* parent) : QObject(parent), view_(view), arm_(arm) {
  view_->setHandAvailable(arm_ != nullptr);
  if (arm_ == nullptr) return;
  tip_p_WT_ = arm_->setpoint().p_WT;
  connect(view_, &SceneView::handGrabbed, this, [this] {
    moving_ = true;
    view_->setHandSetpoint(arm_->setpoint());  // starts at the hand, not at the tip, which contact holds back
  });
  connect(view_, &SceneView::handMoved, this, [this](const sim::HandSetpoint& setpoint) {
    moving_ = true;  // the keys move it without grabbing
    arm_->glideTo(setpoint);
  });
  connect(view_, &SceneView::handReleased, this, [this](bool by_mouse) {
    moving_ = false;
    if (by_mouse && !keeps_holding_) letGo();
  });
  letGo();
}

Hand::~Hand() {
  if (arm_ != nullptr) arm_->holdButtons(0);
}

void Hand::present(const servo::Snapshot& snapshot) {
  if (arm_ == nullptr) return;
  if (snapshot.ticks > 0 && snapshot.report.p_WT.allFinite()) tip_p_WT_ = snapshot.report.p_WT;
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

sim::HandSetpoint Hand::setpoint() const {
  sim::HandSetpoint setpoint = arm_->setpoint();
  if (!setpoint.holds) setpoint.p_WT = tip_p_WT_;
  return setpoint;
}

void Hand::take(const sim::HandSetpoint& setpoint) {
  arm_->setSetpoint(setpoint);
  view_->setHandSetpoint(setpoint);  // a drag continues from there
}

void Hand::moveTo(const sim::HandSetpoint& setpoint) {
  if (!isThere()) return;
  moving_ = true;
  arm_->glideTo(setpoint);
  view_->setHandSetpoint(setpoint);
}

void Hand::standAt(const std::optional<arm::JointAngles>& q) {
  if (!isThere()) return;
  moving_ = false;
  arm_->standAt(q);
  tip_p_WT_ = arm_->setpoint().p_WT;
  view_->setHandSetpoint(arm_->setpoint());
}

void Hand::setKeepsHolding(bool on) {
  keeps_holding_ = on;
  view_->setKeepsHolding(on);
  if (arm_ == nullptr) return;
  if (!on) return letGo();
  sim::HandSetpoint here = setpoint();
  here.holds = true;
  take(here);
}

void Hand::letGo() {
  if (arm_ == nullptr || moving_) return;
  sim::HandSetpoint loose = setpoint();
  loose.holds = false;
  take(loose);
}

void Hand::press(unsigned stylus_buttons) {
  if (arm_ != nullptr) arm_->holdButtons(isThere() ? stylus_buttons : 0U);
}

void Hand::showHint() {
  // One line at a time: a fault takes precedence.
  view_->setHint(replaying_ && !faulted_ ? tr("Replay: no force is sent to the arm.") : QString());
}

}  // namespace underact::gui
