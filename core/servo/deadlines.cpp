#include "core/servo/deadlines.h"

#include <algorithm>

namespace underact::servo {

constexpr std::int64_t kRest_ns = 10'000;

std::int64_t Deadlines::wakeAt_ns(std::int64_t now_ns) const noexcept {
  return std::max(next_ns_, now_ns + kRest_ns);
}

Wake Deadlines::begin(std::int64_t now_ns) noexcept {
  Wake wake;
  wake.at_ns = now_ns;
  wake.lateness_ns = now_ns - next_ns_;
  wake.left_out = std::max<std::int64_t>(0, wake.lateness_ns / period_ns_);
  next_ns_ += (1 + wake.left_out) * period_ns_;
  return wake;
}

LateCause Deadlines::causeOf(const system::Interruptions& now) noexcept {
  const system::Interruptions before = counted_;
  counted_ = now;
  if (busy_ns_ >= period_ns_) return 2 * waiting_ns_ >= busy_ns_ ? LateCause::Device : LateCause::Overrun;
  if (now.page_faults > before.page_faults) return LateCause::PageFault;
  if (now.preemptions > before.preemptions) return LateCause::Preempted;
  return LateCause::Woken;
}

void Deadlines::end(std::int64_t busy_ns, std::int64_t waiting_ns) noexcept {
  busy_ns_ = busy_ns;
  waiting_ns_ = waiting_ns;
}

}  // namespace underact::servo
