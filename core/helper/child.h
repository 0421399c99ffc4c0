#pragma once
#include <cstddef>
#include <cstdint>
#include <string>
#include <utility>

#include "core/base/sentence.h"

namespace underact::helper {

// Files of strangers are read in a process of its own that is shut off from all else (app/seal): whatever a file does
// to its reader, it ends there. These are the starting program's side of it.

/// What a helper ends with that could not shut itself off: it has not looked at the file then.
inline constexpr int kNotSealed = 77;

/// Of a file, a pipe or a socket, in one go: kernels that do not preempt themselves let nobody run on that processor
/// before a read is done, not even the servo. Of 38 MB at once that was 6 ms.
inline constexpr std::size_t kBlock = std::size_t{1} << 18;

/// What a process is started with; it inherits nothing else. The descriptors stay the caller's; below 0: none.
struct Start {
  std::string program, argument;
  int input_fd = -1;   // becomes its standard input
  int output_fd = -1;  // and its standard output
  int file_fd = -1;    // and descriptor kFile
};
inline constexpr int kFile = 3;

/// TookTooLong: it computed on and on. Waited: no answer came, and it computed little of that time.
enum class Ending : std::uint8_t {
  Exited,
  Crashed,
  TookTooLong,
  Waited,
  WroteTooMuch,
  Cancelled,
  NotStarted,
  NotSealed
};

/// A process that does not outlive its object. Where there are no processes of POSIX, none can be started.
class Child {
 public:
  Child() = default;
  explicit Child(const Start& start);
  Child(Child&& other) noexcept
      : pid_(std::exchange(other.pid_, -1)), error_(other.error_), code_(other.code_), cpu_s_(other.cpu_s_) {}
  Child& operator=(Child&& other) noexcept {
    std::swap(pid_, other.pid_);
    std::swap(error_, other.error_);
    std::swap(code_, other.code_);
    std::swap(cpu_s_, other.cpu_s_);
    return *this;
  }
  ~Child() { end(Ending::Cancelled); }

  bool runs() const { return pid_ > 0; }
  int error() const { return error_; }  // errno, where it could not be started
  /// That it has computed so far.
  double cpuSoFar_s() const;
  /// Waits for its end; unless it is Exited, it is killed first. Exited becomes Crashed or NotSealed where it was so.
  Ending end(Ending ending);
  // After end().
  int code() const { return code_; }  // exit status, or the signal that ended it
  double cpu_s() const { return cpu_s_; }

 private:
  int pid_ = -1, error_ = 0, code_ = 0;
  double cpu_s_ = 0.0;
};

/// "2.5 s": of a time in a sentence.
std::string secondsText(double s);

/// The sentence for Ending::Waited. most_time_s: that it was waited for.
Sentence whyWaited(double most_time_s);

/// The sentence for an ending that no file is to blame for; empty: there is none. program: its name; error: errno.
Sentence whyNoHelper(Ending ending, const std::string& program, int error);

}  // namespace underact::helper
