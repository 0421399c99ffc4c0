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

/// A process beside the program that outlives it: when the program dies, however it dies, or its ticks stop, the guard
/// writes the arm's last word. It holds a copy of the arm's file descriptor, sees the ticks in shared memory and the
/// program's life at the other end of a pipe. It is watched in turn, by a thread of its own: one that ends, or stands
/// still, is replaced (see RestartPace). The force goes on meanwhile: gate and watchdog work without a guard, and an
/// arm that lets go of a hand without need is no safer.
class Guard {
 public:
  /// Starts it. program: where underact-guard is; empty: beside this program, or in libexec/underact. Null where there
  /// is none, where it does not start, or where the arm has no last word; then why says so.
  static std::unique_ptr<Guard> start(const LastWord& word, std::int64_t limit_ns, const std::string& program,
                                      Sentence& why);
  ~Guard();  // an orderly end: the guard leaves without a word
  Guard(const Guard&) = delete;
  Guard& operator=(const Guard&) = delete;

  /// What the servo counts up each tick; lives as long as this, whatever process looks at it.
  std::atomic<std::int64_t>& beats();
  /// Empty: it guards. Else why it does not just now, as a phrase. Any thread but the tick's.
  Sentence gap() const;
  /// How many times it was replaced. Any thread.
  int replaced() const { return replaced_.load(std::memory_order_relaxed); }

 private:
  Guard(std::unique_ptr<GuardProcess> process, std::int64_t limit_ns, system::Doorbell wake);
  void watch();
  bool waitUntilItEnds();
  bool startAnother();
  bool isToldToEnd(std::int64_t until_ns) const;
  void setGap(Sentence gap);

  const std::unique_ptr<GuardProcess> process_;
  const std::int64_t patience_ns_;  // with a guard that does not look
  system::Doorbell wake_;           // rung: the watching ends
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
Sentence nothingGuards(const Sentence& gap);

}  // namespace underact::servo
