#include "app/gui/replay/session_data.h"

#include "core/base/units.h"

namespace underact::gui {

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
  if (rows_.size() >= most_rows_) halve();
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
