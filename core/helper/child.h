#pragma once
#include <cstdint>
#include <string>

#include "core/base/sentence.h"
#include "core/system/process.h"

namespace underact::helper {

// Files from elsewhere are read in a separate process that is sealed off from everything else (core/system/sandbox.h),
// so that whatever a file does to its reader stays in there. This is the side of the program that starts it.

/// The exit status of a helper that could not seal itself off; it has not looked at the file then.
inline constexpr int kNotSealed = 77;

/// How a helper is started; it inherits nothing else. The descriptors stay the caller's; below 0: none.
struct Start {
  std::string program, argument;
  int input_fd = -1;   // becomes its standard input
  int output_fd = -1;  // and its standard output
  int file_fd = -1;    // and descriptor kFile
};
inline constexpr int kFile = 3;

/// How a helper ended. TookTooLong: it computed for too long. Waited: no answer came although it hardly computed.
enum class Ending : std::uint8_t {
  Exited,
  Crashed,
  TookTooLong,
  Waited,
  WroteTooMuch,
  Cancelled,
  NotStarted,
  NotSandboxed
};

/// A process that does not outlive its object.
class Child {
 public:
  Child() = default;
  /// Starts it. Does not wait; where it could not be started, runs() is false and error() says why.
  explicit Child(const Start& start);

  bool runs() const { return process_.runs(); }
  int error() const { return process_.error(); }  // errno, where it could not be started
  /// The processor time that it has used so far, s.
  double cpuSoFar_s() const { return process_.cpuSoFar_s(); }
  /// Waits for its end; for any ending other than Exited, it is killed first. Exited becomes Crashed or NotSandboxed
  /// where that was so.
  Ending end(Ending ending);
  // After end().
  int code() const { return process_.end().code; }  // exit status, or the signal that ended it
  double cpu_s() const { return process_.end().cpu_s; }

 private:
  system::Process process_;
};

/// "2.5 s": a duration for a sentence.
std::string secondsText(double s);

/// The sentence for Ending::Waited. max_time_s: the time limit.
Sentence timeoutText(double max_time_s);

/// The sentence for an ending that is not the fault of the file; empty: it is. program: its name; error: errno.
Sentence helperFailureText(Ending ending, const std::string& program, int error);

}  // namespace underact::helper
