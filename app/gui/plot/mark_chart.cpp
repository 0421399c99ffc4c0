#include "app/gui/plot/mark_chart.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "app/gui/kit/accessible_widgets.h"

namespace underact::gui {
namespace {

constexpr double kDefaultLine = 14.0;  // the height of a line of text of the usual size
constexpr double kMarkGap = 4.0;

double shareOf(const MarkSheet::Axis& axis, double value) {
  const double from = axis.from, to = axis.to;
  return axis.is_logarithmic ? std::log(value / from) / std::log(to / from) : (value - from) / (to - from);
}

/// 1, 2 and 5 times the powers of ten within the axis; if they are too many, the powers alone.
std::vector<double> ticksIn(const MarkSheet::Axis& axis, double room, double room_a_tick) {
  if (axis.text == nullptr) return {};
  const auto all = [&](std::initializer_list<double> steps) {
    std::vector<double> ticks;
    for (int power = static_cast<int>(std::floor(std::log10(axis.from))); std::pow(10.0, power) <= axis.to; ++power) {
      for (const double step : steps) {
        const double tick = step * std::pow(10.0, power);
        if (tick >= axis.from && tick <= axis.to) ticks.push_back(tick);
      }
    }
    return ticks;
  };
  const std::vector<double> fine = all({1.0, 2.0, 5.0});
  return static_cast<double>(fine.size()) * room_a_tick <= room ? fine : all({1.0});
}

}  // namespace

MarkSheet::Axis MarkSheet::around(const std::vector<double>& values, double room) {
  const auto [min, max] = std::minmax_element(values.begin(), values.end());
  return {.from = *min / room, .to = *max * room, .is_logarithmic = true};
}

MarkChart::MarkChart(const QString& name, const QString& spoken, const QString& tip, const QSize& min, QWidget* parent)
    : Painted(name, spoken, tip, parent), min_(min) {
  setAccessibleRole(this, QAccessible::Chart);
  setSizePolicy(QSizePolicy::Expanding, QSizePolicy::MinimumExpanding);
}

void MarkChart::present(MarkSheet sheet) {
  sheet_ = std::move(sheet);
  setAccessibleDescription(sheet_.spoken);
  update();
}

QSize MarkChart::minimumSizeHint() const {
  return {min_.width() * fontMetrics().averageCharWidth() + 96, min_.height() * fontMetrics().lineSpacing()};
}

// With room for a label to the left, the title of y above, and words and the key below.
QRectF MarkChart::axes() const {
  const double left = fontMetrics().horizontalAdvance(sheet_.widest) + 8.0, top = lineHeight() + kMarkGap;
  const double below = (sheet_.word_lines + sheet_.key_lines) * lineHeight() + (sheet_.word_lines + 1) * kMarkGap;
  return {left, top, width() - left - 8.0, height() - top - below};
}

QPointF MarkChart::placeOf(const QPointF& at) const {
  const QRectF area = axes();
  return {area.left() + area.width() * shareOf(sheet_.x, at.x()),
          area.bottom() - area.height() * shareOf(sheet_.y, at.y())};
}

void MarkChart::paintEvent(QPaintEvent*) {
  if (sheet_.y.text == nullptr) return;
  QPainter painter(this);
  painter.setRenderHint(QPainter::Antialiasing);
  drawAxes(painter);
  drawBand(painter);
  drawMarks(painter);
}

void MarkChart::drawAxes(QPainter& painter) const {
  const QRectF area = axes();
  const double line = lineHeight(), room = fontMetrics().horizontalAdvance(sheet_.widest) + 8.0;
  const double below = area.bottom() + kMarkGap, key = below + sheet_.word_lines * line + kMarkGap;
  const QPen grid(quiet(0.6), 1.0), text(ink(0.75));
  for (const double tick : ticksIn(sheet_.y, area.height(), sheet_.y.lines_a_tick * line)) {
    const double y = placeOf({sheet_.x.from, tick}).y();
    painter.setPen(grid);
    painter.drawLine(QPointF(area.left(), y), QPointF(area.right(), y));
    painter.setPen(text);
    painter.drawText(QRectF(0.0, y - 0.5 * line, area.left() - 6.0, line), Qt::AlignRight | Qt::AlignVCenter,
                     sheet_.y.text(tick));
  }
  for (const double tick : ticksIn(sheet_.x, area.width(), room)) {
    const double x = placeOf({tick, sheet_.y.from}).x();
    painter.setPen(grid);
    painter.drawLine(QPointF(x, area.top()), QPointF(x, area.bottom()));
    painter.setPen(text);
    const double left = std::clamp(x - 0.5 * room, 0.0, std::max(0.0, width() - room));
    painter.drawText(QRectF(left, below, room, line), Qt::AlignHCenter, sheet_.x.text(tick));
  }
  painter.setPen(text);
  painter.drawText(QRectF(0.0, 0.0, width(), line), Qt::AlignLeft, sheet_.y_title);
  for (const MarkSheet::Word& word : sheet_.words)
    painter.drawText(QRectF(area.left(), below + word.line * line, area.width(), line), word.side | Qt::TextDontClip,
                     word.text);
  painter.drawText(QRectF(0.0, key, width(), height() - key), Qt::AlignHCenter | Qt::TextWordWrap, sheet_.key);
}

void MarkChart::drawBand(QPainter& painter) const {
  if (!sheet_.band) return;
  const QRectF area = axes();
  const auto y = [this](double value) { return placeOf({sheet_.x.from, value}).y(); };
  const QRectF all(QPointF(area.left(), y(sheet_.band->high)), QPointF(area.right(), y(sheet_.band->low)));
  painter.fillRect(all.intersected(area), faint(theme_.target, 0.18));
  painter.setPen(QPen(theme_.target, 1.5));
  painter.drawLine(QPointF(area.left(), y(sheet_.band->middle)), QPointF(area.right(), y(sheet_.band->middle)));
}

void MarkChart::drawMarks(QPainter& painter) const {
  std::vector<QPointF> path;
  for (const QPointF& at : sheet_.path) path.push_back(placeOf(at));
  painter.setBrush(Qt::NoBrush);
  painter.setPen(QPen(colourOf(sheet_.path_line), sheet_.path_width));
  painter.drawPolyline(path.data(), static_cast<int>(path.size()));
  const double unit = sheet_.marks_grow ? lineHeight() / kDefaultLine : 1.0;
  for (const MarkSheet::Mark& mark : sheet_.marks) {
    const double half = mark.half * unit;
    painter.setPen(QPen(colourOf(mark.line), mark.line_width));
    painter.setBrush(mark.fill ? QBrush(colourOf(*mark.fill)) : QBrush(Qt::NoBrush));
    if (mark.is_square)
      painter.drawRect(QRectF(placeOf(mark.at) - QPointF(half, half), QSizeF(2.0 * half, 2.0 * half)));
    else
      painter.drawEllipse(placeOf(mark.at), half, half);
  }
}

}  // namespace underact::gui
