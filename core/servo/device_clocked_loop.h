#pragma once
#include <atomic>
#include <condition_variable>
#include <cstdint>
#include <memory>
#include <mutex>
#include <thread>

#include "core/servo/loop.h"

namespace underact::servo {

/// Ticks a loop from an arm's own clock (see DevicePort::drive()), instead of the servo's thread. Latency is measured
/// against a period after the last tick, as the arm's deadlines are its own. While that clock stands still, a thread of
/// this class ticks now and then without a sample, so that the fault is found, commands are taken up, and the state
/// stays visible.
class DeviceClockedLoop final : public Ticks {
 public:
  /// patience_ns: how long the clock may be silent; 0 or less: 0.1 s. Null where the arm has no clock of its own.
  static std::unique_ptr<DeviceClockedLoop> start(ServoLoop& loop, DevicePort& device, int rate_hz,
                                                  std::int64_t patience_ns = 0);
  ~DeviceClockedLoop();  // the last tick is done, and zero force written
  DeviceClockedLoop(const DeviceClockedLoop&) = delete;
  DeviceClockedLoop& operator=(const DeviceClockedLoop&) = delete;

  void tick() noexcept UNDERACT_REAL_TIME override;

 private:
  DeviceClockedLoop(ServoLoop& loop, DevicePort& device, int rate_hz, std::int64_t patience_ns);
  void tickOnce(std::int64_t now_ns) noexcept UNDERACT_REAL_TIME;
  void standIn();

  ServoLoop& loop_;
  DevicePort& device_;
  const std::int64_t period_ns_, patience_ns_;
  std::atomic<std::int64_t> heard_ns_;   // when the arm's clock called last
  std::atomic<bool> is_ticking_{false};  // one of the two threads
  std::int64_t before_ns_ = 0;           // when the last tick began; used by the thread that ticks
  std::mutex mutex_;
  std::condition_variable wake_;
  bool ends_ = false;
  std::thread stand_in_;
};

}  // namespace underact::servo
