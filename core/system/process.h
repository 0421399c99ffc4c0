#pragma once
#include <cstdint>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "core/system/descriptor.h"

namespace underact::system {

/// What a process is started with; it inherits nothing else that is open, and reads and writes nothing where it is
/// given nothing. No signal is blocked or ignored in it.
struct Launch {
  std::string program;                      // its path
  std::vector<std::string> arguments = {};  // behind its name
  /// A descriptor of ours, which stays so, and its number there; from 0 on, one after the other. Below 0: nothing.
  std::vector<int> given = {};
  /// Of its own session, so that a Ctrl+C or Ctrl+Z of the program is not its; and never real-time, whichever thread
  /// starts it.
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

  /// It was started, and hasEnded() has not yet said that it ended.
  bool runs() const { return id_ > 0; }
  int error() const { return error_; }  // why it could not be started
  /// Readable once it has ended; below 0: this system has no such descriptor.
  int endDescriptor() const { return ending_.number(); }
  /// Also where there was none.
  bool hasEnded();
  /// false: it did not end in time. Below 0: as long as it takes.
  bool waitForEnd(int time_ms);
  /// At once, wherever it hangs.
  void kill() const;
  /// That it has computed so far.
  double cpuSoFar_s() const;
  /// Once it has ended.
  const End& end() const { return end_; }

 private:
  int id_ = -1, error_ = 0;
  Descriptor ending_;
  End end_;
};

/// Runs a program of PATH to its end, with all that this one has but for one variable of the environment. words: its
/// name and arguments. None: it could not be started, and errno says why.
std::optional<End> runHere(std::vector<std::string> words, const char* variable);

/// Called in a process that is just starting: it leads a group of its own, and steps back (see stepBack()).
void leadGroup(int more);
/// All processes of the group that one leads.
void killGroup(std::int64_t process);

}  // namespace underact::system
