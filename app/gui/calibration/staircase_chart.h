#pragma once
#include <QWidget>

#include "app/gui/kit/theme.h"
#include "core/calibration/measurement.h"

namespace underact::gui {

/// Difference against trial on a logarithmic scale: filled right, hollow wrong, a ring where the way turned; the
/// threshold as a line in a band of one standard deviation either way.
class StaircaseChart : public QWidget {
  Q_OBJECT
 public:
  explicit StaircaseChart(QWidget* parent = nullptr);
  void present(const calibration::Measurement& run);
  void setTheme(const Theme& theme);
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

  Theme theme_ = Theme::light();
  calibration::Measurement run_;
  double least_ = 0.01, most_ = 1.0;  // of the scale
};

}  // namespace underact::gui
