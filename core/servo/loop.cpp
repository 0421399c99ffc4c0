#include "core/servo/loop.h"

#include "core/servo/clock.h"

namespace underact::servo {
namespace {

constexpr std::size_t kCommands = 64;
// Each instance comes with a command, one is in use and one waits; the Host reaps before it sends.
constexpr std::size_t kRetired = 2 * kCommands;
constexpr std::size_t kRecords = 16384;  // 4 s at 4 kHz: how long a window may be busy before a plot loses ticks

/// Writes every page of a queue once, so that the servo thread meets no page fault there.
template <class T>
void touchPages(boost::lockfree::spsc_queue<T>& queue) {
  while (queue.push(T{})) {
  }
  queue.reset();
}

}  // namespace

Loop::Loop(DevicePort& device)
    : device_(device), current_(new Instance), commands_(kCommands), retired_(kRetired), records_(kRecords) {
  current_->program.geometry = arm::findPreset(arm::kDefaultArm)->geometry;
  touchPages(records_);
}

Loop::~Loop() {
  reap();
  commands_.consume_all([](const Command& left) { delete left.instance; });
  delete waiting_;
  delete current_;
}

bool Loop::send(const Command& command) {
  return commands_.push(command);
}

void Loop::reap() {
  retired_.consume_all([](const Instance* instance) { delete instance; });
}

void Loop::drain(const std::function<void(const TickRecord&)>& row) {
  records_.consume_all([&row](const TickRecord& record) { row(record); });
}

// Clang cannot see that push() and pop() keep off the heap; they do by their contract, and tests/malloc counts.
#if defined(__clang__) && __clang_major__ >= 20
#pragma clang diagnostic push
#pragma clang diagnostic ignored "-Wfunction-effects"
#endif

void Loop::retire(Instance* instance) noexcept {
  retired_.push(instance);
}

void Loop::replaceBy(Instance* instance, tick::Carry carry) noexcept {
  tick::carryOver(current_->state, instance->state, carry);
  retire(current_);
  current_ = instance;
}

void Loop::takeUpCommands() noexcept {
  Command command;
  while (commands_.pop(command)) {
    switch (command.order) {
      case Order::Start:
        engaged_ = restart_ = true;
        break;
      case Order::Stop:
        engaged_ = false;
        break;
      case Order::Load:
        if (waiting_ != nullptr) retire(waiting_);
        waiting_ = command.instance;
        break;
      case Order::Retune:
      case Order::Move:
        if (waiting_ != nullptr) {  // an edit of a scene that is not in yet
          retire(waiting_);
          waiting_ = command.instance;
        } else {
          replaceBy(command.instance,
                    command.order == Order::Retune ? tick::Carry::ArmAndLaws : tick::Carry::ArmAndMovedLaws);
        }
        break;
    }
  }
  if (waiting_ != nullptr && current_->state.gate.level == 0.0) {
    replaceBy(waiting_, tick::Carry::Arm);
    waiting_ = nullptr;
  }
}

Mode Loop::mode() const noexcept {
  if (current_->state.gate.fault.kind != FaultKind::None) return Mode::Faulted;
  if (engaged_) return Mode::Running;
  return current_->state.gate.level > 0.0 ? Mode::Stopping : Mode::Idle;
}

void Loop::tick(std::int64_t lateness_ns) noexcept {
  takeUpCommands();
  tick::TickInput input;
  input.has_sample = device_.read(input.sample);
  input.engage = engaged_ && waiting_ == nullptr;
  input.restart = restart_;
  restart_ = false;
  Snapshot& snapshot = snapshots_.back();
  const std::int64_t begin_ns = monotonicNow_ns();
  tick::step(current_->program, input, current_->state, snapshot.report);
  device_.write(snapshot.report.force);
  snapshot.tick_ns = monotonicNow_ns() - begin_ns;
  if (current_->state.gate.fault.kind != FaultKind::None) engaged_ = false;  // it takes a Start to push again
  snapshot.ticks = ++ticks_;
  snapshot.revision = current_->revision;
  snapshot.mode = mode();
  snapshot.lateness_ns = lateness_ns;
  if (!records_.push(recordOf(snapshot))) ++dropped_;
  snapshot.dropped = dropped_;
  snapshots_.publish();
}

void Loop::release() noexcept {
  device_.write(safety::GatedForce{});
}

#if defined(__clang__) && __clang_major__ >= 20
#pragma clang diagnostic pop
#endif

}  // namespace underact::servo
