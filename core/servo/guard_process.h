#pragma once
#include <cstdint>
#include <string>

#include "core/servo/device_port.h"
#include "core/servo/guard_line.h"
#include "core/system/channel.h"
#include "core/system/process.h"
#include "core/system/shared_memory.h"

namespace underact::servo {

/// What one guard after the other is given, and the one that is at work. One thread at a time.
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
  int endFd() const { return process_.endDescriptor(); }
  /// It is gone, or there was none.
  bool hasEnded() { return process_.hasEnded(); }
  /// At once, wherever it hangs.
  void kill() { process_.kill(); }

 private:
  const std::int64_t limit_ns_;
  const std::string program_, word_;
  const system::SharedMemory memory_;
  const system::Descriptor
      device_;         // a guard that comes later gets this arm, too, and never what has its number by then
  system::Pipe life_;  // nobody writes to it: it ends when the program does
  GuardLine* line_ = nullptr;
  int failure_ = 0;
  system::Process process_;  // the first to go
};

}  // namespace underact::servo
