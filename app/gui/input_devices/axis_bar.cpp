#include "app/gui/input_devices/axis_bar.h"

#include <QPainter>
#include <cmath>

namespace underact::gui {

AxisBar::AxisBar(const QString& name, const QString& spoken, QWidget* parent)
    : Painted(name, spoken, tr("Line: deflection. Bar: output. Grey: dead zone."), parent) {
  setMinimumWidth(72);
  setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
}

QSize AxisBar::sizeHint() const {
  return {120, 16};
}

void AxisBar::present(double deflection, double share, double dead_zone) {
  if (deflection == deflection_ && share == share_ && dead_zone == dead_zone_) return;
  deflection_ = deflection;
  share_ = share;
  dead_zone_ = dead_zone;
  setAccessibleDescription(QString("%1 %").arg(std::lround(100.0 * share)));
  update();
}

void AxisBar::paintEvent(QPaintEvent*) {
  QPainter painter(this);
  painter.setRenderHint(QPainter::Antialiasing);
  painter.setPen(Qt::NoPen);
  const QRectF track(1.0, 0.5 * height() - 4.0, width() - 2.0, 8.0);
  const double middle = track.center().x(), half = 0.5 * track.width();
  painter.setBrush(quiet(0.3));
  painter.drawRoundedRect(track, 3, 3);
  painter.setBrush(ink(0.5));
  painter.drawRect(QRectF(middle - half * dead_zone_, track.top(), 2.0 * half * dead_zone_, track.height()));
  painter.setBrush(theme_.constraint);
  const double end = middle + half * share_;
  painter.drawRect(QRectF(QPointF(std::min(middle, end), track.top()), QPointF(std::max(middle, end), track.bottom())));
  painter.setPen(QPen(theme_.ink, 2.0));
  const double at = middle + (half - 1.0) * deflection_;
  painter.drawLine(QPointF(at, track.top() - 3.0), QPointF(at, track.bottom() + 3.0));
}

}  // namespace underact::gui
