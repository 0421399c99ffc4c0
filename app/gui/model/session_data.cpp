#include "app/gui/model/session_data.h"

#include <algorithm>

#include "core/base/units.h"

namespace underact::gui {
namespace {

constexpr std::size_t kMaxPathPoints = 8000;
constexpr double kFinest_mm = 0.2, kCoarser = 1.5;  // between two points of the path

}  // namespace

std::vector<PathPoint> pathOf(const std::vector<SessionRow>& rows, std::size_t max) {
  for (double step_mm = kFinest_mm;; step_mm *= kCoarser) {
    std::vector<PathPoint> path;
    double greatest_N = 0.0;
    for (const SessionRow& row : rows) {
      const Vec3 p_mm(row.p_mm[0], row.p_mm[1], row.p_mm[2]);
      greatest_N = std::max(greatest_N, static_cast<double>(row.plot.sent_N));
      if (!p_mm.allFinite()) continue;
      if (!path.empty() && (p_mm - path.back().p_mm).norm() < step_mm) continue;
      path.push_back({p_mm, greatest_N});
      greatest_N = 0.0;
      if (path.size() > max) break;
    }
    if (path.size() <= max) return path;
  }
}

void SessionData::finish(double rate_hz) {
  std::vector<float> force_N, error_mm;
  force_N.reserve(rows_.size());
  error_mm.reserve(rows_.size());
  for (const SessionRow& row : rows_) {
    force_N.push_back(row.plot.sent_N);
    error_mm.push_back(row.plot.error_mm);
  }
  const double each_hz = rate_hz / static_cast<double>(ticks_per_row_);
  force_spectrum_ = spectrumOf(force_N, each_hz);
  error_spectrum_ = spectrumOf(error_mm, each_hz);
  path_ = pathOf(rows_, kMaxPathPoints);
}

void SessionData::add(std::int64_t row, double rate_hz, const servo::TickRecord& record) {
  lateness_.add(record.lateness_ns);
  SessionRow fresh;
  fresh.plot = plotRowOf(record);
  fresh.plot.time_s = static_cast<double>(row) / rate_hz;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    fresh.p_mm[axis] = static_cast<float>(kMillimetrePerMetre * record.p_WT[static_cast<Eigen::Index>(axis)]);
  }
  const std::int64_t group = row / ticks_per_row_;
  if (group == group_ && !rows_.empty()) {
    if (fresh.plot.sent_N > rows_.back().plot.sent_N) rows_.back() = fresh;
    return;
  }
  if (rows_.size() >= max_rows_) halve();
  group_ = row / ticks_per_row_;
  rows_.push_back(fresh);
}

void SessionData::halve() {
  for (std::size_t pair = 0; pair < rows_.size() / 2; ++pair) {
    const SessionRow &one = rows_[2 * pair], &other = rows_[2 * pair + 1];
    rows_[pair] = other.plot.sent_N > one.plot.sent_N ? other : one;
  }
  rows_.resize(rows_.size() / 2);
  ticks_per_row_ *= 2;
}

}  // namespace underact::gui
