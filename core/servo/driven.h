#pragma once
#include <atomic>
#include <condition_variable>
#include <cstdint>
#include <memory>
#include <mutex>
#include <thread>

#include "core/servo/loop.h"

namespace underact::servo {

/// Ticks a loop from an arm's own clock (see DevicePort::drive()), in the place of the servo's thread. What is late is
/// measured against a period after the tick before: the arm's deadlines are its own. Where that clock stands still, a
/// thread of ours ticks in its place now and then, without a sample, so that the servo finds its fault, takes up
/// commands, and everyone sees it.
class Driven final : public Ticks {
 public:
  /// patience_ns: how long the clock may be silent; 0 or less: 0.1 s. Null where the arm has no clock of its own.
  static std::unique_ptr<Driven> start(Loop& loop, DevicePort& device, int rate_hz, std::int64_t patience_ns = 0);
  ~Driven();  // the last tick is done, and zero force written
  Driven(const Driven&) = delete;
  Driven& operator=(const Driven&) = delete;

  void tick() noexcept UNDERACT_REAL_TIME override;

 private:
  Driven(Loop& loop, DevicePort& device, int rate_hz, std::int64_t patience_ns);
  void tickOnce(std::int64_t now_ns) noexcept UNDERACT_REAL_TIME;
  void standIn();

  Loop& loop_;
  DevicePort& device_;
  const std::int64_t period_ns_, patience_ns_;
  std::atomic<std::int64_t> heard_ns_;   // when the arm's clock called last
  std::atomic<bool> is_ticking_{false};  // by one of the two
  std::int64_t before_ns_ = 0;           // when the last tick began; of whoever ticks
  std::mutex mutex_;
  std::condition_variable wake_;
  bool ends_ = false;
  std::thread stand_in_;
};

}  // namespace underact::servo
