#pragma once
#include <QWidget>

class QCheckBox;
class QDoubleSpinBox;

namespace underact::gui {

/// What can be done with a response of the arm: gains from the scene and to it, and the measurement.
class StepFoot : public QWidget {
  Q_OBJECT
 public:
  explicit StepFoot(QWidget* parent = nullptr);
  double step_mm() const;
  bool hasLimits() const;

 signals:
  void takeAsked();
  void giveAsked();
  void measureAsked();

 private:
  QDoubleSpinBox* step_mm_;
  QCheckBox* limits_;
};

}  // namespace underact::gui
