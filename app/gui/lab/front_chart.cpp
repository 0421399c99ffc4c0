#include "app/gui/lab/front_chart.h"

#include <algorithm>
#include <cmath>

#include "app/gui/lab/lab_words.h"

namespace underact::gui {
namespace {

constexpr double kLeastError_mm = 1e-6;                   // what is exact stands at the bottom: a logarithm has no zero
constexpr double kDot = 3.0, kSquare = 5.0, kRing = 8.0;  // with lines of text of the usual height
constexpr double kUsualLine = 14.0;
constexpr double kRoom = 1.25;  // beyond the outermost points
const QString kWidest = "500 µm";

/// 1, 2 and 5 times the powers of ten within the scale; where they are many, the powers alone.
std::vector<double> ticksIn(double least, double most, std::size_t at_most) {
  const auto all = [&](std::initializer_list<double> steps) {
    std::vector<double> ticks;
    for (int power = static_cast<int>(std::floor(std::log10(least))); std::pow(10.0, power) <= most; ++power) {
      for (const double step : steps) {
        const double tick = step * std::pow(10.0, power);
        if (tick >= least && tick <= most) ticks.push_back(tick);
      }
    }
    return ticks;
  };
  const std::vector<double> fine = all({1.0, 2.0, 5.0});
  return fine.size() <= at_most ? fine : all({1.0});
}

}  // namespace

FrontChart::FrontChart(QWidget* parent)
    : MarkChart(
          "panel.lab.chart", tr("Error of the tip's way against processor time"),
          tr("Every way to run this scene: what a second of it takes, tick and simulated arm, and how far the tip is "
             "off its way at 16 kHz, root of the mean square over all hands. The front is what nothing beats in "
             "both."),
          parent) {}

QSize FrontChart::minimumSizeHint() const {
  return {14 * fontMetrics().averageCharWidth() + 96, 14 * fontMetrics().lineSpacing()};
}

void FrontChart::present(const std::vector<trade::Point>& points, const std::optional<std::size_t>& chosen) {
  points_ = points;
  chosen_ = chosen;
  if (!points_.empty()) {
    cost_ = {points_.front().cost_us_per_s, points_.front().cost_us_per_s};
    error_ = {points_.front().error_mm, points_.front().error_mm};
  }
  for (const trade::Point& point : points_) {
    cost_ = {std::min(cost_.least, point.cost_us_per_s), std::max(cost_.most, point.cost_us_per_s)};
    error_ = {std::min(error_.least, point.error_mm), std::max(error_.most, point.error_mm)};
  }
  cost_ = {std::max(cost_.least, 1e-3) / kRoom, std::max(cost_.most, 1e-3) * kRoom};
  error_ = {std::max(error_.least, kLeastError_mm) / kRoom, std::max(error_.most, kLeastError_mm) * kRoom};
  const auto on_front = std::count_if(points_.begin(), points_.end(), [](const auto& one) { return one.on_front; });
  setAccessibleDescription(points_.empty() ? tr("Nothing is measured.")
                                           : tr("%1 ways, %2 on the front; %3")
                                                 .arg(points_.size())
                                                 .arg(on_front)
                                                 .arg(chosen_ ? tr("chosen: %1 a second, error %2")
                                                                    .arg(timeText(points_[*chosen_].cost_us_per_s),
                                                                         lengthText(points_[*chosen_].error_mm))
                                                              : tr("none of them is in effect")));
  update();
}

QRectF FrontChart::plot() const {
  return axes(kWidest, 4.0 * lineHeight() + 12.0);
}

double FrontChart::xOf(double us_per_s) const {
  return plot().left() + plot().width() * cost_.shareOf(std::max(us_per_s, cost_.least));
}

double FrontChart::yOf(double error_mm) const {
  return plot().bottom() - plot().height() * error_.shareOf(std::max(error_mm, kLeastError_mm));
}

QPointF FrontChart::at(const trade::Point& point) const {
  return {xOf(point.cost_us_per_s), yOf(point.error_mm)};
}

void FrontChart::paintEvent(QPaintEvent*) {
  if (points_.empty()) return;
  QPainter painter(this);
  painter.setRenderHint(QPainter::Antialiasing);
  drawAxes(painter);
  drawKey(painter);
  drawFront(painter);
  drawPoints(painter);
}

void FrontChart::drawAxes(QPainter& painter) const {
  const double line = lineHeight();
  const auto room = static_cast<double>(fontMetrics().horizontalAdvance(kWidest)) + 8.0;
  drawTitle(painter, tr("error of the tip's way"));
  painter.drawText(QRectF(0.0, plot().bottom() + line + 4.0, plot().right(), line), Qt::AlignRight,
                   tr("processor time for a second"));
  for (const double tick : ticksIn(error_.least, error_.most, static_cast<std::size_t>(plot().height() / (1.5 * line))))
    drawLevel(painter, plot(), yOf(tick), lengthText(tick));
  for (const double tick : ticksIn(cost_.least, cost_.most, static_cast<std::size_t>(plot().width() / room))) {
    painter.setPen(gridPen());
    painter.drawLine(QPointF(xOf(tick), plot().top()), QPointF(xOf(tick), plot().bottom()));
    painter.setPen(ink(0.75));
    const double left = std::clamp(xOf(tick) - 0.5 * room, 0.0, std::max(0.0, width() - room));
    painter.drawText(QRectF(left, plot().bottom() + 4.0, room, line), Qt::AlignHCenter, timeText(tick));
  }
}

void FrontChart::drawKey(QPainter& painter) const {
  painter.setPen(ink(0.75));
  const double top = plot().bottom() + 2.0 * lineHeight() + 8.0;
  painter.drawText(QRectF(0.0, top, width(), height() - top), Qt::AlignHCenter | Qt::TextWordWrap,
                   tr("○ a way  ● on the front  ■ as it was  ◎ chosen"));
}

void FrontChart::drawFront(QPainter& painter) const {
  std::vector<QPointF> way;
  for (const trade::Point& point : points_) {
    if (point.on_front) way.push_back(at(point));
  }
  drawWay(painter, way, QPen(theme_.constraint, 2.0));
}

void FrontChart::drawPoints(QPainter& painter) const {
  const QColor ground = palette().color(QPalette::Window);
  const double unit = lineHeight() / kUsualLine;
  for (const bool on_front : {false, true}) {  // those that matter lie on top
    painter.setPen(QPen(on_front ? theme_.constraint : ink(0.55), 1.2));
    painter.setBrush(on_front ? theme_.constraint : ground);
    for (const trade::Point& point : points_) {
      if (point.on_front == on_front) painter.drawEllipse(at(point), kDot * unit, kDot * unit);
    }
  }
  for (const trade::Point& point : points_) {
    if (!point.is_own) continue;
    painter.setPen(QPen(ground, 1.0));
    painter.setBrush(theme_.target);
    const double half = kSquare * unit;
    painter.drawRect(QRectF(at(point) - QPointF(half, half), QSizeF(2.0 * half, 2.0 * half)));
  }
  if (!chosen_) return;
  painter.setBrush(Qt::NoBrush);
  painter.setPen(QPen(theme_.ink, 2.0));
  painter.drawEllipse(at(points_[*chosen_]), kRing * unit, kRing * unit);
}

}  // namespace underact::gui
