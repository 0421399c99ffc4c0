#pragma once
#include <condition_variable>
#include <cstdint>
#include <functional>
#include <mutex>
#include <thread>

namespace underact::servo {

/// Watches something that counts its turns (the servo's ticks, those of the window's thread) from a thread of its own.
/// After limit_ns without a turn it says for how long there was none, again and again until there is one.
class Watchdog {
 public:
  /// turns: the count; stalled: gets the length of the pause, ns. Both are called from the watchdog's thread. Starts
  /// the thread; the destructor ends it and waits. limit_ns: above 0.
  Watchdog(std::function<std::int64_t()> turns, std::int64_t limit_ns, std::function<void(std::int64_t)> stalled);
  ~Watchdog();
  Watchdog(const Watchdog&) = delete;
  Watchdog& operator=(const Watchdog&) = delete;

 private:
  void run();

  std::function<std::int64_t()> turns_;
  std::int64_t limit_ns_;
  std::function<void(std::int64_t)> stalled_;
  std::mutex mutex_;
  std::condition_variable wake_;
  bool ends_ = false;
  std::thread thread_;
};

}  // namespace underact::servo
