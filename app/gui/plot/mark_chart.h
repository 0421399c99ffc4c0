#pragma once
#include <QPainter>
#include <cmath>
#include <vector>

#include "app/gui/kit/painted.h"

namespace underact::gui {

/// What charts of marks have in common: logarithmic scales, the room and the lines of their axes, the way from mark to
/// mark. Chart is the one for curves that move.
class MarkChart : public Painted {
  Q_OBJECT
 protected:
  struct LogScale {
    double least = 1.0, most = 10.0;
    double shareOf(double value) const { return std::log(value / least) / std::log(most / least); }
  };

  MarkChart(const QString& name, const QString& spoken, const QString& tip, QWidget* parent);
  double lineHeight() const { return fontMetrics().lineSpacing(); }
  /// The axes, with room left of them for a label as wide as this one, above them for a title, and below them.
  QRectF axes(const QString& widest, double below) const;
  void drawTitle(QPainter& painter, const QString& title) const;
  QPen gridPen() const { return {quiet(0.6), 1.0}; }
  /// A line across the axes at y, with its label.
  void drawLevel(QPainter& painter, const QRectF& axes, double y, const QString& label) const;
  static void drawWay(QPainter& painter, const std::vector<QPointF>& way, const QPen& pen);
};

}  // namespace underact::gui
