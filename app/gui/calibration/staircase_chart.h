#pragma once
#include "app/gui/plot/mark_chart.h"
#include "core/calibration/measurement.h"

namespace underact::gui {

/// Difference against trial on a logarithmic scale: filled right, hollow wrong, a ring where the way turned; the
/// threshold as a line in a band of one standard deviation either way.
class StaircaseChart : public MarkChart {
  Q_OBJECT
 public:
  explicit StaircaseChart(QWidget* parent = nullptr);
  void present(const calibration::Measurement& run);
  QSize minimumSizeHint() const override;

 protected:
  void paintEvent(QPaintEvent* event) override;

 private:
  QRectF plot() const;
  double yOf(double difference) const;
  double xOf(double trial) const;
  void drawAxes(QPainter& painter) const;
  void drawThreshold(QPainter& painter) const;
  void drawTrials(QPainter& painter) const;

  calibration::Measurement run_;
  LogScale scale_ = {0.01, 1.0};
};

}  // namespace underact::gui
