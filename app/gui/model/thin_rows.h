#pragma once
#include <cmath>
#include <cstddef>
#include <limits>
#include <span>

namespace underact::gui {

/// A point of a curve. As two floats in a row, since that is what GL draws.
struct PlotPoint {
  float x = 0.0F, y = 0.0F;
};

/// Sets the points from `used` on to the one before, so that nothing else is drawn.
void repeatLast(std::span<PlotPoint> points, std::size_t used);

/// Rows in order of time, thinned by the least and the greatest value of each interval of part_s: a spike of one row
/// stays. The intervals are fixed as time passes. time_s(row), value(row): of row 0 to count - 1; what is not finite is
/// passed over. shift_s: added to each time. largest_step: a larger step breaks the line. points: unused ones repeat
/// the last. Returns the number used.
template <class Time, class Value>
std::size_t thinRows(std::size_t count, Time time_s, Value value, double part_s, double shift_s, float largest_step,
                     std::span<PlotPoint> points) {
  std::size_t used = 0;
  bool has_part = false;
  double part_end_s = 0.0;
  PlotPoint min, greatest;
  const auto put = [&](const PlotPoint& point) {
    const bool broken = used > 0 && std::abs(point.y - points[used - 1].y) > largest_step;
    if (used + (broken ? 2 : 1) > points.size()) return;
    if (broken) points[used++] = {point.x, std::numeric_limits<float>::quiet_NaN()};
    points[used++] = point;
  };
  const auto close = [&] {
    if (!has_part) return;
    put(min.x <= greatest.x ? min : greatest);
    if (min.x != greatest.x) put(min.x <= greatest.x ? greatest : min);
  };
  for (std::size_t row = 0; row < count; ++row) {
    const double now_s = time_s(row);
    const PlotPoint point{static_cast<float>(now_s + shift_s), value(row)};
    if (!std::isfinite(point.y)) continue;
    if (!has_part || now_s >= part_end_s) {
      close();
      has_part = true;
      part_end_s = part_s * (std::floor(now_s / part_s) + 1.0);
      if (part_end_s <= now_s) part_end_s += part_s;  // rounding at an interval's edge
      min = greatest = point;
    } else if (point.y < min.y) {
      min = point;
    } else if (point.y > greatest.y) {
      greatest = point;
    }
  }
  close();
  repeatLast(points, used);
  return used;
}

}  // namespace underact::gui
