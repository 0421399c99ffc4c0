#include "core/servo/check.h"

#include <algorithm>
#include <chrono>
#include <memory>
#include <optional>
#include <thread>
#include <utility>

#include "core/servo/bare_loop.h"
#include "core/servo/cpu_load.h"
#include "core/servo/loop.h"
#include "core/servo/thread.h"
#include "core/system/clock.h"

namespace underact::servo {
namespace {

constexpr std::chrono::milliseconds kPause{50};  // between two readings of the servo: some 500 ticks at 10 kHz

/// The servo's part: a loop of its own, and the statistics of its ticks.
class Servo {
 public:
  Servo(DevicePort& device, tick::TickProgram program, const CheckOptions& options)
      : pushes_(device.info().simulated), loop_(device, system::kSecond_ns / options.rate_hz, 0) {
    program.limits.frozen_s = device.info().frozen_s;
    tick::TickState state = tick::makeState(program);
    loop_.send({Order::Load, new Instance{std::move(program), std::move(state), 1}});
    if (pushes_) loop_.send({Order::Start});
    thread_.emplace(loop_, options.rate_hz, options.scheduling);
  }
  void rest() { thread_->rest(); }
  void resume() { thread_->resume(); }
  void take() {
    loop_.drain([this](const TickRecord& record) {
      lateness_.add(record.lateness_ns);
      tick_time_.add(record.tick_ns);
    });
    loop_.reap();
    // A fault (late ticks in a row, say) releases the arm, but the ticks to be measured are those with a force.
    if (pushes_ && loop_.snapshot().mode == Mode::Faulted) loop_.send({Order::Start});
  }
  CheckResult end() {
    CheckResult result;
    result.scheduling = thread_->scheduling();
    thread_.reset();
    take();
    result.servo = lateness_.percentiles();
    result.tick_time = tick_time_.percentiles();
    result.ticks = lateness_.count();
    result.late = loop_.snapshot().late;
    return result;
  }

 private:
  bool pushes_;
  ServoLoop loop_;
  Histogram lateness_, tick_time_;
  std::optional<Thread> thread_;
};

}  // namespace

CheckResult checkServo(DevicePort& device, tick::TickProgram program, const CheckOptions& options,
                       const std::function<bool(double)>& progress) {
  const std::int64_t whole_ns = options.seconds * system::kSecond_ns;
  const std::int64_t turn_ns = std::max<std::int64_t>(1, std::min(system::kSecond_ns, whole_ns / 2));
  const auto servo = std::make_unique<Servo>(device, std::move(program), options);
  servo->rest();
  BareLoop bare(options.rate_hz, options.scheduling);
  std::optional<CpuLoad> busy;
  if (options.load) busy.emplace();
  const std::int64_t begin_ns = system::monotonicNow_ns();
  std::int64_t past_ns = 0;
  bool goes_on = true;
  for (std::int64_t turn = 0; goes_on && past_ns < whole_ns; ++turn) {
    const bool is_bare = turn % 2 == 0;
    is_bare ? bare.resume() : servo->resume();
    const std::int64_t end_ns = std::min((turn + 1) * turn_ns, whole_ns);
    while (goes_on && past_ns < end_ns) {
      std::this_thread::sleep_for(
          std::min<std::chrono::nanoseconds>(kPause, std::chrono::nanoseconds(end_ns - past_ns)));
      servo->take();
      past_ns = system::monotonicNow_ns() - begin_ns;
      goes_on = progress(std::min(1.0, static_cast<double>(past_ns) / static_cast<double>(whole_ns)));
    }
    is_bare ? bare.rest() : servo->rest();
  }
  busy.reset();
  CheckResult result = servo->end();
  result.floor = bare.end().percentiles();
  result.seconds = 1e-9 * static_cast<double>(past_ns);
  return result;
}

}  // namespace underact::servo
