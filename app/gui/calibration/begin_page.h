#pragma once
#include <QWidget>

#include "app/gui/calibration/calibration_run.h"

class QCheckBox;
class QComboBox;
class QDoubleSpinBox;
class QFormLayout;
class QLabel;
class QPushButton;
class QSpinBox;

namespace underact::gui {

/// The settings of a measurement, kept from one to the next.
class BeginPage : public QWidget {
  Q_OBJECT
 public:
  explicit BeginPage(QWidget* parent = nullptr);
  /// The stiffness of the scene's softer beam: the reference until another is typed in.
  void setReference(double reference_N_per_mm);
  void setNote(const QString& note);
  CalibrationSetup setup() const;
  bool saysWhetherRight() const;
  void remember() const;

 signals:
  void begin();

 private:
  void addRow(QFormLayout* form, const QString& label, QWidget* field, const QString& key, const QString& tip);
  void showWho();

  double own_N_per_mm_ = 0.0;  // not rounded to what the field shows
  QDoubleSpinBox* reference_;
  QComboBox* who_;
  QDoubleSpinBox* weber_;
  QSpinBox* seed_;
  QCheckBox* feedback_;
  QLabel* note_;
};

}  // namespace underact::gui
