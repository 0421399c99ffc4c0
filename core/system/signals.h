#pragma once
#include <cstdint>
#include <utility>
#include <vector>

namespace underact::system {

/// What happens when nobody reads the results any more (a pipe into head, a terminal that is gone). Needed: the program
/// ends there and then. MayGo: it goes on, for it holds an arm, and what it says is lost.
enum class Reader : std::uint8_t { Needed, MayGo };

/// While one lives, what asks the program to end (Ctrl+C, Ctrl+\, SIGTERM, a terminal that is closed) sets a flag
/// instead, so that forces are let go and results still printed. One at a time.
class Interrupt {
 public:
  /// reader: what happens on SIGPIPE.
  explicit Interrupt(Reader reader = Reader::Needed);
  ~Interrupt();  // as it was
  Interrupt(const Interrupt&) = delete;
  Interrupt& operator=(const Interrupt&) = delete;
  /// Whether such a signal came since this was made.
  bool came() const;

 private:
  std::vector<std::pair<int, void (*)(int)>> before_;
};

/// What asks a program to end is not heard from here on: it ends when its starter does.
void outliveStarter();

/// A file that may not grow is told of as a disk that is full.
void tellOfFullFiles();

}  // namespace underact::system
