#include "app/gui/hand.h"

#include "app/gui/view/scene_view.h"
#include "device/simulated_arm.h"

namespace underact::gui {

constexpr double kPush_N = 0.05;  // five times the last digit of the force shown: the hand has felt something

Hand::Hand(SceneView* view, device::SimulatedArm* arm, bool has_pushed, QObject* parent)
    : QObject(parent), view_(view), arm_(arm), has_pushed_(has_pushed) {
  view_->setHandAvailable(arm_ != nullptr);
  if (arm_ == nullptr) return;
  connect(view_, &SceneView::handGrabbed, this, [this] {
    moving_ = true;
    view_->setHandWish(arm_->wished());  // from where the hand is, not from where contact has left the tip
  });
  connect(view_, &SceneView::handMoved, this, [this](const sim::HandWish& wish) {
    moving_ = true;  // the keys move it without grabbing
    arm_->wish(wish);
  });
  connect(view_, &SceneView::handReleased, this, [this] { moving_ = false; });
  showHint();
}

Hand::~Hand() {
  if (arm_ != nullptr) arm_->holdButtons(0);
}

void Hand::present(const servo::Snapshot& snapshot) {
  if (arm_ == nullptr) return;
  const bool faulted = snapshot.mode == servo::Mode::Faulted;
  const bool pushed = has_pushed_ || (moving_ && snapshot.report.force.f_T_W().norm() > kPush_N);
  if (faulted == faulted_ && pushed == has_pushed_) return;
  faulted_ = faulted;
  has_pushed_ = pushed;
  showHint();
}

void Hand::setShape(const QString& type) {
  shape_ = type;
  if (arm_ != nullptr) showHint();
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

void Hand::moveTo(const sim::HandWish& wish) {
  if (!isThere()) return;
  moving_ = true;
  arm_->wish(wish);
  view_->setHandWish(wish);  // a drag goes on from there
}

void Hand::press(unsigned stylus_buttons) {
  if (arm_ != nullptr) arm_->holdButtons(isThere() ? stylus_buttons : 0U);
}

void Hand::showHint() {
  if (replaying_) return view_->setHint(faulted_ ? QString() : tr("Replaying: forces go to no arm."));
  if (!isThere()) return view_->setHint({});
  // One line at a time: what went wrong goes before what could be done.
  const bool has_inside = !QStringList{"point", "line", "circle", "curve", "virtual_manipulator"}.contains(shape_);
  const QString what = has_inside ? tr("Push into the %1.") : tr("Pull it away from the %1.");
  const QString shape = shape_ == "virtual_manipulator" ? tr("robot's tip") : shape_;
  view_->setHint(has_pushed_ || faulted_ ? QString() : tr("Drag the stylus with the mouse. ") + what.arg(shape));
}

}  // namespace underact::gui
