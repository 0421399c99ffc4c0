#pragma once
#include <atomic>
#include <cstdint>
#include <memory>
#include <mutex>
#include <string>
#include <thread>

#include "core/servo/device_port.h"
#include "core/servo/restart_pace.h"
#include "core/system/doorbell.h"

namespace underact::servo {

class GuardProcess;

/// A separate process that outlives the program: when the program dies in any way, or its ticks stop, the guard sends
/// the arm its message of zero force. It holds a copy of the arm's file descriptor, sees the ticks in shared memory and
/// the end of the program by a pipe. A thread of this class watches it in turn: a guard that ends or hangs is replaced
/// (see RestartPace). The force stays on meanwhile: gate and watchdog work without a guard, and releasing a hand
/// without need would not be safer.
class Guard {
 public:
  /// Starts it. program: the path of underact-guard; empty: beside this program, or in libexec/underact. Null where it
  /// is missing or does not start, or where the arm has no such message; then why says so.
  static std::unique_ptr<Guard> start(const ZeroForceMessage& word, std::int64_t limit_ns, const std::string& program,
                                      Sentence& why);
  ~Guard();  // an orderly end: the guard ends without sending anything
  Guard(const Guard&) = delete;
  Guard& operator=(const Guard&) = delete;

  /// The counter of ticks, in shared memory; lives as long as this object.
  std::atomic<std::int64_t>& beats();
  /// Why the arm is not guarded right now, as a phrase; empty: it is. Any thread but the tick's.
  Sentence gap() const;
  /// How many times it was replaced. Any thread.
  int replaced() const { return replaced_.load(std::memory_order_relaxed); }

 private:
  Guard(std::unique_ptr<GuardProcess> process, std::int64_t limit_ns, system::Doorbell wake);
  void watch();
  bool waitUntilItEnds();
  bool startAnother();
  bool isStopRequested(std::int64_t until_ns) const;
  void setGap(Sentence gap);

  const std::unique_ptr<GuardProcess> process_;
  const std::int64_t patience_ns_;  // how long a guard may be unresponsive
  system::Doorbell wake_;           // rung: the watching thread ends
  RestartPace pace_;
  mutable std::mutex gap_mutex_;
  Sentence gap_;
  std::atomic<int> replaced_{0};
  std::thread thread_;
};

/// For the list of what the system granted: "guarded by a separate process", or why not. guard: null where none was
/// started, for the reason in why_none.
Sentence guardPhrase(const Guard* guard, const Sentence& why_none);

/// For a person, with a way out. gap: see Guard::gap(), or why no guard was started.
Sentence noGuardText(const Sentence& gap);

}  // namespace underact::servo
