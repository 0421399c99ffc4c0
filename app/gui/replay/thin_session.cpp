#include "app/gui/replay/thin_session.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace underact::gui {
namespace {

/// Calls part(first, last + 1) for each of `parts` ranges of equal size.
template <class Part>
void eachPart(std::size_t size, std::size_t parts, Part part) {
  const std::size_t count = std::max<std::size_t>(std::min(size, parts), 1);
  for (std::size_t index = 0; index < count; ++index) part(index * size / count, (index + 1) * size / count);
}

}  // namespace

std::size_t thinSession(const std::vector<SessionRow>& rows, const std::function<float(const SessionRow&)>& value,
                        std::size_t columns, float largest_step, std::span<PlotPoint> points) {
  std::size_t used = 0;
  const auto put = [&](const PlotPoint& point) {
    const bool is_broken = used > 0 && std::abs(point.y - points[used - 1].y) > largest_step;
    if (used + (is_broken ? 2 : 1) > points.size()) return;
    if (is_broken) points[used++] = {point.x, std::numeric_limits<float>::quiet_NaN()};
    points[used++] = point;
  };
  eachPart(rows.size(), columns, [&](std::size_t from, std::size_t to) {
    PlotPoint min, greatest;
    bool has_one = false;
    for (std::size_t index = from; index < to; ++index) {
      const PlotPoint point{static_cast<float>(rows[index].plot.time_s), value(rows[index])};
      if (!std::isfinite(point.y)) continue;
      if (!has_one || point.y < min.y) min = point;
      if (!has_one || point.y > greatest.y) greatest = point;
      has_one = true;
    }
    if (!has_one) return;
    put(min.x <= greatest.x ? min : greatest);
    if (min.x != greatest.x) put(min.x <= greatest.x ? greatest : min);
  });
  repeatLast(points, used);
  return used;
}

std::size_t thinSessionPath(const std::vector<SessionRow>& rows, std::size_t axis, std::size_t groups,
                            std::span<PlotPoint> points) {
  std::size_t used = 0;
  eachPart(rows.size(), groups, [&](std::size_t from, std::size_t to) {
    std::array<std::pair<std::size_t, PlotPoint>, 4> extremes;  // leftmost, rightmost, lowest, highest
    bool has_one = false;
    for (std::size_t index = from; index < to; ++index) {
      const PlotPoint point{rows[index].plot.away_mm[axis], rows[index].plot.force_N[axis]};
      if (!std::isfinite(point.x) || !std::isfinite(point.y)) continue;
      if (!has_one) extremes.fill({index, point});
      has_one = true;
      if (point.x < extremes[0].second.x) extremes[0] = {index, point};
      if (point.x > extremes[1].second.x) extremes[1] = {index, point};
      if (point.y < extremes[2].second.y) extremes[2] = {index, point};
      if (point.y > extremes[3].second.y) extremes[3] = {index, point};
    }
    if (!has_one || used + 4 > points.size()) return;
    std::sort(extremes.begin(), extremes.end(), [](const auto& a, const auto& b) { return a.first < b.first; });
    for (std::size_t one = 0; one < extremes.size(); ++one) {
      if (one == 0 || extremes[one].first != extremes[one - 1].first) points[used++] = extremes[one].second;
    }
  });
  repeatLast(points, used);
  return used;
}

}  // namespace underact::gui
