#pragma once
#include <chrono>
#include <cstddef>
#include <functional>

#include "core/base/result.h"
#include "core/sweep/journal.h"
#include "core/sweep/sweep.h"
#include "core/sweep/team.h"

namespace underact::sweep {

inline constexpr std::chrono::microseconds kLookAtLetters{1000};  // how often, leader and others

/// Callbacks for the starter of the sweep, in its thread; about every 0.2 s, and with each cell.
struct Watcher {
  std::function<bool()> interrupted = [] { return false; };  // true: no further cell is begun
  /// Told how many cells are done.
  std::function<void(std::size_t done)> progress = [](std::size_t) {};
};

/// How a sweep ended.
struct Outcome {
  Problems problems;  // why it ended early; cells that were done are in the journal
  bool interrupted = false;
};

/// Runs the cells that are not in the journal, on `threads` threads here and on the other ranks of the team (null:
/// none), and writes each into the journal when it is done. Which rank or thread runs a cell is not determined; no row
/// depends on it. Returns when no cell runs any more and the other ranks have said goodbye.
Outcome lead(const Sweep& sweep, Journal& journal, Team* team, int threads, const Watcher& watcher);

/// Tells the other ranks to end, where there is no sweep to lead.
void dismiss(Team& team);

/// Runs the cells that the leader hands out, until it says stop. sweep: this rank's own; or the problems that prevented
/// it, which are reported to the leader. interrupted: see Watcher.
void follow(const Result<Sweep>& sweep, Team& team, int threads, const std::function<bool()>& interrupted);

}  // namespace underact::sweep
