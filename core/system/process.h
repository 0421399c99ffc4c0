#pragma once
#include <cstdint>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "core/system/descriptor.h"

namespace underact::system {

/// How a process is started. It inherits no other open descriptors; those of standard input and output that are not
/// given are connected to nothing. No signal is blocked or ignored in it.
struct Launch {
  std::string program;                      // its path
  std::vector<std::string> arguments = {};  // behind its name
  /// Descriptors for the process, numbered there from 0 on; ours stay open. Below 0: connected to nothing.
  std::vector<int> given = {};
  /// In a session of its own, so that Ctrl+C and Ctrl+Z for the program do not affect it; and never with real-time
  /// scheduling, whichever thread starts it.
  bool is_apart = false;
};

/// How a process ended.
struct End {
  bool by_signal = false;
  int code = 0;  // exit status, or the signal
  double cpu_s = 0.0;
};

/// A process that does not outlive its object. One thread at a time.
class Process {
 public:
  Process() = default;  // none
  /// Starts it. Where it could not be started, runs() is false and error() says why.
  explicit Process(const Launch& launch);
  Process(Process&& other) noexcept { *this = std::move(other); }
  /// Takes it over; the process that this one had ends with the other.
  Process& operator=(Process&& other) noexcept {
    std::swap(id_, other.id_);
    std::swap(error_, other.error_);
    std::swap(ending_, other.ending_);
    std::swap(end_, other.end_);
    return *this;
  }
  ~Process();

  /// Whether it was started, and hasEnded() has not yet said that it ended.
  bool runs() const { return id_ > 0; }
  int error() const { return error_; }  // why it could not be started
  /// Readable once it has ended; below 0: the system has no such descriptor.
  int endDescriptor() const { return ending_.number(); }
  /// Whether it has ended; true where there was none.
  bool hasEnded();
  /// Waits for its end. false: it did not end in time_ms; below 0: as long as it takes.
  bool waitForEnd(int time_ms);
  /// Ends it at once, whatever it does.
  void kill() const;
  /// The processor time that it has used so far, s.
  double cpuSoFar_s() const;
  /// How it ended; to be called after that.
  const End& end() const { return end_; }

 private:
  int id_ = -1, error_ = 0;
  Descriptor ending_;
  End end_;
};

/// Runs a program of PATH to its end, with everything inherited except one variable of the environment. words: its name
/// and arguments. None: it could not be started, and errno says why.
std::optional<End> runHere(std::vector<std::string> words, const char* variable);

/// Makes a process that is just starting the leader of a group of its own, with lower priority (see lowerPriority()).
void leadGroup(int more);
/// Ends all processes of the group that `process` leads.
void killGroup(std::int64_t process);

}  // namespace underact::system
