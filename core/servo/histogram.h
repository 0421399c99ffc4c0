#pragma once
#include <array>
#include <cstdint>

namespace underact::servo {

struct Percentiles {
  double p50_us = 0.0;
  double p99_us = 0.0;
  double p999_us = 0.0;
  double max_us = 0.0;
};

/// Counts of durations, each within 1/32 of its value; 0 to 68 s. Not for two threads at once.
class Histogram {
 public:
  void add(std::int64_t duration_ns) noexcept;
  void add(const Histogram& other) noexcept;
  void clear() noexcept { *this = Histogram{}; }
  std::int64_t count() const noexcept { return count_; }
  /// The upper edge of the bucket that holds each share; the maximum exactly. All 0 while empty.
  Percentiles percentiles() const noexcept;
  /// How many durations are above from_ns and at most to_ns, to within a bucket.
  std::int64_t between(std::int64_t from_ns, std::int64_t to_ns) const noexcept;

 private:
  static constexpr int kSteps = 32;  // buckets an octave
  static constexpr int kOctaves = 32;
  std::array<std::int64_t, static_cast<std::size_t>(kSteps) * kOctaves> counts_{};
  std::int64_t count_ = 0;
  std::int64_t max_ns_ = 0;
};

}  // namespace underact::servo
