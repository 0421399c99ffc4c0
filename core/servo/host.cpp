#include "core/servo/host.h"

#include <algorithm>
#include <chrono>
#include <ctime>
#include <deque>
#include <map>
#include <string>
#include <thread>
#include <utility>

#include "core/base/denormals.h"
#include "core/base/translate.h"
#include "core/scene/compile.h"
#include "core/scene/edit.h"
#include "core/servo/device_clocked_loop.h"
#include "core/servo/guard.h"
#include "core/servo/loop.h"
#include "core/servo/thread.h"
#include "core/servo/watchdog.h"

namespace underact::servo {

constexpr double kLongestRelease_s = 0.2;  // four times the duration of the gate's

struct Host::Impl {
  Impl(std::unique_ptr<DevicePort> port, const HostOptions& wanted)
      : options(wanted),
        device(std::move(port)),
        loop(*device, 1'000'000'000 / wanted.rate_hz, static_cast<std::int64_t>(1e9 * wanted.watchdog_s),
             wanted.clocks),
        timing(wanted.rate_hz) {}
  ~Impl() {
    end();
    if (tap) tap->end();
    for (const auto& one : ending) one->end();
    for (const Command& command : backlog) delete command.instance;
  }

  /// The watching threads end first, so that the orderly end of the servo thread is not taken for a stall.
  void end() {
    watchdog.reset();
    thread.reset();
    driven.reset();
    loop.countInto(nullptr);
    guard.reset();
  }
  void begin() {
    const auto limit_ns = static_cast<std::int64_t>(1e9 * options.watchdog_s);
    const ZeroForceMessage word = device->zeroForceMessage();
    can_be_guarded = limit_ns > 0 && word.fd >= 0;
    if (limit_ns > 0)
      guard = Guard::start(word, limit_ns, options.guard_program, no_guard);
    else
      no_guard = phrase(TRANSLATE_NOOP("problem", "the watchdog is switched off"));
    if (guard) loop.countInto(&guard->beats());
    driven = DeviceClockedLoop::start(loop, *device, options.rate_hz, limit_ns);
    if (!driven) thread.emplace(loop, options.rate_hz, options.scheduling);
    if (limit_ns > 0)
      watchdog.emplace([this] { return loop.beats(); }, limit_ns,
                       [this](std::int64_t pause_ns) {
                         loop.reportStall(pause_ns);
                         device->cut();
                       });
  }

  bool ticksByItself() const { return thread.has_value() || driven != nullptr; }
  bool pushes() { return loop.snapshot().mode == Mode::Running || loop.snapshot().mode == Mode::Stopping; }
  /// Ramps the force to zero. An arm that hangs is not waited for any longer: the end of its thread cuts the force.
  void letGo() {
    send({Order::Stop});
    if (!ticksByItself()) {
      const FlushDenormals flush;
      for (auto left = static_cast<int>(kLongestRelease_s * options.rate_hz); left > 0 && pushes(); --left)
        loop.tick({});
      return;
    }
    const auto end = std::chrono::steady_clock::now() + std::chrono::duration<double>(kLongestRelease_s);
    while (pushes() && std::chrono::steady_clock::now() < end) {
      flush();
      std::this_thread::sleep_for(std::chrono::milliseconds(1));
    }
  }
  bool records() const { return tap && !tap->ended() && !tap->givenUp(); }
  Problems mayTickAt(int rate_hz) const {
    if (rate_hz < kSlowest_hz || rate_hz > kFastest_hz)
      return {{phrase(TRANSLATE_NOOP("problem", "The servo rate must be from 100 to 10000 Hz, not %1."),
                      {std::to_string(rate_hz)}),
               {}}};
    if (records())
      return {{phrase(TRANSLATE_NOOP(
                   "problem", "A session is recorded at a single rate. Stop the recording, then change the rate.")),
               {}}};
    const Sentence why = device->rateRefusal(rate_hz);
    return why.empty() ? Problems{} : Problems{{why, {}}};
  }

  /// Sends commands in order, without losing any: what finds no room now is sent with the next call.
  void send(const Command& command) {
    ++orders;
    backlog.push_back(command);
    flush();
  }
  void flush() {
    loop.reap();
    while (!backlog.empty() && loop.send(backlog.front())) backlog.pop_front();
  }

  Result<tick::TickProgram> programOf(const scene::Description& wanted) const {
    Result<tick::TickProgram> program = scene::compile(wanted);
    if (!program) return program;
    program.value().limits.max_force_N *= force_share;
    program.value().limits.frozen_s = device->info().frozen_s;
    program.value().limits.max_late = options.max_late;
    return program;
  }

  Problems put(const scene::Description& wanted, Order order, std::int64_t over_ticks = 0) {
    Result<tick::TickProgram> program = programOf(wanted);
    if (!program) return program.problems();
    tick::TickState state = tick::makeState(program.value());
    scene = wanted;
    ++revision;
    keepScene();
    send({order, new Instance{std::move(program).value(), std::move(state), revision}, nullptr, over_ticks});
    return {};
  }

  /// Keeps the scenes of the program in effect and of all later ones, for a recorder that begins.
  void keepScene() {
    scenes[revision] = scene;
    scenes.erase(scenes.begin(), scenes.lower_bound(loop.snapshot().revision));
    if (tap) tap->announce(revision, scene);
  }
  void record(std::shared_ptr<Tap> wanted) {
    std::erase_if(ending, [](const auto& one) { return one->ended(); });
    if (tap) ending.push_back(std::move(tap));
    tap = std::move(wanted);
    Command command{tap ? Order::Record : Order::EndRecord};
    command.tap = tap.get();
    if (tap)
      for (const auto& [number, kept] : scenes) tap->announce(number, kept);
    send(command);
    if (!ticksByItself()) loop.applyCommands();
  }
  /// Waits for a recorder that is behind, not for one that has given up.
  void waitForRoom(std::size_t ticks) const {
    while (tap && tap->room() < ticks && !tap->givenUp()) std::this_thread::sleep_for(std::chrono::milliseconds(1));
  }

  HostOptions options;
  std::unique_ptr<DevicePort> device;
  ServoLoop loop;
  std::unique_ptr<Guard> guard;
  Sentence no_guard;  // why none was started
  bool can_be_guarded = false;
  std::optional<Thread> thread;  // one of the two ticks
  std::unique_ptr<DeviceClockedLoop> driven;
  std::optional<Watchdog> watchdog;
  std::deque<Command> backlog;
  scene::Description scene;
  std::uint64_t revision = 0;
  std::uint64_t orders = 0;
  std::map<std::uint64_t, scene::Description> scenes;
  std::shared_ptr<Tap> tap;                    // the recorder's
  std::vector<std::shared_ptr<Tap>> ending;    // the servo may still write into them
  std::optional<std::uint64_t> started_after;  // ServoLoop::stops() at the last start()
  bool hold_to_run = false;
  double force_share = 1.0;
  Timing timing;
  std::int64_t timed_from = 0;  // the tick before the first one in timing
};

Host::Host(std::unique_ptr<DevicePort> device, const HostOptions& options)
    : impl_(std::make_unique<Impl>(std::move(device), options)) {}

Host::~Host() = default;

Problems Host::load(const scene::Description& scene) {
  return impl_->put(scene, Order::Load);
}

Problems Host::edit(const scene::Description& edited, std::int64_t over_ticks) {
  const scene::Change change = scene::changeBetween(impl_->scene, edited);
  if (change == scene::Change::Gains) return impl_->put(edited, Order::Retune);
  if (change == scene::Change::Scene) return impl_->put(edited, Order::Load);
  return over_ticks > 0 ? impl_->put(edited, Order::Retune, over_ticks) : impl_->put(edited, Order::Move);
}

void Host::push(const Vec3& f_T_W, std::int64_t ticks) {
  Command command{Order::Push};
  command.ticks = ticks;
  command.push_T_W = f_T_W;
  impl_->send(command);
}

std::uint64_t Host::orders() const {
  return impl_->orders;
}

Result<tick::TickProgram> Host::programOf(const scene::Description& scene) const {
  return impl_->programOf(scene);
}

const scene::Description& Host::scene() const {
  return impl_->scene;
}

std::uint64_t Host::revision() const {
  return impl_->revision;
}

void Host::start() {
  Command command{Order::Start};
  command.stops = impl_->loop.stops();
  impl_->started_after = command.stops;
  impl_->send(command);
}

void Host::stop() {
  ++impl_->loop.stops();
  impl_->send({Order::Stop});
}

bool Host::running() const {
  return impl_->started_after == impl_->loop.stops().load() && impl_->loop.snapshot().mode != Mode::Faulted;
}

std::atomic<std::uint64_t>& Host::stops() noexcept {
  return impl_->loop.stops();
}

void Host::reportBusyWindow(std::int64_t pause_ns) noexcept {
  impl_->loop.reportBusyWindow(pause_ns);
}

void Host::setHoldToRun(bool on) {
  impl_->hold_to_run = on;
  impl_->send({on ? Order::HoldToRun : Order::RunFreely});
}

bool Host::holdToRun() const {
  return impl_->hold_to_run;
}

Problems Host::setForceShare(double share) {
  if (!(share >= 0.0 && share <= 1.0))
    return {{phrase(TRANSLATE_NOOP("problem", "The share of the force must be from 0 to 1.")), {}}};
  if (share == impl_->force_share) return {};
  if (impl_->records())
    return {{phrase(TRANSLATE_NOOP("problem",
                                   "A session is recorded with a single force limit. Stop the recording first.")),
             {}}};
  impl_->force_share = share;
  return impl_->revision > 0 ? impl_->put(scene::Description(impl_->scene), Order::Retune) : Problems{};
}

double Host::forceShare() const {
  return impl_->force_share;
}

Problems Host::restart() {
  const bool was_begun = impl_->ticksByItself();
  stop();
  impl_->end();
  const double frozen_s = impl_->device->info().frozen_s;
  Problems problems = impl_->device->reopen();
  // Another arm may have been connected, while the program was compiled for the last one: it is known to compile.
  if (impl_->revision > 0 && impl_->device->info().frozen_s != frozen_s) load(scene::Description(impl_->scene));
  if (was_begun) begin();
  return problems;
}

Problems Host::setRate(int rate_hz) {
  if (rate_hz == rateHz()) return {};
  Problems problems = impl_->mayTickAt(rate_hz);
  if (!problems.empty()) return problems;
  const bool was_running = running(), was_begun = impl_->ticksByItself();
  impl_->letGo();
  impl_->end();
  impl_->options.rate_hz = rate_hz;
  impl_->device->setRate(rate_hz);
  impl_->loop.setPeriod(1'000'000'000 / rate_hz);
  impl_->timing = Timing(rate_hz);
  impl_->timed_from = impl_->loop.snapshot().ticks;
  // A fault during the release remains a fault, and needs a Start as always.
  const bool went_well = !impl_->pushes() && impl_->loop.snapshot().mode != Mode::Faulted;
  const bool was_stopped = impl_->started_after != impl_->loop.stops().load();  // meanwhile, by another thread
  impl_->started_after.reset();
  if (was_begun) begin();
  if (was_running && went_well && !was_stopped) start();
  return {};
}

std::optional<FaultReport> Host::takeFault() {
  const History* history = impl_->loop.takeHistory();
  if (history == nullptr) return {};
  std::vector<TickRecord> last_second = history->inOrder();
  FaultReport report{history->fault(),
                     last_second.empty() ? 0 : last_second.back().tick,
                     static_cast<std::int64_t>(std::time(nullptr)),
                     std::move(last_second),
                     impl_->scene,
                     device(),
                     trouble(),
                     scheduling(),
                     static_cast<int>(1'000'000'000 / history->period_ns()),  // exact for every possible rate
                     history->late()};
  impl_->loop.giveBack(history);
  return report;
}

const Timing& Host::timing() const {
  return impl_->timing;
}

Snapshot Host::snapshot() {
  impl_->flush();
  return impl_->loop.snapshot();
}

void Host::drain(const std::function<void(const TickRecord&)>& row) {
  impl_->loop.drain([&](const TickRecord& record) {
    if (record.tick > impl_->timed_from) impl_->timing.add(record);
    row(record);
  });
}

void Host::begin() {
  if (impl_->options.clock == Clock::Thread && !impl_->ticksByItself()) impl_->begin();
}

void Host::run(std::int64_t ticks, std::span<const std::int64_t> lateness_ns) {
  impl_->flush();
  const FlushDenormals flush;             // as the servo thread does: the same bits
  constexpr std::int64_t kAtOnce = 1000;  // far fewer than a tap has room for
  for (std::int64_t tick = 0; tick < ticks; ++tick) {
    if (tick % kAtOnce == 0) impl_->waitForRoom(kAtOnce);
    Wake wake;
    if (static_cast<std::size_t>(tick) < lateness_ns.size()) {
      wake.lateness_ns = lateness_ns[static_cast<std::size_t>(tick)];
      wake.left_out = std::max<std::int64_t>(wake.lateness_ns, 0) / (1'000'000'000 / impl_->options.rate_hz);
    }
    impl_->loop.tick(wake);
  }
}

void Host::record(std::shared_ptr<Tap> tap) {
  impl_->record(std::move(tap));
}

bool Host::records() const {
  return impl_->records();
}

void Host::endRecord() {
  if (impl_->tap) impl_->record(nullptr);
}

int Host::rateHz() const {
  return impl_->options.rate_hz;
}

system::Scheduling Host::scheduling() const {
  const bool is_manual = impl_->options.clock == Clock::Manual;
  if (!impl_->ticksByItself())
    return {phrase(is_manual ? TRANSLATE_NOOP("problem", "manual") : TRANSLATE_NOOP("problem", "not started")), "", {}};
  system::Scheduling granted{phrase(TRANSLATE_NOOP("problem", "by the arm's own clock")), "", {}};
  if (impl_->thread) granted = impl_->thread->scheduling();
  granted.also.push_back(guarding());
  return granted;
}

const system::SchedulingRequest& Host::schedulingWanted() const {
  return impl_->options.scheduling;
}

int Host::maxLate() const {
  return impl_->options.max_late;
}

Sentence Host::guarding() const {
  return impl_->ticksByItself() ? guardPhrase(impl_->guard.get(), impl_->no_guard) : Sentence();
}

Sentence Host::unguarded() const {
  if (!impl_->ticksByItself() || !impl_->can_be_guarded) return {};
  const Sentence gap = impl_->guard ? impl_->guard->gap() : impl_->no_guard;
  return gap.empty() ? gap : noGuardText(gap);
}

DeviceInfo Host::device() const {
  return impl_->device->info();
}

Sentence Host::trouble() const {
  return impl_->device->trouble();
}

}  // namespace underact::servo
