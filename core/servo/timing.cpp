#include "core/servo/timing.h"

namespace underact::servo {

void Timing::add(const TickRecord& record) noexcept {
  lateness_.add(record.lateness_ns);
  tick_time_.add(record.tick_ns);
  if (lately_[in_use_].count() >= ticks_a_second_) {
    in_use_ = (in_use_ + 1) % kSeconds;
    lately_[in_use_].clear();
  }
  lately_[in_use_].add(record.lateness_ns);
}

Percentiles Timing::lateLately() const noexcept {
  Histogram all;
  for (const Histogram& second : lately_) all.add(second);
  return all.percentiles();
}

}  // namespace underact::servo
