#pragma once
#include <cstdint>
#include <functional>
#include <memory>
#include <string>

#include "core/base/result.h"
#include "core/scene/description.h"
#include "core/servo/device_port.h"
#include "core/servo/snapshot.h"

namespace underact::servo {

/// Thread: once begun, the servo runs by itself on absolute deadlines. Manual: it ticks when run() is called, as fast
/// as it can.
enum class Clock : std::uint8_t { Thread, Manual };

struct HostOptions {
  int rate_hz = 1000;  // 100 to 4000
  Clock clock = Clock::Thread;
};

/// What scheduling the system granted the servo thread.
struct Scheduling {
  std::string name;  // "FIFO 80", "normal", "manual", "not begun": for the status bar
  std::string hint;  // how to get better; empty: it is as good as it gets
};

/// The servo as the rest of the program sees it: owns device, loop and thread; keeps the scene, compiles it and every
/// edit, and hands them to the servo between two ticks. One thread (the window's, or the command line's) calls it;
/// nothing waits.
class Host {
 public:
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
  /// The scene as loaded and edited.
  const scene::Description& scene() const;
  /// Counts up by one with each load and edit that was taken; Snapshot::revision says which one is in effect.
  std::uint64_t revision() const;

  void start();          // also after a fault
  void stop();           // the force ramps to zero
  bool running() const;  // start() was called last, and no fault since

  const Snapshot& snapshot();
  /// Calls row() for every tick since the last call, in order. Call it about 30 times a second, or rows drop (counted).
  void drain(const std::function<void(const TickRecord&)>& row);
  /// Thread clock only: the servo thread starts to tick. What was told the host before is taken up by its first tick.
  void begin();
  /// Manual clock only.
  void run(std::int64_t ticks);

  int rateHz() const;
  Scheduling scheduling() const;
  DeviceInfo device() const;

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace underact::servo
