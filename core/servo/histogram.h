#pragma once
#include <array>
#include <cstdint>

namespace underact::servo {

/// Durations that 50, 99 and 99.9 % keep within, and the longest.
struct Percentiles {
  double p50_us = 0.0;
  double p99_us = 0.0;
  double p999_us = 0.0;
  double max_us = 0.0;
};

/// Counts of durations, each within 1/32 of its value; 0 to 34 s. Not for two threads at once.
class Histogram {
 public:
  /// A duration; below 0 it counts as 0, above 2^35 ns (34 s) as 2^35 ns.
  void add(std::int64_t duration_ns) noexcept;
  /// All durations of another one.
  void add(const Histogram& other) noexcept;
  /// As constructed.
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
