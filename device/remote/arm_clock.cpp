#include "device/remote/arm_clock.h"

#include "core/base/denormals.h"
#include "core/system/thread.h"

namespace underact::device::remote {

ArmClock::ArmClock(servo::DevicePort& port, servo::Ticks& ticks, int rate_hz)
    : port_(port), ticks_(ticks), rate_hz_(rate_hz), is_driven_(port.drive(ticks, rate_hz)) {
  if (!is_driven_) thread_ = std::thread(&ArmClock::run, this);
}

ArmClock::~ArmClock() {
  ends_ = true;
  if (thread_.joinable()) thread_.join();
  if (is_driven_) port_.endDrive();
  port_.write({});
}

void ArmClock::run() {
  system::nameThread("underact-arm");
  const FlushDenormals flush;
  system::askForRealTime({}, rate_hz_);
  const std::int64_t period_ns = 1'000'000'000 / rate_hz_;
  std::int64_t next_ns = system::monotonicNow_ns();
  while (!ends_.load(std::memory_order_relaxed)) {
    next_ns += period_ns;
    system::sleepUntil(next_ns);
    const std::int64_t now_ns = system::monotonicNow_ns();
    if (now_ns - next_ns > period_ns) next_ns = now_ns;  // delays are not caught up in a burst
    ticks_.tick();
  }
}

}  // namespace underact::device::remote
