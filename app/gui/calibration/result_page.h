#pragma once
#include <QWidget>

#include "app/gui/calibration/calibration_run.h"
#include "app/gui/kit/theme.h"

class QLabel;

namespace underact::gui {

class MarkChart;
class Readout;

/// The result of a measurement, and the way back to another one.
class ResultPage : public QWidget {
  Q_OBJECT
 public:
  explicit ResultPage(QWidget* parent = nullptr);
  void present(const CalibrationRun& session);
  void setTheme(const Theme& theme);
  /// A note on whether saving succeeded.
  void setNote(const QString& note);

 signals:
  void again();
  void save();

 private:
  Readout* numbers_;
  QLabel *none_, *note_;
  MarkChart* chart_;
};

}  // namespace underact::gui
