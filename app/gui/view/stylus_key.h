#pragma once
#include <QObject>

class QWidget;

namespace underact::device {
class SimulatedArm;
}

namespace underact::gui {

/// The Space key as the stylus button of the simulated arm, while the view, or nothing in the window, has the focus. It
/// is released as soon as the focus goes elsewhere.
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
