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
    bool is_helper = false;  // see setHelper()
  };
  Chart(const QString& title, const QString& x_title, const std::vector<Curve>& curves);

  /// A curve that is not shown is not in the legend either.
  void setCurveShown(std::size_t curve, bool shown);
  void setTitle(const QString& title) { title_ = title; }
  /// In the legend. setPlace() finds room for it.
  void setCurveName(std::size_t curve, const QString& name) { curves_[curve].name = name; }
  /// Ticks of y at multiples of least, 2 least, ...; 0: at round numbers.
  void setTickStep(double min) { tick_step_ = min; }
  void setColours(const Theme& theme, const std::vector<QColor>& curves);
  /// area: logical pixels from the top left of the widget; it contains the axes. scale: device pixels per logical one.
  void setPlace(const QRectF& area, double scale, const QFont& font);
  /// Of the axes, in device pixels; of what the whole range would have where only a part is seen, so that what is
  /// thinned to them is as fine in the part.
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

  /// A part of the plane, in the coordinates of the axes.
  struct Part {
    double x_from = 0.0, x_to = 1.0, y_from = 0.0, y_to = 1.0;
    bool operator==(const Part&) const = default;
  };
  /// What setRange() gives, and what is shown of it.
  Part whole() const { return whole_; }
  Part seen() const { return {x_from_, x_to_, y_from_, y_to_}; }
  /// Shows that part, whatever setRange() says, until showWhole().
  void showPart(const Part& part);
  void showWhole();
  bool showsPart() const { return part_.has_value(); }
  const QRectF& axes() const { return axes_; }
  const QRectF& area() const { return area_; }
  const QString& xTitle() const { return x_title_; }
  const QString& title() const { return title_; }

  /// A curve without a name of its own that is no data: a line of zero, a limit, a cursor.
  void setHelper(std::size_t curve) { curves_[curve].is_helper = true; }
  /// The curves are paths in the plane, not functions of x.
  void setPaths() { is_path_ = true; }
  bool isPath() const { return is_path_; }

  /// A point of a curve under the cursor.
  struct Reading {
    QString name;  // of the curve, or of the chart
    QColor colour;
    double x = 0.0, y = 0.0;
    QPointF place;  // in the widget
  };
  /// The point of each curve that is shown and is data, nearest to an x; of a path, nearest to the place.
  std::vector<Reading> readingsAt(const QPointF& place) const;
  /// The line under the cursor, and its readings in words.
  void paintReadings(QPainter& painter, const QPointF& place) const;
  /// The points as they are drawn, of what is seen: a column for x and one for y of each curve, with a header.
  QString asText(QChar separator) const;

 private:
  void setTicks();
  void show(const Part& part);
  bool isData(std::size_t curve) const { return curves_[curve].shown && !curves_[curve].is_helper; }
  QString nameOf(std::size_t curve) const;
  QPointF placeOf(double x, double y) const;
  void paintGrid(QPainter& painter) const;
  void paintCurve(QPainter& painter, std::size_t curve);
  void paintWords(QPainter& painter) const;
  void paintLegend(QPainter& painter, double base) const;
  double nameWidth(const Curve& curve) const;
  double legendWidth() const;
  double widestName() const;
  /// How many lines the legend takes over the axes.
  int legendLines() const;
  double titleWidth() const;

  QString title_, x_title_;
  std::vector<Curve> curves_;
  std::vector<QColor> colours_;
  Theme theme_ = Theme::light();
  QFont default_font_, font_;
  QRectF area_, axes_;
  int legend_lines_ = 0;  // over the axes; 0: it fits beside the title
  double scale_ = 1.0;
  double x_from_ = 0.0, x_to_ = 1.0, y_from_ = 0.0, y_to_ = 1.0;
  Part whole_;
  std::optional<Part> part_;
  bool is_path_ = false;
  double tick_step_ = 0.0;
  std::vector<double> x_ticks_, y_ticks_;
  std::vector<std::vector<PlotPoint>> points_;
  std::vector<QPointF> line_;  // of the curve being painted
};

}  // namespace underact::gui
