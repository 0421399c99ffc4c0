#pragma once
#include <QColor>
#include <QFont>
#include <QRectF>
#include <QString>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "app/gui/kit/theme.h"
#include "app/gui/model/plot_history.h"

class QPainter;

namespace underact::gui {

/// One chart: grid, curves, labels. Its points are allocated once for a width; a frame only fills them. Points that are
/// not finite break the line of a curve.
class Chart {
 public:
  struct Curve {
    QString name;  // in the legend; empty: not in it
    float width = 1.5F;
    bool dashed = false;
    bool shown = true;
  };
  Chart(const QString& title, const QString& x_title, const std::vector<Curve>& curves);

  /// A curve that is not shown is not in the legend either.
  void setCurveShown(std::size_t curve, bool shown);
  void setTitle(const QString& title) { title_ = title; }
  /// In the legend. setPlace() finds room for it.
  void setCurveName(std::size_t curve, const QString& name) { curves_[curve].name = name; }
  /// Ticks of y at multiples of least, 2 least, ...; 0: at round numbers.
  void setTickStep(double least) { tick_step_ = least; }
  void setColours(const Theme& theme, const std::vector<QColor>& curves);
  /// area: logical pixels from the top left of the widget; it contains the axes. scale: device pixels per logical one.
  void setPlace(const QRectF& area, double scale, const QFont& font);
  /// Of the axes, in device pixels.
  std::size_t columns() const;

  void setRange(double x_from, double x_to, double y_from, double y_to);
  /// Room for that many points in each curve; allocates only when the number changes.
  void reserve(std::size_t points);
  std::span<PlotPoint> points(std::size_t curve) { return points_[curve]; }
  std::size_t curves() const { return curves_.size(); }
  std::pair<double, double> yRange() const { return {y_from_, y_to_}; }
  /// The x of a point of the widget, logical pixels; none: outside the axes.
  std::optional<double> xAt(const QPointF& place) const;
  /// The point of an x in the widget, half way up the axes.
  QPointF placeOf(double x) const;
  void paint(QPainter& painter);

 private:
  void setTicks();
  QPointF placeOf(double x, double y) const;
  void paintGrid(QPainter& painter) const;
  void paintCurve(QPainter& painter, std::size_t curve);
  void paintWords(QPainter& painter) const;
  void paintLegend(QPainter& painter, double base) const;
  double nameWidth(const Curve& curve) const;
  double legendWidth() const;
  /// How many lines the legend takes below the title.
  int legendLines() const;
  double titleWidth() const;

  QString title_, x_title_;
  std::vector<Curve> curves_;
  std::vector<QColor> colours_;
  Theme theme_ = Theme::light();
  QFont usual_font_, font_;
  QRectF area_, axes_;
  int legend_lines_ = 0;  // below the title; 0: both fit in one line
  double scale_ = 1.0;
  double x_from_ = 0.0, x_to_ = 1.0, y_from_ = 0.0, y_to_ = 1.0;
  double tick_step_ = 0.0;
  std::vector<double> x_ticks_, y_ticks_;
  std::vector<std::vector<PlotPoint>> points_;
  std::vector<QPointF> line_;  // of the curve being painted
};

}  // namespace underact::gui
