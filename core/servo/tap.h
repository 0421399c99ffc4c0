#pragma once
#include <atomic>
#include <boost/lockfree/spsc_queue.hpp>
#include <cstdint>
#include <functional>
#include <map>
#include <mutex>

#include "core/base/real_time.h"
#include "core/scene/description.h"
#include "core/servo/snapshot.h"
#include "core/tick/state.h"

namespace underact::servo {

/// A program came into effect at the beginning of a tick, with what it took over from the one before it.
struct Change {
  std::int64_t tick = 0;
  std::uint64_t revision = 0;
  tick::Carry carry = tick::Carry::Arm;
};

/// A fault that a tick was told of (from_servo: the watchdog's, say) or that it ended with.
struct FaultMark {
  std::int64_t tick = 0;
  Fault fault;
  bool from_servo = false;
};

/// Where a recorder listens: everything that goes into each tick, and what came of it, from one tick on without a gap.
/// The servo waits for nobody; what finds no room is counted. One servo, one recorder, one Host.
class Tap {
 public:
  /// period_ns: of the servo; there is room for 4 s of ticks, 16384 at least. most_ticks: it listens to no more; 0: to
  /// all.
  explicit Tap(std::int64_t period_ns, std::int64_t most_ticks = 0);

  // The servo thread.
  /// The tick that comes is the first one; state: the memory it begins with. Copies it without allocating.
  void begin(std::int64_t tick, std::uint64_t revision, const tick::TickState& state) noexcept UNDERACT_REAL_TIME;
  // After begin(), in the order in which they happen; what finds no room is counted in dropped(); after giveUp(),
  // nothing.
  void add(const TickRecord& record) noexcept UNDERACT_REAL_TIME;
  void add(const Change& change) noexcept UNDERACT_REAL_TIME;
  void add(const FaultMark& fault) noexcept UNDERACT_REAL_TIME;
  /// No more will come.
  void end() noexcept UNDERACT_REAL_TIME { ended_.store(true, std::memory_order_release); }

  // The recorder's thread. What follows begun() may be read once that is true.
  bool begun() const { return begun_.load(std::memory_order_acquire); }
  bool ended() const { return ended_.load(std::memory_order_acquire); }
  std::int64_t firstTick() const { return first_tick_; }
  std::uint64_t firstRevision() const { return first_revision_; }
  const tick::TickState& start() const { return start_; }
  /// In order. A change and a fault are there when the tick they belong to is.
  bool take(TickRecord& record) { return records_.pop(record); }
  bool take(Change& change) { return changes_.pop(change); }
  bool take(FaultMark& fault) { return faults_.pop(fault); }
  /// The scene of a revision that was said by a change; it is forgotten by this.
  scene::Description takeScene(std::uint64_t revision);

  // Any thread.
  std::int64_t dropped() const { return dropped_.load(std::memory_order_relaxed); }
  std::size_t room() const { return records_.write_available(); }
  /// Nobody fetches any more: add() does nothing from then on.
  void giveUp() { given_up_.store(true, std::memory_order_relaxed); }
  /// Whether giveUp() was called.
  bool givenUp() const { return given_up_.load(std::memory_order_relaxed); }
  /// Before the revision can come into effect.
  void announce(std::uint64_t revision, const scene::Description& scene);

 private:
  bool listens() const noexcept UNDERACT_REAL_TIME { return !given_up_.load(std::memory_order_relaxed); }
  void drop() noexcept UNDERACT_REAL_TIME { dropped_.fetch_add(1, std::memory_order_relaxed); }

  boost::lockfree::spsc_queue<TickRecord> records_;
  boost::lockfree::spsc_queue<Change> changes_;
  boost::lockfree::spsc_queue<FaultMark> faults_;
  std::int64_t ticks_left_;
  tick::TickState start_;
  std::int64_t first_tick_ = 0;
  std::uint64_t first_revision_ = 0;
  std::atomic<std::int64_t> dropped_{0};
  std::atomic<bool> begun_{false}, ended_{false}, given_up_{false};
  std::mutex scenes_mutex_;  // between Host and recorder; the servo never comes here
  std::map<std::uint64_t, scene::Description> scenes_;
};

}  // namespace underact::servo
