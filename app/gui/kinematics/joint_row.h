#pragma once
#include <QSlider>
#include <QWidget>

#include "app/gui/kit/focus_wheel.h"
#include "app/gui/kit/number_box.h"

class QLabel;

namespace underact::gui {

/// A slider of tenths of a degree that marks the joint's limits.
class LimitSlider : public FocusWheel<QSlider> {
  Q_OBJECT
 public:
  explicit LimitSlider(QWidget* parent) : FocusWheel(Qt::Horizontal, parent) {}
  void setLimits(double min_deg, double max_deg);

 protected:
  void paintEvent(QPaintEvent* event) override;

 private:
  double min_deg_ = 0.0, max_deg_ = 0.0;
};

/// A number box that distinguishes steps from typed values.
class AngleBox : public FocusWheel<NumberBox> {
  Q_OBJECT
 public:
  using FocusWheel::FocusWheel;
  void stepBy(int steps) override { emit stepped(steps * singleStep()); }
  QString textFromValue(double value) const override;  // with the same minus sign as all other numbers
 signals:
  void stepped(double by_deg);
};

/// One joint (degrees; mm of one that slides): its name, a slider with marks at its limits, the angle, and a word when
/// it is at a limit or outside.
class JointRow : public QWidget {
  Q_OBJECT
 public:
  JointRow(int joint, const QString& name, const QString& tip, QWidget* parent = nullptr);
  void setLimits(double min_deg, double max_deg);
  /// What joint it is. slides: its values are mm; else degrees.
  void setJoint(const QString& name, const QString& tip, bool slides);
  /// A slider that is held, and a number that is being typed, keep their values.
  void present(double angle_deg);

 signals:
  void asked(double angle_deg);  // dragged or typed
  void stepped(double by_deg);   // by key or wheel: from the commanded angle, not from where friction left the joint

 private:
  void showState(double angle_deg);

  int joint_;
  bool slides_ = false;
  QLabel* name_;
  LimitSlider* slider_;
  AngleBox* number_;
  QLabel* state_;
  double min_deg_ = -180.0, max_deg_ = 180.0;
  int shown_ = 0;  // tenths of a degree, on the slider
};

}  // namespace underact::gui
