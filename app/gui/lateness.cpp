#include "app/gui/lateness.h"

#include <algorithm>

namespace underact::gui {

constexpr int kSeconds = 10;

Lateness::Lateness(int rate_hz) : ring_(static_cast<std::size_t>(rate_hz) * kSeconds) {}

void Lateness::add(std::int64_t lateness_ns) {
  ring_[next_] = lateness_ns;
  next_ = (next_ + 1) % ring_.size();
  full_ = full_ || next_ == 0;
}

double Lateness::percentile_us(double share) const {
  const std::size_t count = full_ ? ring_.size() : next_;
  if (count == 0) return 0.0;
  std::vector<std::int64_t> sorted(ring_.begin(), ring_.begin() + static_cast<std::ptrdiff_t>(count));
  const auto rank = static_cast<std::ptrdiff_t>(share * static_cast<double>(count - 1));
  std::nth_element(sorted.begin(), sorted.begin() + rank, sorted.end());
  return 1e-3 * static_cast<double>(sorted[static_cast<std::size_t>(rank)]);
}

}  // namespace underact::gui
