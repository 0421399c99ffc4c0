#pragma once
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
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

/// Thread: once begun, the servo runs by itself on absolute deadlines. Manual: it ticks when run() is called, as fast
/// as it can.
enum class Clock : std::uint8_t { Thread, Manual };

/// How the servo is to run.
struct HostOptions {
  int rate_hz = 1000;  // 100 to 10000
  Clock clock = Clock::Thread;
  system::SchedulingWanted scheduling = {};
  double watchdog_s = 0.1;  // no tick for so long: the arm gets zero force from outside the servo thread, and a fault
  int max_late = 20;        // ticks in a row a whole period late that are borne; more let the force go, and are a fault
  std::string guard_program = {};  // underact-guard, for an arm that has a last word; empty: it is looked for
  system::Clocks clocks = {};
};

/// Everything a fault leaves behind.
struct FaultReport {
  Fault fault;
  std::int64_t tick = 0;
  std::int64_t unix_time_s = 0;         // when it was fetched from the servo
  std::vector<TickRecord> last_second;  // up to and with the tick that found it, oldest first
  scene::Description scene;             // as it was run
  DeviceInfo device;
  Sentence trouble;  // what the arm's side said of it, see DevicePort::trouble()
  system::Scheduling scheduling;
  int rate_hz = 0;  // then
  LateTicks late;
};

/// The servo as the rest of the program sees it: owns device, loop and thread; keeps the scene, compiles it and every
/// edit, and hands them to the servo between two ticks. One thread (the window's, or the command line's) calls it;
/// nothing waits.
class Host {
 public:
  /// device: open; it is closed with the host. Nothing ticks before begin() or run().
  Host(std::unique_ptr<DevicePort> device, const HostOptions& options);
  ~Host();
  Host(const Host&) = delete;
  Host& operator=(const Host&) = delete;

  /// Loads a scene: the old one is released, the swap made between two ticks at zero force, the new one ramped up
  /// (where the servo runs). Problems: those of compile(); then the old scene stays.
  Problems load(const scene::Description& scene);
  /// Puts an edited scene in place of the one there is. Where both go together (see scene::changeBetween) it is taken
  /// up by the next tick, without a ramp, and the laws keep what they remember; else it is ramped down and up like a
  /// load. Problems: as load(); then the old scene stays.
  Problems edit(const scene::Description& edited);
  /// What load() would run: for somebody who reckons beside the servo. Problems: as load().
  Result<tick::TickProgram> programOf(const scene::Description& scene) const;
  /// The scene as loaded and edited.
  const scene::Description& scene() const;
  /// Counts up by one with each load and edit that was taken; Snapshot::revision says which one is in effect.
  std::uint64_t revision() const;

  void start();          // also after a fault
  void stop();           // the force ramps to zero
  bool running() const;  // start() was called last, and no fault since
  /// Hold to run: from then on the servo pushes only while the stylus button nearer to the tip is held.
  void setHoldToRun(bool on);
  /// As set last.
  bool holdToRun() const;
  /// Limits the force to this share of the arm's continuous force, 0 to 1, from the next tick on and for every scene to
  /// come; the gate's clamp does it. Problems: a session is being recorded, and would replay with another limit; a
  /// share outside 0 to 1. Then nothing changes.
  Problems setForceShare(double share);
  /// As set last; 1 at first.
  double forceShare() const;
  /// The servo thread ends and begins anew, the arm is asked to open itself again, the scene stays; the servo is
  /// stopped then, and Start goes on. Problems: why the arm did not open.
  Problems restart();
  /// The servo ticks so many times a second from now on, 100 to 10000. It lets go first (the force ramps to zero, which
  /// is waited for: 0.05 s), its thread ends and begins anew, and where it ran it starts again; what counts in ticks
  /// begins anew (see Loop::setPeriod), and so does timing(). Manual clock: it ticks until it has let go. Problems: a
  /// session is being recorded; the arm has one rate alone; no such rate. Then nothing was done.
  Problems setRate(int rate_hz);
  /// The oldest fault that was not taken yet.
  std::optional<FaultReport> takeFault();

  /// The newest, as a copy: it stays what it was whatever is called then.
  Snapshot snapshot();
  /// Lateness and tick times of what drain() has seen, at the present rate.
  const Timing& timing() const;
  /// Calls row() for every tick since the last call, in order. Call it about 30 times a second, or rows drop (counted).
  void drain(const std::function<void(const TickRecord&)>& row);
  /// Thread clock only: the servo thread starts to tick. What was told the host before is taken up by its first tick.
  void begin();
  /// Manual clock only.
  void run(std::int64_t ticks);

  /// From the next tick on everything goes to the tap, too; one at a time, the one before it ends. Manual clock: run()
  /// waits while the tap is full.
  void record(std::shared_ptr<Tap> tap);
  /// No more goes to the tap; it has ended when Tap::ended() says so.
  void endRecord();
  /// A tap is being filled.
  bool records() const;

  /// Ticks a second, as set last.
  int rateHz() const;
  /// What the system granted to the servo thread, or by what else it ticks.
  system::Scheduling scheduling() const;
  /// What was asked for.
  const system::SchedulingWanted& schedulingWanted() const;
  /// Whether a process guards the arm, or why none does: a phrase, as in Scheduling::also. Empty: no tick yet.
  Sentence guarding() const;
  /// Why nothing would tell the arm zero if the program died, with a way out, where an arm can be told: its guard has
  /// ended or did not start. Empty: it is guarded, or there is no such way (the simulated arm), or no tick yet.
  Sentence unguarded() const;
  /// After so many late ticks in a row the force is let go.
  int maxLate() const;
  /// What the arm says of itself, see DevicePort::info().
  DeviceInfo device() const;
  /// What the arm's side says is wrong now; empty: nothing.
  Sentence trouble() const;

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace underact::servo
