#include "core/lab/stopwatch.h"

#include <algorithm>
#include <chrono>
#include <cmath>

namespace underact::lab {

std::int64_t Stopwatch::now_ns() {
  return std::chrono::duration_cast<std::chrono::nanoseconds>(std::chrono::steady_clock::now().time_since_epoch())
      .count();
}

Stopwatch::Stopwatch(std::size_t times) : reading_ns_(1'000'000) {
  times_ns_.reserve(times);
  for (int n = 0; n < 1000; ++n) {
    const std::int64_t start_ns = now_ns();
    reading_ns_ = std::min(reading_ns_, now_ns() - start_ns);
  }
}

void Stopwatch::add(std::int64_t took_ns) {
  times_ns_.push_back(static_cast<double>(std::max<std::int64_t>(0, took_ns - reading_ns_)));
}

Cost Stopwatch::cost() const {
  if (times_ns_.empty()) return {};
  return {quantile(times_ns_, 0.5), quantile(times_ns_, 0.99), quantile(times_ns_, 1.0)};
}

double quantile(std::vector<double> values, double share) {
  const auto within = static_cast<std::ptrdiff_t>(std::ceil(share * static_cast<double>(values.size())));
  const auto at = values.begin() + std::max<std::ptrdiff_t>(within, 1) - 1;
  std::nth_element(values.begin(), at, values.end());
  return *at;
}

}  // namespace underact::lab
