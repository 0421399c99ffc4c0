#pragma once
#include <optional>
#include <vector>

#include "app/gui/plot/mark_chart.h"
#include "core/trade/front.h"

namespace underact::gui {

/// Error of the tip's way against processor time, both logarithmic: every way to run the scene as a dot, those that
/// none beats in both filled and joined by a line, the scene as it was as a square, the chosen one ringed.
class FrontChart : public MarkChart {
  Q_OBJECT
 public:
  explicit FrontChart(QWidget* parent = nullptr);
  /// chosen: of the points; none: another way than these is in effect.
  void present(const std::vector<trade::Point>& points, const std::optional<std::size_t>& chosen);
  QSize minimumSizeHint() const override;

 protected:
  void paintEvent(QPaintEvent* event) override;

 private:
  QRectF plot() const;
  QPointF at(const trade::Point& point) const;
  double xOf(double us_per_s) const;
  double yOf(double error_mm) const;
  void drawAxes(QPainter& painter) const;
  void drawKey(QPainter& painter) const;
  void drawFront(QPainter& painter) const;
  void drawPoints(QPainter& painter) const;

  std::vector<trade::Point> points_;
  std::optional<std::size_t> chosen_;
  LogScale cost_, error_;
};

}  // namespace underact::gui
