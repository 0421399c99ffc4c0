#pragma once
#include <array>
#include <cstddef>
#include <cstdint>

namespace underact::servo {

/// The delay before a process that ended is started again: nearly none at first, doubled each time, and at most kMax
/// starts within kWindow_ns, so that one that dies at once costs nothing. A process that lasted resets it.
class RestartPace {
 public:
  static constexpr int kMax = 6;
  static constexpr std::int64_t kWindow_ns = 60'000'000'000;
  static constexpr std::int64_t kFirst_ns = 20'000'000;

  /// It ended at now_ns, or did not start: gives when to start it, on the same clock, and counts that start.
  std::int64_t next_ns(std::int64_t now_ns) noexcept;

 private:
  std::array<std::int64_t, kMax> starts_ns_{};  // a ring
  std::size_t oldest_ = 0, count_ = 0;
};

}  // namespace underact::servo
