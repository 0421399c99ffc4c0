// Of chart.h: what the cursor reads, and the points as text.
#include <QFontMetricsF>
#include <QPainter>
#include <algorithm>
#include <cmath>
#include <limits>

#include "app/gui/kit/number_box.h"
#include "app/gui/plot/chart.h"
#include "app/gui/plot/plot_range.h"

namespace underact::gui {
namespace {

constexpr double kRoom_px = 8.0, kDot_px = 3.0, kKey_px = 10.0;
constexpr int kDigits = 3;  // beyond those that tell two ticks apart: some hundredths of the axis

/// With as many decimals as a pixel of the axis can tell apart.
QString valueText(double value, double from, double to) {
  const double span = std::max(to - from, 1e-12);
  const int decimals = std::clamp(kDigits - 1 - static_cast<int>(std::floor(std::log10(span))), 0, 9);
  return localNumber(value, 'f', decimals).replace(QLatin1Char('-'), QChar(0x2212));
}

}  // namespace

QString Chart::nameOf(std::size_t curve) const {
  return curves_[curve].name.isEmpty() ? title_ : curves_[curve].name;
}

std::vector<Chart::Reading> Chart::readingsAt(const QPointF& place) const {
  std::vector<Reading> readings;
  for (std::size_t curve = 0; curve < curves_.size(); ++curve) {
    if (!isData(curve)) continue;
    double nearest = std::numeric_limits<double>::infinity();
    Reading reading;
    reading.name = nameOf(curve);
    reading.colour = colours_[curve];
    for (const PlotPoint& point : points_[curve]) {
      const QPointF there = placeOf(static_cast<double>(point.x), static_cast<double>(point.y));
      if (!std::isfinite(there.x()) || !std::isfinite(there.y())) continue;
      const double away =
          is_path_ ? std::hypot(there.x() - place.x(), there.y() - place.y()) : std::abs(there.x() - place.x());
      if (away >= nearest) continue;
      nearest = away;
      reading.x = static_cast<double>(point.x);
      reading.y = static_cast<double>(point.y);
      reading.place = there;
    }
    if (std::isfinite(nearest)) readings.push_back(reading);
  }
  return readings;
}

void Chart::paintReadings(QPainter& painter, const QPointF& place) const {
  if (!axes_.contains(place)) return;
  const std::vector<Reading> readings = readingsAt(place);
  painter.save();
  painter.setRenderHint(QPainter::Antialiasing);
  painter.setClipRect(axes_);
  painter.setPen(QPen(mixed(theme_.background, theme_.ink, 0.6), 1.0, Qt::DashLine));
  if (!is_path_) painter.drawLine(QPointF(place.x(), axes_.top()), QPointF(place.x(), axes_.bottom()));
  for (const Reading& reading : readings) {
    painter.setPen(QPen(theme_.background, 1.0));
    painter.setBrush(reading.colour);
    painter.drawEllipse(reading.place, kDot_px, kDot_px);
  }
  painter.setClipping(false);
  QStringList lines{QString("%1 %2").arg(
      x_title_, valueText(x_from_ + (place.x() - axes_.left()) / axes_.width() * (x_to_ - x_from_), x_from_, x_to_))};
  if (is_path_ && !readings.empty())
    lines = {QString("%1 %2").arg(x_title_, valueText(readings.front().x, x_from_, x_to_))};
  for (const Reading& reading : readings)
    lines << QString("%1 %2").arg(reading.name, valueText(reading.y, y_from_, y_to_));
  const QFontMetricsF metrics(font_);
  double width = 0.0;
  for (const QString& line : lines) width = std::max(width, metrics.horizontalAdvance(line));
  width += 2.0 * kRoom_px + kKey_px;
  const double height = metrics.height() * static_cast<double>(lines.size()) + kRoom_px;
  const bool at_left = place.x() + width + 2.0 * kRoom_px > area_.right();
  const double left = std::max(area_.left(), at_left ? place.x() - width - kRoom_px : place.x() + kRoom_px);
  const QRectF box(left, axes_.top() + 2.0, width, height);
  painter.setPen(QPen(theme_.quiet, 1.0));
  painter.setBrush(faint(theme_.background, 0.92));
  painter.drawRoundedRect(box, 3.0, 3.0);
  painter.setFont(font_);
  double base = box.top() + 0.5 * kRoom_px + metrics.ascent();
  for (qsizetype line = 0; line < lines.size(); ++line) {
    if (line > 0) {
      painter.fillRect(QRectF(box.left() + 0.5 * kRoom_px, base - 0.5 * metrics.ascent(), kKey_px - 2.0, 3.0),
                       readings[static_cast<std::size_t>(line - 1)].colour);
    }
    painter.setPen(theme_.ink);
    painter.drawText(QPointF(box.left() + 0.5 * kRoom_px + kKey_px + 2.0, base), lines[line]);
    base += metrics.height();
  }
  painter.restore();
}

QString Chart::asText(QChar separator) const {
  std::vector<std::vector<PlotPoint>> columns;
  QStringList head;
  for (std::size_t curve = 0; curve < curves_.size(); ++curve) {
    if (!isData(curve)) continue;
    std::vector<PlotPoint> kept;
    for (const PlotPoint& point : points_[curve]) {
      const bool is_seen = static_cast<double>(point.x) >= x_from_ && static_cast<double>(point.x) <= x_to_;
      const bool is_same = !kept.empty() && kept.back().x == point.x && kept.back().y == point.y;
      if (is_seen && !is_same && std::isfinite(point.y)) kept.push_back(point);
    }
    columns.push_back(std::move(kept));
    head << x_title_ << nameOf(curve);
  }
  QString text = head.join(separator) + QLatin1Char('\n');
  std::size_t rows = 0;
  for (const std::vector<PlotPoint>& column : columns) rows = std::max(rows, column.size());
  for (std::size_t row = 0; row < rows; ++row) {
    QStringList cells;
    for (const std::vector<PlotPoint>& column : columns) {
      const bool is_there = row < column.size();
      cells << (is_there ? QString::number(static_cast<double>(column[row].x), 'g', 9) : QString())
            << (is_there ? QString::number(static_cast<double>(column[row].y), 'g', 9) : QString());
    }
    text += cells.join(separator) + QLatin1Char('\n');
  }
  return text;
}

}  // namespace underact::gui
