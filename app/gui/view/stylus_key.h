#pragma once
#include <QObject>

class QWidget;

namespace underact::device {
class SimulatedArm;
}

namespace underact::gui {

/// The Space key as the simulated arm's stylus button, while the view has the focus, or nothing in the window has. It
/// is let go as soon as the focus goes elsewhere.
class StylusKey : public QObject {
  Q_OBJECT
 public:
  StylusKey(device::SimulatedArm& arm, QWidget* window, QWidget* view);
  ~StylusKey() override;
  bool eventFilter(QObject* watched, QEvent* event) override;

 private:
  bool isOurs(const QWidget* focus) const { return focus == nullptr || focus == view_ || focus == window_; }
  void hold(bool held);

  device::SimulatedArm& arm_;
  QWidget *window_, *view_;
  bool held_ = false;
};

}  // namespace underact::gui
