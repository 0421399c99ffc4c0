#pragma once
#include <atomic>
#include <cstdint>
#include <utility>
#include <vector>

namespace underact::system {

/// What happens when the output is no longer read (a pipe into head, a closed terminal). Needed: the program ends.
/// MayGo: it continues, since it holds an arm, and its output is lost.
enum class Reader : std::uint8_t { Needed, MayGo };

/// While an object of this class exists, signals that ask the program to end (Ctrl+C, Ctrl+\, SIGTERM, a closed
/// terminal) set a flag instead, so that the force is released and results are still printed. One thread makes and
/// destroys them; one that is made within the life of another has its flag, too.
class Interrupt {
 public:
  /// reader: what happens on SIGPIPE. counter: outlives this; the signal's handler itself counts it up, whatever the
  /// program's threads are doing, as it ends the force with servo::Host::stops(). Null: none.
  explicit Interrupt(Reader reader = Reader::Needed, std::atomic<std::uint64_t>* counter = nullptr);
  ~Interrupt();  // restores the handlers
  Interrupt(const Interrupt&) = delete;
  Interrupt& operator=(const Interrupt&) = delete;
  /// Whether such a signal came since this was made.
  bool came() const;

 private:
  std::vector<std::pair<int, void (*)(int)>> before_;
  std::atomic<std::uint64_t>* counter_before_;
};

/// Ignores signals that ask the program to end: it ends when its starter does.
void endWithParentOnly();

/// Ignores the signal of a file-size limit, so that exceeding it is an error like a full disk.
void reportFullFiles();

}  // namespace underact::system
