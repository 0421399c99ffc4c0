#include "core/servo/driven.h"

#include <algorithm>

#include "core/base/denormals.h"
#include "core/servo/clock.h"

namespace underact::servo {

std::unique_ptr<Driven> Driven::start(Loop& loop, DevicePort& device, int rate_hz) {
  std::unique_ptr<Driven> driven(new Driven(loop, device, rate_hz));
  if (!device.drive(*driven, rate_hz)) return nullptr;
  return driven;
}

Driven::Driven(Loop& loop, DevicePort& device, int rate_hz)
    : loop_(loop), device_(device), period_ns_(1'000'000'000 / rate_hz) {}

Driven::~Driven() {
  device_.endDrive();
}

void Driven::tick() noexcept {
  const FlushDenormals flush;  // the thread is the arm's: as it was, afterwards
  const std::int64_t now_ns = monotonicNow_ns();
  Wake wake;
  if (before_ns_ != 0) {
    // Early by what the tick before was late.
    const std::int64_t lateness_ns = std::max<std::int64_t>(0, now_ns - before_ns_ - period_ns_);
    wake.lateness_ns = lateness_ns;
    wake.left_out = lateness_ns / period_ns_;
    wake.cause = LateCause::Device;
  }
  before_ns_ = now_ns;
  loop_.tick(wake);
}

}  // namespace underact::servo
