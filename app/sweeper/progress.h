#pragma once
#include <chrono>
#include <cstddef>
#include <iosfwd>
#include <optional>
#include <string>

namespace underact::sweep {

/// "40 s", "3 min", "2 h 10 min".
std::string inWords(double seconds);

/// The progress of a sweep and its remaining time: in place, once a second, on a terminal; else a line every 10 s.
class Progress {
 public:
  /// done: cells that need not be run. quiet: prints nothing.
  Progress(std::ostream& err, bool in_place, bool quiet, std::size_t done, std::size_t all);
  /// May be called any number of times.
  void show(std::size_t done) { show(done, std::chrono::steady_clock::now()); }
  void show(std::size_t done, std::chrono::steady_clock::time_point now);
  /// Ends the line on a terminal.
  void end();

 private:
  std::ostream& err_;
  bool in_place_, quiet_;
  std::size_t before_, all_;
  std::chrono::steady_clock::time_point begin_, shown_;
  bool on_line_ = false;
};

}  // namespace underact::sweep
