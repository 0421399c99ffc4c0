#pragma once
#include <array>
#include <atomic>
#include <boost/lockfree/spsc_queue.hpp>
#include <cstdint>
#include <functional>
#include <memory>
#include <vector>

#include "core/servo/arm_clock_watch.h"
#include "core/servo/device_port.h"
#include "core/servo/history.h"
#include "core/servo/sleep_watch.h"
#include "core/servo/slot.h"
#include "core/servo/snapshot.h"
#include "core/servo/tap.h"
#include "core/system/clock.h"
#include "core/tick/step.h"

namespace underact::servo {

/// A tick program with its state, made outside the servo thread, and the Host's number for it.
struct Instance {
  tick::TickProgram program;
  tick::TickState state;
  std::uint64_t revision = 0;
};

/// Orders to the servo. Load: another scene, swapped in once the force has ramped to zero. Retune: the same scene with
/// other gains, swapped in before the next tick. Move: likewise, with the targets moved. HoldToRun and RunFreely:
/// whether the stylus button has to be held. Record and EndRecord: whether ticks are copied to a tap. Push: a force is
/// added before the gate, instead of any earlier one.
enum class Order : std::uint8_t { Start, Stop, Load, Retune, Move, HoldToRun, RunFreely, Record, EndRecord, Push };

/// An order, and what it needs.
struct Command {
  Order order = Order::Stop;
  Instance* instance = nullptr;  // owned by the loop from here on; given back by reap()
  Tap* tap = nullptr;            // Record: lives until it has ended
  std::int64_t ticks = 0;        // Retune: over which the targets are carried, 0: at once. Push: for how many
  Vec3 push_T_W = Vec3::Zero();  // Push: N, finite
  std::uint64_t stops = 0;       // Start: ServoLoop::stops() when it was given; one that is higher by then has ended it
};

/// What the servo thread does each period: takes up commands, reads the arm, ticks, writes the force and hands the
/// results on. It never waits and never allocates; each queue has one writer, one reader and a fixed capacity.
class ServoLoop {
 public:
  /// device: outlives it. period_ns: above 0; watchdog_ns: no tick for so long is a fault, 0: never. Allocates all that
  /// ticks need.
  ServoLoop(DevicePort& device, std::int64_t period_ns, std::int64_t watchdog_ns, const system::Clocks& clocks = {});
  ~ServoLoop();
  ServoLoop(const ServoLoop&) = delete;
  ServoLoop& operator=(const ServoLoop&) = delete;

  // The servo thread, or whoever stands in for it.
  /// One tick. wake: when it was due, and when it began.
  void tick(const Wake& wake) noexcept UNDERACT_REAL_TIME;
  /// Takes up commands without a tick, where no thread ticks.
  void applyCommands() noexcept UNDERACT_REAL_TIME;
  /// Writes zero force, at the end.
  void release() noexcept UNDERACT_REAL_TIME;
  /// How long the last tick waited for the arm's sample. The thread that ticks.
  std::int64_t lastRead_ns() const noexcept { return read_ns_; }

  // The other side: one thread.
  bool send(const Command& command);  // false: no room; try again later
  void reap();                        // frees the instances that are out of use
  /// The newest snapshot; the reference holds until the next call.
  const Snapshot& snapshot() { return snapshots_.latest(); }
  /// Calls row() for each tick since the last call, in order. Rows that found no room are left out, and counted.
  void drain(const std::function<void(const TickRecord&)>& row);
  /// The history of the oldest fault that was not taken yet, or null; to be given back by giveBack().
  const History* takeHistory();
  /// Makes room for another fault. history: of takeHistory(); not to be read afterwards. May allocate.
  void giveBack(const History* history);
  /// Sets the period of the ticks. What counts in ticks begins anew: the last second, and late ticks; rows that were
  /// not drained are kept. Not while it ticks; allocates.
  void setPeriod(std::int64_t period_ns);

  // Any thread.
  /// The number of ticks, for a watchdog.
  std::int64_t beats() const noexcept { return beats_->load(std::memory_order_relaxed); }
  /// Counts ticks in the given memory from now on; null: in its own again. Not while it ticks.
  void countInto(std::atomic<std::int64_t>* beats) noexcept { beats_ = beats != nullptr ? beats : &own_beats_; }
  /// Called by the watchdog when it has cut the force: the next tick is a fault.
  void reportStall(std::int64_t pause_ns) noexcept { stood_still_ns_.store(pause_ns, std::memory_order_relaxed); }
  /// Called when the window's thread has stood still for so long: the next tick is a fault, if it pushes.
  void reportBusyWindow(std::int64_t pause_ns) noexcept { busy_window_ns_.store(pause_ns, std::memory_order_relaxed); }
  /// Whoever counts it up stops the servo with the next tick: Order::Stop past the queue, and past its writer. A
  /// signal's handler may, too.
  std::atomic<std::uint64_t>& stops() noexcept { return stops_; }

 private:
  void heedStops() noexcept UNDERACT_REAL_TIME;
  void admit() noexcept UNDERACT_REAL_TIME;
  void listen(Tap* tap) noexcept UNDERACT_REAL_TIME;
  void replaceBy(Instance* instance, tick::Carry carry, std::int64_t over_ticks = 0) noexcept UNDERACT_REAL_TIME;
  void push(const Command& command) noexcept UNDERACT_REAL_TIME;
  void informTap() noexcept UNDERACT_REAL_TIME;
  void retire(Instance* instance) noexcept UNDERACT_REAL_TIME;
  Mode mode() const noexcept UNDERACT_REAL_TIME;
  bool pushes() const noexcept UNDERACT_REAL_TIME;
  Fault faultOf(const Wake& wake) noexcept UNDERACT_REAL_TIME;
  Fault faultOfClocks(const Wake& wake, const tick::TickInput& input, std::int64_t now_ns,
                      std::int64_t with_sleep_ns) noexcept UNDERACT_REAL_TIME;
  void countLate(const Wake& wake) noexcept UNDERACT_REAL_TIME;
  void remember(const Snapshot& snapshot) noexcept UNDERACT_REAL_TIME;
  void addDetails(const Snapshot& snapshot) noexcept UNDERACT_REAL_TIME;

  DevicePort& device_;
  Instance* current_;
  Instance* waiting_ = nullptr;  // to be swapped in at zero force
  Tap* tap_ = nullptr;           // null: none
  bool engaged_ = false;
  bool restart_ = false;
  std::uint32_t epoch_ = 0;  // of the last sample
  bool hold_to_run_ = false;
  bool was_faulted_ = false;
  Vec3 push_T_W_ = Vec3::Zero();
  std::int64_t push_left_ = 0;  // ticks
  bool is_push_new_ = false;    // the tap has not got it yet
  std::uint64_t orders_ = 0;    // taken up
  std::int64_t period_ns_, watchdog_ns_;
  system::Clocks clocks_;
  SleepWatch sleep_;
  std::int64_t slept_ns_ = 0;  // not reported to a tick yet
  ArmClockWatch arm_clock_;
  std::int64_t counted_ns_ = 0;  // the servo's time where it has no clock
  LateTicks late_;
  std::atomic<std::int64_t> own_beats_{0};
  std::atomic<std::int64_t>* beats_ = &own_beats_;
  std::atomic<std::int64_t> stood_still_ns_{0}, busy_window_ns_{0};
  std::atomic<std::uint64_t> stops_{0};
  static_assert(std::atomic<std::uint64_t>::is_always_lock_free);  // for handlers of signals
  std::uint64_t heeded_ = 0;                                       // of stops_
  std::array<History, kHistories> histories_;
  History* history_;  // the one being written
  std::int64_t ticks_ = 0;
  std::int64_t dropped_ = 0;
  std::int64_t read_ns_ = 0;
  Slot<Snapshot> snapshots_;
  std::vector<TickRecord> left_;  // rows from before the last setPeriod(), for drain()
  boost::lockfree::spsc_queue<Command> commands_;
  boost::lockfree::spsc_queue<Instance*> retired_;
  std::unique_ptr<boost::lockfree::spsc_queue<TickRecord>> records_;
  boost::lockfree::spsc_queue<History*> full_, spare_;
};

}  // namespace underact::servo
