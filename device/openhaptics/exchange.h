#pragma once
#include <atomic>
#include <cstdint>

#include "core/arm/sample.h"
#include "core/base/real_time.h"
#include "core/base/types.h"
#include "core/servo/slot.h"

namespace underact::device::openhaptics {

/// Between the servo and the arm's own scheduler: the newest sample one way, the newest force the other. Both may be
/// the same thread, or two; neither waits.
class Exchange {
 public:
  // The servo's side.
  /// false: there is no new one. A button that was pressed and released since the last read shows as pressed once.
  bool read(arm::Sample& sample) noexcept UNDERACT_REAL_TIME;
  void write(const Vec3& f_T_W) noexcept UNDERACT_REAL_TIME;
  /// Any thread; lasts until the next write().
  void cut() noexcept UNDERACT_REAL_TIME;

  // The arm's side.
  /// pressed: buttons that went down in this period.
  void offer(const arm::Sample& sample, std::uint32_t pressed) noexcept UNDERACT_REAL_TIME;
  /// The force of this period; zero if it was cut, if nothing was written for more than kStalePeriods, or if it answers
  /// a sample of another epoch.
  Vec3 wanted(std::uint32_t epoch) noexcept UNDERACT_REAL_TIME;

  static constexpr int kStalePeriods = 4;  // zero comes with the fifth

 private:
  struct Force {
    Vec3 f_T_W = Vec3::Zero();
    std::uint32_t epoch = 0;  // of the sample that it answers
  };
  servo::Slot<arm::Sample> samples_;
  std::atomic<std::uint32_t> pressed_{0};
  std::int64_t given_ns_ = -1;  // the last sample that was read
  std::uint32_t given_epoch_ = 0;
  servo::Slot<Force> forces_;
  std::atomic<std::int64_t> writes_{0};
  std::atomic<bool> is_cut_{true};
  std::int64_t seen_writes_ = 0;
  int stale_ = 0;
};

}  // namespace underact::device::openhaptics
