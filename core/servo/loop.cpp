#include "core/servo/loop.h"

#include <algorithm>
#include <utility>

#include "core/base/units.h"
#include "core/servo/touch_pages.h"

namespace underact::servo {
namespace {

constexpr std::size_t kCommands = 64;
// Each instance comes with a command, one is in use and one waits; the Host calls reap() before it sends.
constexpr std::size_t kRetired = 2 * kCommands;
// How long a window may be busy before a plot loses ticks: 4 s at any rate, 16 at 1 kHz.
constexpr std::int64_t kKept_ns = 4'000'000'000;
constexpr std::size_t kKeptAtLeast = 16384;

std::size_t ticksIn(std::int64_t time_ns, std::int64_t period_ns) {
  return static_cast<std::size_t>(std::max<std::int64_t>(time_ns / std::max<std::int64_t>(period_ns, 1), 1));
}

std::unique_ptr<boost::lockfree::spsc_queue<TickRecord>> roomForRows(std::int64_t period_ns) {
  const std::size_t rows = std::max(kKeptAtLeast, ticksIn(kKept_ns, period_ns));
  auto records = std::make_unique<boost::lockfree::spsc_queue<TickRecord>>(rows);
  touchPages(*records);
  return records;
}

History roomForASecond(std::int64_t period_ns) {
  return History(ticksIn(1'000'000'000, period_ns));
}

unsigned bitsOf(const tick::TickInput& input) noexcept UNDERACT_REAL_TIME {
  return (input.has_sample ? kHadSample : 0U) | (input.engage ? kEngaged : 0U) | (input.restart ? kRestarted : 0U) |
         (input.late ? kLate : 0U);
}

}  // namespace

ServoLoop::ServoLoop(DevicePort& device, std::int64_t period_ns, std::int64_t watchdog_ns, const system::Clocks& clocks)
    : device_(device),
      current_(new Instance),
      period_ns_(period_ns),
      watchdog_ns_(watchdog_ns),
      clocks_(clocks),
      history_(&histories_[0]),
      commands_(kCommands),
      retired_(kRetired),
      records_(roomForRows(period_ns)),
      full_(kHistories),
      spare_(kHistories) {
  current_->program.geometry = arm::findPreset(arm::kDefaultArm)->geometry;
  for (History& history : histories_) history = roomForASecond(period_ns);
  for (std::size_t index = 1; index < kHistories; ++index) spare_.push(&histories_[index]);
}

ServoLoop::~ServoLoop() {
  reap();
  commands_.consume_all([](const Command& left) { delete left.instance; });
  delete waiting_;
  delete current_;
}

bool ServoLoop::send(const Command& command) {
  return commands_.push(command);
}

void ServoLoop::reap() {
  retired_.consume_all([](const Instance* instance) { delete instance; });
}

void ServoLoop::drain(const std::function<void(const TickRecord&)>& row) {
  for (const TickRecord& record : std::exchange(left_, {})) row(record);
  records_->consume_all([&row](const TickRecord& record) { row(record); });
}

const History* ServoLoop::takeHistory() {
  History* history = nullptr;
  return full_.pop(history) ? history : nullptr;
}

void ServoLoop::giveBack(const History* history) {
  for (History& one : histories_) {
    if (&one != history) continue;
    if (one.room() != ticksIn(1'000'000'000, period_ns_)) one = roomForASecond(period_ns_);
    spare_.push(&one);
  }
}

void ServoLoop::setPeriod(std::int64_t period_ns) {
  period_ns_ = period_ns;
  late_ = {};
  arm_clock_.reset();
  records_->consume_all([this](const TickRecord& record) { left_.push_back(record); });
  records_ = roomForRows(period_ns);
  *history_ = roomForASecond(period_ns);
  std::vector<History*> spares;  // those that wait to be taken stay
  spare_.consume_all([&spares](History* spare) { spares.push_back(spare); });
  for (History* spare : spares) {
    *spare = roomForASecond(period_ns);
    spare_.push(spare);
  }
}

void ServoLoop::retire(Instance* instance) noexcept {
  retired_.push(instance);
}

void ServoLoop::replaceBy(Instance* instance, tick::Carry carry, std::int64_t over_ticks) noexcept {
  tick::carryOver(current_->program, current_->state, instance->program, instance->state, carry, over_ticks);
  retire(current_);
  current_ = instance;
  if (tap_ != nullptr) tap_->add(Change{ticks_ + 1, instance->revision, carry, over_ticks});
}

void ServoLoop::push(const Command& command) noexcept {
  push_T_W_ = command.push_T_W;
  push_left_ = command.ticks;
  is_push_new_ = true;
}

void ServoLoop::listen(Tap* tap) noexcept {
  if (tap_ != nullptr) tap_->end();
  tap_ = tap;
  if (tap_ == nullptr) return;
  tap_->begin(ticks_ + 1, current_->revision, current_->state);
  is_push_new_ = is_push_new_ || push_left_ > 0;
}

/// After the commands of a tick: of the forces that were asked for since the last one only the newest acts.
void ServoLoop::informTap() noexcept {
  const bool is_new = std::exchange(is_push_new_, false);
  if (tap_ == nullptr) return;
  const bool begins = tap_->wantsStart();
  if (is_new || (begins && push_left_ > 0)) tap_->add(Push{ticks_ + 1, push_T_W_, push_left_});
  if (begins) tap_->begin(ticks_ + 1, current_->revision, current_->state);
}

/// Ends the force, also that of a client.
void ServoLoop::heedStops() noexcept {
  const std::uint64_t stops = stops_.load(std::memory_order_acquire);
  if (stops == heeded_) return;
  heeded_ = stops;
  engaged_ = false;
  if (push_left_ > 0) push({Order::Push});
}

void ServoLoop::applyCommands() noexcept {
  heedStops();
  Command command;
  while (commands_.pop(command)) {
    ++orders_;
    switch (command.order) {
      case Order::Start:
        heedStops();
        if (command.stops == heeded_) engaged_ = restart_ = true;
        break;
      case Order::Stop:
        engaged_ = false;
        break;
      case Order::HoldToRun:
      case Order::RunFreely:
        hold_to_run_ = command.order == Order::HoldToRun;
        break;
      case Order::Record:
      case Order::EndRecord:
        admit();  // a recording begins with the scene loaded before it, where possible
        listen(command.tap);
        break;
      case Order::Load:
        if (waiting_ != nullptr) retire(waiting_);
        waiting_ = command.instance;
        break;
      case Order::Retune:
      case Order::Move:
        if (waiting_ != nullptr) {  // an edit of a scene that is still waiting
          retire(waiting_);
          waiting_ = command.instance;
        } else {
          replaceBy(command.instance,
                    command.order == Order::Retune ? tick::Carry::ArmAndLaws : tick::Carry::ArmAndMovedLaws,
                    command.ticks);
        }
        break;
      case Order::Push:
        push(command);
        break;
    }
  }
  admit();
}

void ServoLoop::admit() noexcept {
  if (waiting_ == nullptr || current_->state.gate.level > 0.0) return;
  replaceBy(waiting_, tick::Carry::Arm);
  waiting_ = nullptr;
}

Mode ServoLoop::mode() const noexcept {
  if (current_->state.gate.fault.kind != FaultKind::None) return Mode::Faulted;
  if (engaged_) return Mode::Running;
  return current_->state.gate.level > 0.0 ? Mode::Stopping : Mode::Idle;
}

bool ServoLoop::pushes() const noexcept {
  return engaged_ || current_->state.gate.level > 0.0;
}

/// A pause is reported once: by the watchdog, or, where that was not fast enough, by the latency itself.
Fault ServoLoop::faultOf(const Wake& wake) noexcept {
  const std::int64_t told_ns = stood_still_ns_.exchange(0, std::memory_order_relaxed);
  const std::int64_t pause_ns = std::max(told_ns, wake.lateness_ns);
  const std::int64_t busy_ns = busy_window_ns_.exchange(0, std::memory_order_relaxed);
  if (!pushes()) return {};
  if (watchdog_ns_ <= 0 || pause_ns < watchdog_ns_)
    return busy_ns > 0 ? Fault{FaultKind::WindowBusy, kSecondPerNanosecond * static_cast<double>(busy_ns), 0.0}
                       : Fault{};
  return {FaultKind::StoodStill, kSecondPerNanosecond * static_cast<double>(pause_ns),
          kSecondPerNanosecond * static_cast<double>(watchdog_ns_)};
}

/// Faults found by comparing clocks, with the sample at hand and before any force follows from it. Without a force they
/// are no faults and not reported; where the servo's time is counted, sleep does not matter.
Fault ServoLoop::faultOfClocks(const Wake& wake, const tick::TickInput& input, std::int64_t now_ns,
                               std::int64_t with_sleep_ns) noexcept {
  counted_ns_ += (1 + wake.left_out) * period_ns_;
  const bool counts = wake.at_ns == 0;
  Fault odd;
  if (input.has_sample)
    odd = arm_clock_.check(input.sample.time_ns, counts ? counted_ns_ : wake.at_ns, counts ? counted_ns_ : now_ns,
                           period_ns_);
  if (!counts) slept_ns_ += sleep_.poll(clocks_, with_sleep_ns - now_ns);
  const std::int64_t slept_ns = std::exchange(slept_ns_, 0);
  if (!pushes()) return {};
  if (slept_ns > 0) return {FaultKind::Asleep, kSecondPerNanosecond * static_cast<double>(slept_ns), 0.0};
  return odd;
}

void ServoLoop::countLate(const Wake& wake) noexcept {
  late_.left_out += wake.left_out;
  if (wake.lateness_ns < period_ns_) return;
  ++late_.total;
  ++late_.by_cause[static_cast<std::size_t>(wake.cause)];
}

/// Hands on the last second with the fault that ended it; while three wait to be taken, a fourth is dropped.
void ServoLoop::remember(const Snapshot& snapshot) noexcept {
  const TickRecord record = recordOf(snapshot);
  if (!records_->push(record)) ++dropped_;
  history_->add(record);
  const bool faulted = snapshot.mode == Mode::Faulted;
  if (tap_ != nullptr) {
    if (faulted && !was_faulted_) tap_->add(FaultMark{snapshot.ticks, snapshot.report.fault, false});
    if (tap_->wantsDetails()) addDetails(snapshot);
    tap_->add(record);
  }
  if (faulted && !was_faulted_) {
    history_->end(snapshot.report.fault, snapshot.revision, late_, period_ns_);
    History* spare = nullptr;
    if (spare_.pop(spare)) {
      full_.push(history_);
      history_ = spare;
    }
    history_->clear();
  }
  was_faulted_ = faulted;
}

/// What a recorder gets of a tick beyond its row.
void ServoLoop::addDetails(const Snapshot& snapshot) noexcept {
  Truth truth;
  if (device_.truth(truth)) tap_->add(TruthRow{snapshot.ticks, truth});
  for (std::size_t index = 0; index < snapshot.report.held.size(); ++index) {
    const tick::ConstraintReport& held = snapshot.report.held[index];
    ConstraintRow row{snapshot.ticks, static_cast<std::uint32_t>(index), held.acts, held.p_WP, held.f_T_W};
    if (held.status != target::Status::Unique) row.p_WP.setConstant(kNotANumber);
    tap_->add(row);
  }
}

void ServoLoop::tick(const Wake& wake) noexcept {
  applyCommands();
  informTap();
  countLate(wake);
  tick::TickInput input;
  input.fault = faultOf(wake);
  input.late = wake.lateness_ns >= period_ns_;
  input.period_s = kSecondPerNanosecond * static_cast<double>(period_ns_);
  input.waited_s = waited_s(wake.lateness_ns, period_ns_);
  if (push_left_ > 0) {
    input.push_T_W = push_T_W_;
    --push_left_;
  }
  const std::int64_t asked_ns = clocks_.now_ns();
  input.has_sample = device_.read(input.sample);
  const bool held = !hold_to_run_ || (input.sample.buttons & 1U) != 0;
  input.engage = engaged_ && held && waiting_ == nullptr;
  const bool anew = input.has_sample && input.sample.epoch != epoch_;
  if (anew) epoch_ = input.sample.epoch;
  input.restart = restart_ || (anew && mode() != Mode::Faulted);
  restart_ = false;
  Snapshot& snapshot = snapshots_.back();
  const std::int64_t with_sleep_ns = wake.at_ns != 0 ? clocks_.with_sleep_ns() : 0;  // first: see SleepWatch
  const std::int64_t begin_ns = clocks_.now_ns();
  read_ns_ = begin_ns - asked_ns;
  if (input.restart) arm_clock_.reset();
  const Fault by_clocks = faultOfClocks(wake, input, begin_ns, with_sleep_ns);
  if (input.fault.kind == FaultKind::None) input.fault = by_clocks;
  if (tap_ != nullptr && input.fault.kind != FaultKind::None) tap_->add(FaultMark{ticks_ + 1, input.fault, true});
  tick::carryTargets(current_->program, current_->state);
  tick::step(current_->program, input, current_->state, snapshot.report);
  device_.write(snapshot.report.force);
  snapshot.tick_ns = clocks_.now_ns() - begin_ns;
  // A machine may be suspended between any two instructions: if that happened since the last check, it wakes with this
  // tick's force on the hand. The force is taken back here; the next tick reports the reason.
  if (wake.at_ns != 0) slept_ns_ += sleep_.poll(clocks_);
  if (slept_ns_ > 0) device_.write(safety::GatedForce{});
  if (current_->state.gate.fault.kind != FaultKind::None) engaged_ = false;  // only a Start makes it push again
  snapshot.ticks = ++ticks_;
  snapshot.revision = current_->revision;
  snapshot.mode = mode();
  snapshot.input = bitsOf(input);
  snapshot.orders = orders_;
  snapshot.lateness_ns = wake.lateness_ns;
  snapshot.late = late_;
  snapshot.waits_for_button = engaged_ && !held;
  remember(snapshot);
  snapshot.dropped = dropped_;
  snapshots_.publish();
  beats_->store(ticks_, std::memory_order_relaxed);
}

void ServoLoop::release() noexcept {
  device_.write(safety::GatedForce{});
  sleep_.reset();  // sleep does not matter until it ticks again
  slept_ns_ = 0;
}

}  // namespace underact::servo
