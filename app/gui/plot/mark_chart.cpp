#include "app/gui/plot/mark_chart.h"

#include "app/gui/kit/spoken.h"

namespace underact::gui {

MarkChart::MarkChart(const QString& name, const QString& spoken, const QString& tip, QWidget* parent)
    : Painted(name, spoken, tip, parent) {
  speakAs(this, QAccessible::Chart);
  setSizePolicy(QSizePolicy::Expanding, QSizePolicy::MinimumExpanding);
}

QRectF MarkChart::axes(const QString& widest, double below) const {
  const double left = fontMetrics().horizontalAdvance(widest) + 8.0, top = lineHeight() + 4.0;
  return {left, top, width() - left - 8.0, height() - top - below};
}

void MarkChart::drawTitle(QPainter& painter, const QString& title) const {
  painter.setPen(ink(0.75));
  painter.drawText(QRectF(0.0, 0.0, width(), lineHeight()), Qt::AlignLeft, title);
}

void MarkChart::drawLevel(QPainter& painter, const QRectF& axes, double y, const QString& label) const {
  painter.setPen(gridPen());
  painter.drawLine(QPointF(axes.left(), y), QPointF(axes.right(), y));
  painter.setPen(ink(0.75));
  painter.drawText(QRectF(0.0, y - 0.5 * lineHeight(), axes.left() - 6.0, lineHeight()),
                   Qt::AlignRight | Qt::AlignVCenter, label);
}

void MarkChart::drawWay(QPainter& painter, const std::vector<QPointF>& way, const QPen& pen) {
  painter.setBrush(Qt::NoBrush);
  painter.setPen(pen);
  painter.drawPolyline(way.data(), static_cast<int>(way.size()));
}

}  // namespace underact::gui
