#pragma once
#include <boost/lockfree/spsc_queue.hpp>
#include <cstdint>
#include <functional>
#include <memory>

#include "core/servo/device_port.h"
#include "core/servo/slot.h"
#include "core/servo/snapshot.h"
#include "core/tick/step.h"

namespace underact::servo {

/// A tick program with its memory, made outside the servo thread, and the number by which the Host knows it.
struct Instance {
  tick::TickProgram program;
  tick::TickState state;
  std::uint64_t revision = 0;
};

/// What the servo can be told. Load: another scene, swapped in once the force has ramped to zero. Retune: the same
/// scene with other gains, swapped in before the next tick. Move: so is the same scene with its targets elsewhere.
enum class Order : std::uint8_t { Start, Stop, Load, Retune, Move };

struct Command {
  Order order = Order::Stop;
  Instance* instance = nullptr;  // owned by the loop from here on; given back by reap()
};

/// What the servo thread does each period: take up commands, read the arm, tick, write the force, hand the results on.
/// It waits for nothing and allocates nothing; the queues have one writer and one reader each and their room from the
/// start.
class Loop {
 public:
  explicit Loop(DevicePort& device);
  ~Loop();
  Loop(const Loop&) = delete;
  Loop& operator=(const Loop&) = delete;

  // The servo thread, or whoever stands in for it.
  void tick(std::int64_t lateness_ns) noexcept UNDERACT_REAL_TIME;
  /// Zero force, for the end.
  void release() noexcept UNDERACT_REAL_TIME;

  // The other side: one thread.
  bool send(const Command& command);  // false: no room; try again later
  void reap();                        // frees the instances that are out of use
  const Snapshot& snapshot() { return snapshots_.latest(); }
  void drain(const std::function<void(const TickRecord&)>& row);

 private:
  void takeUpCommands() noexcept UNDERACT_REAL_TIME;
  void replaceBy(Instance* instance, tick::Carry carry) noexcept UNDERACT_REAL_TIME;
  void retire(Instance* instance) noexcept UNDERACT_REAL_TIME;
  Mode mode() const noexcept UNDERACT_REAL_TIME;

  DevicePort& device_;
  Instance* current_;
  Instance* waiting_ = nullptr;  // to come in at zero force
  bool engaged_ = false;
  bool restart_ = false;
  std::int64_t ticks_ = 0;
  std::int64_t dropped_ = 0;
  Slot<Snapshot> snapshots_;
  boost::lockfree::spsc_queue<Command> commands_;
  boost::lockfree::spsc_queue<Instance*> retired_;
  boost::lockfree::spsc_queue<TickRecord> records_;
};

}  // namespace underact::servo
