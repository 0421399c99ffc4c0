#include "core/servo/bare_loop.h"

#include "core/system/thread.h"

namespace underact::servo {

BareLoop::BareLoop(int rate_hz, const system::SchedulingWanted& wanted) {
  std::binary_semaphore ready{0};
  thread_ = std::thread([&] { run(rate_hz, wanted, ready); });
  ready.acquire();
}

BareLoop::~BareLoop() {
  end();
}

void BareLoop::resume() {
  tell(Wish::Wake);
}

void BareLoop::rest() {
  tell(Wish::Rest);
}

const Histogram& BareLoop::end() {
  if (thread_.joinable()) {
    tell(Wish::End);
    thread_.join();
  }
  return lateness_;
}

void BareLoop::tell(Wish wish) {
  wish_ = wish;
  wish_.notify_one();
}

void BareLoop::run(int rate_hz, const system::SchedulingWanted& wanted, std::binary_semaphore& ready) {
  system::nameThread("underact-bare");
  system::askForRealTime(wanted, rate_hz);
  ready.release();  // from here on ready and wanted may be gone
  while (wish_ != Wish::End) {
    wish_.wait(Wish::Rest);
    wakeWhileWished(1'000'000'000 / rate_hz);
  }
}

void BareLoop::wakeWhileWished(std::int64_t period_ns) {
  std::int64_t deadline_ns = system::monotonicNow_ns() + period_ns;
  while (wish_.load(std::memory_order_relaxed) == Wish::Wake) {
    system::sleepUntil(deadline_ns);
    const std::int64_t late_ns = system::monotonicNow_ns() - deadline_ns;
    lateness_.add(late_ns);
    deadline_ns += (1 + late_ns / period_ns) * period_ns;
  }
}

}  // namespace underact::servo
