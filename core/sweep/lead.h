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

/// What whoever started the sweep is asked and told, by the thread that called; about every 0.2 s, and with each cell.
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
/// there are none), and writes each into the journal as it comes. Which rank or thread runs a cell is left to chance;
/// no row depends on it. Returns when no cell runs any more and the other ranks have said good-bye.
Outcome lead(const Sweep& sweep, Journal& journal, Team* team, int threads, const Watcher& watcher);

/// Sends the other ranks home, where there is no sweep to lead.
void dismiss(Team& team);

/// Runs the cells that the leader hands out, until it says stop. sweep: this rank's own; or the problems with which it
/// could not make one, of which it tells the leader. interrupted: see Watcher.
void follow(const Result<Sweep>& sweep, Team& team, int threads, const std::function<bool()>& interrupted);

}  // namespace underact::sweep
