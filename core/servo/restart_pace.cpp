#include "core/servo/restart_pace.h"

#include <algorithm>

namespace underact::servo {

std::int64_t RestartPace::next_ns(std::int64_t now_ns) noexcept {
  for (; count_ > 0 && now_ns - starts_ns_[oldest_] >= kWindow_ns; --count_) oldest_ = (oldest_ + 1) % kMax;
  std::int64_t next_ns = now_ns + (kFirst_ns << count_);
  if (count_ == kMax) {
    next_ns = std::max(next_ns, starts_ns_[oldest_] + kWindow_ns);
    oldest_ = (oldest_ + 1) % kMax;
    --count_;
  }
  starts_ns_[(oldest_ + count_) % kMax] = next_ns;
  ++count_;
  return next_ns;
}

}  // namespace underact::servo
