#pragma once
#include <cstdint>
#include <string>

#include "core/servo/device_port.h"
#include "core/servo/guard_line.h"
#include "core/system/channel.h"
#include "core/system/process.h"
#include "core/system/shared_memory.h"

namespace underact::servo {

/// The current guard process, and what each of them is given. One thread at a time.
class GuardProcess {
 public:
  /// program: the path of underact-guard.
  GuardProcess(const ZeroForceMessage& word, std::int64_t limit_ns, std::string program);
  ~GuardProcess();  // an orderly end: the guard ends without sending anything; one that does not end is killed
  GuardProcess(const GuardProcess&) = delete;
  GuardProcess& operator=(const GuardProcess&) = delete;

  /// The shared memory, the same for all guards; null: it could not be made, and failure() says why.
  GuardLine* line() const { return line_; }
  /// Starts a guard, when the last one has ended. false: failure() says why.
  bool start();
  /// The error number of the system.
  int failure() const { return failure_; }
  /// Readable once it has ended; below 0: this system has no such descriptor, and hasEnded() is to be asked now and
  /// then.
  int endFd() const { return process_.endDescriptor(); }
  /// Whether it has ended, or there was none.
  bool hasEnded() { return process_.hasEnded(); }
  /// Ends it at once, whatever it does.
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
