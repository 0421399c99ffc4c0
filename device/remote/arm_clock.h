#pragma once
#include <atomic>
#include <cstdint>
#include <thread>

#include "core/servo/device_port.h"

namespace underact::device::remote {

/// Ticks a shared arm: by the clock of its own driver if it has one, otherwise by a thread of its own on absolute
/// deadlines.
class ArmClock {
 public:
  ArmClock(servo::DevicePort& port, servo::Ticks& ticks, int rate_hz);
  ~ArmClock();  // no tick is running any more, and the arm has zero force
  ArmClock(const ArmClock&) = delete;
  ArmClock& operator=(const ArmClock&) = delete;

 private:
  void run();

  servo::DevicePort& port_;
  servo::Ticks& ticks_;
  const int rate_hz_;
  const bool is_driven_;
  std::atomic<bool> ends_{false};
  std::thread thread_;
};

}  // namespace underact::device::remote
