#pragma once
#include <atomic>
#include <cstdint>
#include <string>

#include "core/base/sentence.h"

namespace underact::device::openhaptics {

/// What keeps the force at zero, or falsifies it, passed from the arm's scheduler to any thread.
class ArmStatus {
 public:
  // The arm's scheduler.
  /// The arm has stopped for good; the first code stays.
  void stop(std::uint32_t code) noexcept;
  void calibration(std::uint32_t status, std::uint32_t style) noexcept;
  void docked(bool is) noexcept { docked_.store(is, std::memory_order_relaxed); }
  /// The distance between the arm's own tip position and the model's; wrong: so far that its forces would mislead.
  void deviation(double off_m, bool wrong) noexcept;
  void forceError(std::uint32_t code, int count, std::int64_t now_ns) noexcept;
  /// Periods in a row without a sample, and why. 0: there was one.
  void withoutSample(int periods, std::uint32_t code) noexcept;

  // Any thread.
  void begin() noexcept;  // no trouble is known
  bool stopped() const noexcept { return stop_.load(std::memory_order_acquire) != 0; }
  std::int64_t forceErrors() const noexcept { return force_errors_.load(std::memory_order_relaxed); }
  /// The worst of it as a sentence; empty: nothing. arm: the model's name.
  Sentence sentence(std::int64_t now_ns, const std::string& arm) const;

 private:
  std::atomic<std::uint32_t> stop_{0};
  std::atomic<std::uint64_t> calibration_{0};  // status and style, in one to stay consistent
  std::atomic<bool> docked_{false};
  std::atomic<double> off_m_{0.0};
  std::atomic<bool> wrong_{false};
  std::atomic<std::int64_t> force_errors_{0};
  std::atomic<std::uint32_t> force_code_{0};
  std::atomic<std::int64_t> force_error_ns_{0};
  std::atomic<int> without_sample_{0};
  std::atomic<std::uint32_t> sample_code_{0};
};

}  // namespace underact::device::openhaptics
