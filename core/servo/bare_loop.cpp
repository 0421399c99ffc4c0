#include "core/servo/bare_loop.h"

#include "core/system/thread.h"

namespace underact::servo {

BareLoop::BareLoop(int rate_hz, const system::SchedulingRequest& wanted) {
  std::binary_semaphore ready{0};
  thread_ = std::thread([&] { run(rate_hz, wanted, ready); });
  ready.acquire();
}

BareLoop::~BareLoop() {
  end();
}

void BareLoop::resume() {
  setRequest(Request::Wake);
}

void BareLoop::rest() {
  setRequest(Request::Rest);
}

const Histogram& BareLoop::end() {
  if (thread_.joinable()) {
    setRequest(Request::End);
    thread_.join();
  }
  return lateness_;
}

void BareLoop::setRequest(Request request) {
  request_ = request;
  request_.notify_one();
}

void BareLoop::run(int rate_hz, const system::SchedulingRequest& wanted, std::binary_semaphore& ready) {
  system::nameThread("underact-bare");
  system::askForRealTime(wanted, rate_hz);
  ready.release();  // from here on ready and wanted may be gone
  while (request_ != Request::End) {
    request_.wait(Request::Rest);
    wakeWhileRequested(1'000'000'000 / rate_hz);
  }
}

void BareLoop::wakeWhileRequested(std::int64_t period_ns) {
  std::int64_t deadline_ns = system::monotonicNow_ns() + period_ns;
  while (request_.load(std::memory_order_relaxed) == Request::Wake) {
    system::sleepUntil(deadline_ns);
    const std::int64_t late_ns = system::monotonicNow_ns() - deadline_ns;
    lateness_.add(late_ns);
    deadline_ns += (1 + late_ns / period_ns) * period_ns;
  }
}

}  // namespace underact::servo
