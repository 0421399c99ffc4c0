#include "core/servo/thread.h"

#include "core/base/denormals.h"
#include "core/base/translate.h"
#include "core/servo/deadlines.h"
#include "core/system/thread.h"

namespace underact::servo {

Thread::Thread(ServoLoop& loop, int rate_hz, const system::SchedulingRequest& wanted)
    : loop_(loop), rate_hz_(rate_hz), wanted_(wanted) {
  std::promise<system::Scheduling> granted;
  std::future<system::Scheduling> scheduling = granted.get_future();
  thread_ = std::thread(&Thread::run, this, std::move(granted));
  scheduling_ = scheduling.get();
}

Thread::~Thread() {
  setRequest(Request::End);
  thread_.join();
}

void Thread::rest() {
  setRequest(Request::Rest);
}

void Thread::resume() {
  setRequest(Request::Tick);
}

void Thread::setRequest(Request request) {
  request_ = request;
  request_.notify_one();
}

void Thread::run(std::promise<system::Scheduling> granted) {
  system::nameThread("underact-servo");
  const FlushDenormals flush;
  system::Scheduling scheduling = system::askForRealTime(wanted_, rate_hz_);
  scheduling.also.push_back(phrase(FlushDenormals::isKnown() ? TRANSLATE_NOOP("problem", "denormals flushed")
                                                             : TRANSLATE_NOOP("problem", "denormals kept")));
  granted.set_value(std::move(scheduling));
  while (request_ != Request::End) {
    tickWhileRequested();
    loop_.release();
    request_.wait(Request::Rest);
  }
}

void Thread::tickWhileRequested() {
  const std::int64_t period_ns = 1'000'000'000 / rate_hz_;
  std::int64_t now_ns = system::monotonicNow_ns();
  Deadlines deadlines(period_ns, now_ns, system::interruptions());
  while (request_.load(std::memory_order_relaxed) == Request::Tick) {
    system::sleepUntil(deadlines.wakeAt_ns(now_ns));
    const std::int64_t begin_ns = system::monotonicNow_ns();
    Wake wake = deadlines.begin(begin_ns);
    if (wake.lateness_ns >= period_ns) wake.cause = deadlines.causeOf(system::interruptions());
    loop_.tick(wake);
    now_ns = system::monotonicNow_ns();
    deadlines.end(now_ns - begin_ns, loop_.lastRead_ns());
  }
}

}  // namespace underact::servo
