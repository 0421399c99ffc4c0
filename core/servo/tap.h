#pragma once
#include <atomic>
#include <boost/lockfree/spsc_queue.hpp>
#include <cstdint>
#include <functional>
#include <map>
#include <memory>
#include <mutex>

#include "core/base/real_time.h"
#include "core/scene/description.h"
#include "core/servo/device_port.h"
#include "core/servo/snapshot.h"
#include "core/tick/state.h"

namespace underact::servo {

/// A program came into effect at the beginning of a tick, with the state it took over from the last one.
struct Change {
  std::int64_t tick = 0;
  std::uint64_t revision = 0;
  tick::Carry carry = tick::Carry::Arm;
  std::int64_t over_ticks = 0;  // over which the targets are carried to their new places; 0: at once
};

/// From a tick on a force is added before the gate, for so many ticks, instead of any earlier one. 0 ticks: none is.
/// At most one a tick comes to a recorder, however often a client asked between two.
struct Push {
  std::int64_t tick = 0;
  Vec3 f_T_W = Vec3::Zero();  // N
  std::int64_t ticks = 0;
};

/// A fault that was found before a tick (from_servo: by the watchdog, say) or by it.
struct FaultMark {
  std::int64_t tick = 0;
  Fault fault;
  bool from_servo = false;
};

/// What a simulated arm knows of a tick.
struct TruthRow {
  std::int64_t tick = 0;
  Truth truth;
};

/// One constraint in one tick.
struct ConstraintRow {
  std::int64_t tick = 0;
  std::uint32_t constraint = 0;  // its index in the scene
  bool acts = false;             // it contributes to the force
  Vec3 p_WP = Vec3::Zero();      // its target, m; NaN: none
  Vec3 f_T_W = Vec3::Zero();     // its own force, N, before the gate
};

/// A recorder's access to the servo: all input and results of each tick, from one tick on without a gap. The servo
/// never waits; what finds no room is counted. One servo, one recorder, one Host.
class Tap {
 public:
  /// period_ns: of the servo; there is room for 4 s of ticks, 16384 at least. max_ticks: it takes no more; 0: no
  /// limit. details: room for so many constraints of each tick, and for what a simulated arm knows; 0: these are not
  /// wanted.
  explicit Tap(std::int64_t period_ns, std::int64_t max_ticks = 0, std::size_t details = 0);

  // The servo thread.
  /// The next tick is the first one, or, where wantsStart(), the first one of another part; state: at its beginning.
  /// Copies it without allocating.
  void begin(std::int64_t tick, std::uint64_t revision, const tick::TickState& state) noexcept UNDERACT_REAL_TIME;
  // After begin(), in the order in which they happen; what finds no room is counted in dropped(); after giveUp(),
  // nothing.
  void add(const TickRecord& record) noexcept UNDERACT_REAL_TIME;
  void add(const Change& change) noexcept UNDERACT_REAL_TIME;
  void add(const FaultMark& fault) noexcept UNDERACT_REAL_TIME;
  void add(const Push& push) noexcept UNDERACT_REAL_TIME;
  /// Whether the recorder wants to begin another part.
  bool wantsStart() const noexcept UNDERACT_REAL_TIME {
    return wants_start_.load(std::memory_order_acquire) && ticks_left_ != 0;
  }
  /// Whether TruthRow and ConstraintRow are wanted; those of a tick come before its record.
  bool wantsDetails() const noexcept UNDERACT_REAL_TIME { return details_ > 0; }
  void add(const TruthRow& row) noexcept UNDERACT_REAL_TIME;       // only where these are wanted; what
  void add(const ConstraintRow& row) noexcept UNDERACT_REAL_TIME;  // finds no room is counted in dropped()
  /// No more will come.
  void end() noexcept UNDERACT_REAL_TIME { ended_.store(true, std::memory_order_release); }

  // The recorder's thread. What follows begun() may be read once that is true, until the next wantStart().
  bool begun() const { return begun_.load(std::memory_order_acquire); }
  bool ended() const { return ended_.load(std::memory_order_acquire); }
  std::int64_t firstTick() const { return first_tick_; }
  std::uint64_t firstRevision() const { return first_revision_; }
  const tick::TickState& start() const { return start_; }
  /// Asks for the servo's state at the beginning of a tick to come. begun() is false until it is there; then there is
  /// all of the ticks before it, and a force that lasts is told anew.
  void wantStart() {
    begun_.store(false, std::memory_order_relaxed);
    wants_start_.store(true, std::memory_order_release);
  }
  /// In order; false: nothing new. A change and a fault are there as soon as the tick they belong to.
  bool take(TickRecord& record) { return records_.pop(record); }
  bool take(Change& change) { return changes_.pop(change); }
  bool take(FaultMark& fault) { return faults_.pop(fault); }
  bool take(Push& push) { return pushes_.pop(push); }
  bool take(TruthRow& row) { return truths_ != nullptr && truths_->pop(row); }
  bool take(ConstraintRow& row) { return constraints_ != nullptr && constraints_->pop(row); }
  /// The scene of a revision that a change named; the tap forgets it then.
  scene::Description takeScene(std::uint64_t revision);

  // Any thread.
  std::int64_t dropped() const { return dropped_.load(std::memory_order_relaxed); }
  /// For how many ticks there is room.
  std::size_t room() const;
  /// The recorder takes no more: add() does nothing from then on.
  void giveUp() { given_up_.store(true, std::memory_order_relaxed); }
  /// Whether giveUp() was called.
  bool givenUp() const { return given_up_.load(std::memory_order_relaxed); }
  /// Sets the scene of a revision; to be called before it can come into effect.
  void announce(std::uint64_t revision, const scene::Description& scene);

 private:
  bool listens() const noexcept UNDERACT_REAL_TIME { return !given_up_.load(std::memory_order_relaxed); }
  void drop() noexcept UNDERACT_REAL_TIME { dropped_.fetch_add(1, std::memory_order_relaxed); }

  boost::lockfree::spsc_queue<TickRecord> records_;
  boost::lockfree::spsc_queue<Change> changes_;
  boost::lockfree::spsc_queue<FaultMark> faults_;
  boost::lockfree::spsc_queue<Push> pushes_;
  std::unique_ptr<boost::lockfree::spsc_queue<TruthRow>> truths_;            // null: not wanted
  std::unique_ptr<boost::lockfree::spsc_queue<ConstraintRow>> constraints_;  // null: not wanted
  std::size_t details_;
  std::int64_t ticks_left_;
  tick::TickState start_;
  std::int64_t first_tick_ = 0;
  std::uint64_t first_revision_ = 0;
  std::atomic<std::int64_t> dropped_{0};
  std::atomic<bool> begun_{false}, wants_start_{false}, ended_{false}, given_up_{false};
  std::mutex scenes_mutex_;  // between Host and recorder; the servo never locks it
  std::map<std::uint64_t, scene::Description> scenes_;
};

}  // namespace underact::servo
