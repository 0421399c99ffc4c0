#pragma once
#include <QWidget>

class QCheckBox;
class QDoubleSpinBox;

namespace underact::gui {

/// The actions on a response of the arm: copying gains from and to the scene, and the measurement.
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
