#pragma once
#include <atomic>
#include <cstdint>
#include <memory>
#include <string>

#include "core/servo/device_port.h"
#include "core/servo/guard_line.h"

namespace underact::servo {

/// A process beside the program that outlives it: when the program dies, however it dies, or its ticks stop, the guard
/// writes the arm's last word. It holds a copy of the arm's file descriptor, sees the ticks in shared memory and the
/// program's life at the other end of a pipe. Linux.
class Guard {
 public:
  /// Starts it. program: where underact-guard is; empty: beside this program, or in libexec/underact. Null where there
  /// is none, where it does not start, or where the arm has no last word; then why says so.
  static std::unique_ptr<Guard> start(const LastWord& word, std::int64_t limit_ns, const std::string& program,
                                      Sentence& why);
  ~Guard();  // an orderly end: the guard leaves without a word
  Guard(const Guard&) = delete;
  Guard& operator=(const Guard&) = delete;

  /// What the servo counts up each tick; lives as long as the guard.
  std::atomic<std::int64_t>& beats() { return line_->beats; }

 private:
  Guard() = default;
  GuardLine* line_ = nullptr;
  int memory_fd_ = -1;
  int life_fd_ = -1;
  int pid_ = -1;
};

}  // namespace underact::servo
