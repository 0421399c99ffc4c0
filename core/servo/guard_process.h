#pragma once
#include <cstdint>
#include <string>

#include "core/servo/device_port.h"
#include "core/servo/guard_line.h"

namespace underact::servo {

/// What one guard after the other is given, and the one that is at work. One thread at a time. Linux.
class GuardProcess {
 public:
  /// program: where underact-guard is.
  GuardProcess(const LastWord& word, std::int64_t limit_ns, std::string program);
  ~GuardProcess();  // an orderly end: the guard leaves without a word; one that does not leave is killed
  GuardProcess(const GuardProcess&) = delete;
  GuardProcess& operator=(const GuardProcess&) = delete;

  /// The same for all guards; null: what guards are given could not be made, and failure() says why.
  GuardLine* line() const { return line_; }
  /// Starts one; before, and after the one before has ended. false: failure() says why.
  bool start();
  /// Of the system, an error number.
  int failure() const { return failure_; }
  /// Readable once it has ended; below 0: this system has no such descriptor, and hasEnded() is to be asked now and
  /// then.
  int endFd() const { return end_fd_; }
  /// It is gone, or there was none.
  bool hasEnded();
  /// At once, wherever it hangs.
  void kill();

 private:
  bool waitForEnd(int time_ms);

  const std::int64_t limit_ns_;
  const std::string program_, word_;
  GuardLine* line_ = nullptr;
  int memory_fd_ = -1, device_fd_ = -1;
  int life_fd_ = -1, watched_fd_ = -1;  // a pipe: the program's end, and the one that guards look at
  int pid_ = -1, end_fd_ = -1;
  int failure_ = 0;
};

}  // namespace underact::servo
