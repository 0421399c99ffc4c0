#include "app/gui/model/plot_history.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/base/units.h"

namespace underact::gui {
namespace {

constexpr std::size_t kRoomAtFirst = 1024;

float onScreen(double value, double factor) {
  return static_cast<float>(factor * value);
}

std::size_t thin(const PlotHistory& history, float PlotRow::*value, std::size_t columns, std::span<PlotPoint> points,
                 float largest_step) {
  const double column_s = PlotHistory::kSpan_s / static_cast<double>(std::max<std::size_t>(columns, 1));
  return thinRows(
      history.size(), [&](std::size_t row) { return history.row(row).time_s; },
      [&](std::size_t row) { return history.row(row).*value; }, column_s, -history.newest_s(), largest_step, points);
}

}  // namespace

void repeatLast(std::span<PlotPoint> points, std::size_t used) {
  const PlotPoint last = used > 0 ? points[used - 1] : PlotPoint{};
  std::fill(points.begin() + static_cast<std::ptrdiff_t>(used), points.end(), last);
}

PlotRow plotRowOf(const servo::TickRecord& record) {
  PlotRow fresh;
  fresh.time_s = kSecondPerNanosecond * static_cast<double>(record.time_ns);
  fresh.error_mm = onScreen(record.error_m, kMillimetrePerMetre);
  fresh.asked_N = onScreen(record.f_asked_T_W.norm(), 1.0);
  fresh.sent_N = onScreen(record.f_sent_T_W.norm(), 1.0);
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const auto index = static_cast<Eigen::Index>(axis);
    fresh.away_mm[axis] = onScreen(record.p_WT[index] - record.p_WP[index], kMillimetrePerMetre);
    fresh.force_N[axis] = onScreen(record.f_sent_T_W[index], 1.0);
  }
  fresh.alpha_deg = onScreen(record.angles.alpha_rad, 1.0 / kRadPerDegree);
  fresh.beta_deg = onScreen(record.angles.beta_rad, 1.0 / kRadPerDegree);
  fresh.theta_deg = onScreen(record.angles.theta_rad, 1.0 / kRadPerDegree);
  fresh.energy_mJ = onScreen(record.energy_J, 1e3);
  fresh.passive_N = onScreen(record.passive_N, 1.0);
  return fresh;
}

void PlotHistory::clear() {
  first_ = size_ = 0;
}

void PlotHistory::add(const servo::TickRecord& record, const RecordedBeside& recorded) {
  PlotRow fresh = plotRowOf(record);
  fresh.recorded_error_mm = recorded.error_mm;
  fresh.recorded_N = recorded.force_N;
  if (size_ > 0 && fresh.time_s < newest_s()) clear();
  while (size_ > 0 && (size_ == kCapacity || row(0).time_s < fresh.time_s - kSpan_s)) {
    first_ = (first_ + 1) % rows_.size();
    --size_;
  }
  if (size_ == rows_.size()) grow();
  rows_[(first_ + size_) % rows_.size()] = fresh;
  ++size_;
}

void PlotHistory::grow() {
  std::rotate(rows_.begin(), rows_.begin() + static_cast<std::ptrdiff_t>(first_), rows_.end());
  first_ = 0;
  rows_.resize(std::clamp(2 * rows_.size(), kRoomAtFirst, kCapacity));
}

std::size_t thinByTime(const PlotHistory& history, float PlotRow::*value, std::size_t columns,
                       std::span<PlotPoint> points) {
  return thin(history, value, columns, points, std::numeric_limits<float>::infinity());
}

std::size_t thinAngle(const PlotHistory& history, float PlotRow::*value_deg, std::size_t columns,
                      std::span<PlotPoint> points) {
  return thin(history, value_deg, columns, points, 180.0F);
}

std::size_t strokesBelowZero(std::span<const PlotPoint> line, std::span<PlotPoint> points) {
  std::size_t used = 0;
  for (const PlotPoint& point : line) {
    if (!(point.y < 0.0F) || used + 3 > points.size()) continue;
    points[used++] = {point.x, 0.0F};
    points[used++] = point;
    points[used++] = {point.x, std::numeric_limits<float>::quiet_NaN()};
  }
  repeatLast(points, used);
  return used;
}

std::size_t thinPath(const PlotHistory& history, std::size_t axis, std::size_t groups, std::span<PlotPoint> points) {
  const double group_s = PlotHistory::kSpan_s / static_cast<double>(std::max<std::size_t>(groups, 1));
  std::size_t used = 0;
  double group_end_s = -1.0;
  std::array<std::pair<std::size_t, PlotPoint>, 4> extremes;  // leftmost, rightmost, lowest, highest, and when
  const auto close = [&] {
    if (group_end_s < 0.0 || used + 4 > points.size()) return;
    std::sort(extremes.begin(), extremes.end(), [](const auto& a, const auto& b) { return a.first < b.first; });
    for (std::size_t one = 0; one < extremes.size(); ++one) {
      if (one == 0 || extremes[one].first != extremes[one - 1].first) points[used++] = extremes[one].second;
    }
  };
  for (std::size_t index = 0; index < history.size(); ++index) {
    const PlotRow& row = history.row(index);
    const PlotPoint point{row.away_mm[axis], row.force_N[axis]};
    if (!std::isfinite(point.x) || !std::isfinite(point.y)) continue;
    if (row.time_s >= group_end_s) {
      close();
      group_end_s = group_s * (std::floor(row.time_s / group_s) + 1.0);
      if (group_end_s <= row.time_s) group_end_s += group_s;
      extremes.fill({index, point});
      continue;
    }
    if (point.x < extremes[0].second.x) extremes[0] = {index, point};
    if (point.x > extremes[1].second.x) extremes[1] = {index, point};
    if (point.y < extremes[2].second.y) extremes[2] = {index, point};
    if (point.y > extremes[3].second.y) extremes[3] = {index, point};
  }
  close();
  repeatLast(points, used);
  return used;
}

}  // namespace underact::gui
