#pragma once
#include <atomic>
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "core/base/result.h"
#include "core/scene/description.h"
#include "core/servo/device_port.h"
#include "core/servo/snapshot.h"
#include "core/servo/tap.h"
#include "core/servo/timing.h"
#include "core/system/clock.h"
#include "core/system/scheduling.h"
#include "core/tick/program.h"

namespace underact::servo {

/// Thread: the servo runs by itself on absolute deadlines, from begin() on. Manual: it ticks when run() is called, as
/// fast as it can.
enum class Clock : std::uint8_t { Thread, Manual };

/// How the servo is to run.
struct HostOptions {
  int rate_hz = 1000;  // 100 to 10000
  Clock clock = Clock::Thread;
  system::SchedulingRequest scheduling = {};
  double watchdog_s = 0.1;         // no tick for so long: the watchdog writes zero force, and it is a fault
  int max_late = 20;               // ticks in a row a whole period late; more release the force and are a fault
  std::string guard_program = {};  // the path of underact-guard; empty: it is looked for
  system::Clocks clocks = {};
};

/// A fault, and the circumstances in which it occurred.
struct FaultReport {
  Fault fault;
  std::int64_t tick = 0;
  std::int64_t unix_time_s = 0;         // when it was fetched from the servo
  std::vector<TickRecord> last_second;  // up to and including the tick that found it, oldest first
  scene::Description scene;             // as it was run
  DeviceInfo device;
  Sentence trouble;  // what the device reported, see DevicePort::trouble()
  system::Scheduling scheduling;
  int rate_hz = 0;  // then
  LateTicks late;
};

/// The servo as the rest of the program sees it: owns device, loop and thread; keeps the scene, compiles it and every
/// edit, and hands them to the servo between two ticks. To be called by one thread (the window's, or the command
/// line's); unless stated, no call waits.
class Host {
 public:
  /// device: open; it is closed with the host. Nothing ticks before begin() or run().
  Host(std::unique_ptr<DevicePort> device, const HostOptions& options);
  ~Host();
  Host(const Host&) = delete;
  Host& operator=(const Host&) = delete;

  /// Loads a scene: the force is ramped down, the scene replaced between two ticks at zero force, and, where the servo
  /// runs, the force ramped up again. Problems: those of compile(); then the old scene stays.
  Problems load(const scene::Description& scene);
  /// Replaces the scene by an edited one. Where the two are compatible (see scene::changeBetween()) the next tick takes
  /// it up without a ramp, and the laws keep their state; otherwise as load(). Problems: as load(); then the old scene
  /// stays.
  /// over_ticks: above 0, and where only targets move, they are carried to their new places over so many ticks, from
  /// where they are in the next one, and the laws feel them move. A target of a kind that cannot be carried is moved at
  /// once.
  Problems edit(const scene::Description& edited, std::int64_t over_ticks = 0);
  /// The program that load() would run, for computations outside the servo. Problems: as load().
  Result<tick::TickProgram> programOf(const scene::Description& scene) const;
  /// The scene as loaded and edited.
  const scene::Description& scene() const;
  /// Goes up by one with each load and edit that was accepted; Snapshot::revision says which one is in effect.
  std::uint64_t revision() const;

  /// Adds a force on the tip, N in W, finite, before the gate, from the next tick on and for so many, instead of an
  /// earlier one. 0 ticks: none.
  void push(const Vec3& f_T_W, std::int64_t ticks);
  /// The number of orders given; a tick that has TickRecord::orders as high has taken up all of them (a load waits for
  /// zero force: see revision()).
  std::uint64_t orders() const;

  void start();          // also after a fault
  void stop();           // the force ramps to zero, and forces of push() end
  bool running() const;  // start() was called last, and no fault since
  /// Counted up by any thread, or by the handler of a signal, it stops the servo with the next tick, whatever this
  /// host's own thread is doing; a start() before that is void.
  std::atomic<std::uint64_t>& stops() noexcept;
  /// Any thread: the window's thread, where Stop is pressed, has stood still for so long. A fault, if the servo pushes.
  void reportBusyWindow(std::int64_t pause_ns) noexcept;
  /// Hold to run: the servo pushes only while the stylus button nearer to the tip is held.
  void setHoldToRun(bool on);
  /// As set last.
  bool holdToRun() const;
  /// Limits the force to this share of the arm's continuous force, 0 to 1, from the next tick on and for every scene to
  /// come; the gate's clamp does it. Problems: a session is being recorded, and would replay with another limit; a
  /// share outside 0 to 1. Then nothing changes.
  Problems setForceShare(double share);
  /// As set last; 1 at first.
  double forceShare() const;
  /// Restarts the servo thread and reopens the arm; the scene stays. The servo is stopped then; start() continues.
  /// Problems: why the arm did not open. Waits for it.
  Problems restart();
  /// Changes the rate, 100 to 10000 ticks a second. The force is ramped to zero first, which takes 0.05 s and is waited
  /// for; then the thread is restarted, and the servo started again if it ran. What counts in ticks begins anew (see
  /// ServoLoop::setPeriod()), and so does timing(). Manual clock: ticks are run until the force is zero. Problems: a
  /// session is being recorded; the arm has a fixed rate; a rate out of range. Then nothing changes.
  Problems setRate(int rate_hz);
  /// The oldest fault that was not taken yet, and the next one with the next call.
  std::optional<FaultReport> takeFault();

  /// The newest snapshot, as a copy.
  Snapshot snapshot();
  /// Latency and tick times of what drain() has seen, at the present rate.
  const Timing& timing() const;
  /// Calls row() for every tick since the last call, in order. To be called about 30 times a second, or rows are
  /// dropped (and counted).
  void drain(const std::function<void(const TickRecord&)>& row);
  /// Thread clock only: starts the servo thread. Its first tick takes up all earlier calls.
  void begin();
  /// Manual clock only: runs so many ticks. lateness_ns: how late each of them began, from the first one of this call
  /// on, as a recording has it; empty: none is late.
  void run(std::int64_t ticks, std::span<const std::int64_t> lateness_ns = {});

  /// Copies everything to the tap from the next tick on; one tap at a time, an earlier one ends. Manual clock: run()
  /// waits while the tap is full.
  void record(std::shared_ptr<Tap> tap);
  /// Ends the copying to the tap; Tap::ended() says when it has ended.
  void endRecord();
  /// Whether there is a tap.
  bool records() const;

  /// Ticks a second, as set last.
  int rateHz() const;
  /// What the system granted to the servo thread, or by what else it ticks.
  system::Scheduling scheduling() const;
  /// What was asked for.
  const system::SchedulingRequest& schedulingWanted() const;
  /// Whether a process guards the arm, or why none does: a phrase, as in Scheduling::also. Empty: no tick yet.
  Sentence guarding() const;
  /// Why nothing would release the force if the program died, with a way out, for an arm that can be guarded: its guard
  /// has ended or did not start. Empty: it is guarded, or cannot be (the simulated arm), or no tick yet.
  Sentence unguarded() const;
  /// The number of late ticks in a row after which the force is released.
  int maxLate() const;
  /// What the arm says of itself, see DevicePort::info().
  DeviceInfo device() const;
  /// What the device reports as wrong now; empty: nothing.
  Sentence trouble() const;

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace underact::servo
