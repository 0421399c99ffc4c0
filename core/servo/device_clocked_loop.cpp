#include "core/servo/device_clocked_loop.h"

#include <algorithm>
#include <chrono>

#include "core/base/denormals.h"
#include "core/system/clock.h"

namespace underact::servo {
namespace {

constexpr std::int64_t kPatience_ns = 100'000'000;
constexpr int kLooksInPatience = 5;

}  // namespace

std::unique_ptr<DeviceClockedLoop> DeviceClockedLoop::start(ServoLoop& loop, DevicePort& device, int rate_hz,
                                                            std::int64_t patience_ns) {
  std::unique_ptr<DeviceClockedLoop> driven(new DeviceClockedLoop(loop, device, rate_hz, patience_ns));
  if (!device.drive(*driven, rate_hz)) return nullptr;
  driven->stand_in_ = std::thread(&DeviceClockedLoop::standIn, driven.get());
  return driven;
}

DeviceClockedLoop::DeviceClockedLoop(ServoLoop& loop, DevicePort& device, int rate_hz, std::int64_t patience_ns)
    : loop_(loop),
      device_(device),
      period_ns_(1'000'000'000 / rate_hz),
      patience_ns_(patience_ns > 0 ? patience_ns : kPatience_ns),
      heard_ns_(system::monotonicNow_ns()) {}

DeviceClockedLoop::~DeviceClockedLoop() {
  if (!stand_in_.joinable()) return;  // it never drove the servo
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    ends_ = true;
  }
  wake_.notify_one();
  stand_in_.join();
  device_.endDrive();
  loop_.release();
}

void DeviceClockedLoop::tick() noexcept {
  const std::int64_t now_ns = system::monotonicNow_ns();
  heard_ns_.store(now_ns, std::memory_order_relaxed);
  tickOnce(now_ns);
}

void DeviceClockedLoop::tickOnce(std::int64_t now_ns) noexcept {
  if (is_ticking_.exchange(true, std::memory_order_acquire)) return;  // the other thread is ticking
  const FlushDenormals flush;  // restored afterwards, since the thread may be the arm's
  Wake wake;
  wake.at_ns = now_ns;
  if (before_ns_ != 0) {
    // A tick after a late one comes early by as much.
    const std::int64_t lateness_ns = std::max<std::int64_t>(0, now_ns - before_ns_ - period_ns_);
    wake.lateness_ns = lateness_ns;
    wake.left_out = lateness_ns / period_ns_;
    wake.cause = LateCause::Device;
  }
  before_ns_ = now_ns;
  loop_.tick(wake);
  is_ticking_.store(false, std::memory_order_release);
}

void DeviceClockedLoop::standIn() {
  const std::chrono::nanoseconds pause(patience_ns_ / kLooksInPatience);
  std::unique_lock<std::mutex> lock(mutex_);
  while (!wake_.wait_for(lock, pause, [this] { return ends_; })) {
    const std::int64_t now_ns = system::monotonicNow_ns();
    const std::int64_t silence_ns = now_ns - heard_ns_.load(std::memory_order_relaxed);
    if (silence_ns < patience_ns_) continue;
    loop_.reportStall(silence_ns);  // these ticks keep the watchdog quiet
    tickOnce(now_ns);
  }
}

}  // namespace underact::servo
