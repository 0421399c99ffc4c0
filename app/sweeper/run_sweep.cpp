#include <algorithm>
#include <array>
#include <charconv>
#include <chrono>
#include <filesystem>
#include <memory>
#include <optional>
#include <ostream>
#include <thread>

#include "app/cli/scene_file.h"
#include "app/sweeper/progress.h"
#include "app/sweeper/request.h"
#include "core/sweep/journal.h"
#include "core/sweep/lead.h"
#include "core/sweep/result_file.h"
#include "core/system/signals.h"

namespace underact::sweep {
namespace {

using cli::Exit;
using Clock = std::chrono::steady_clock;

int threadsOf(const Request& request, const Team* team) {
  if (request.threads > 0) return request.threads;
  if (team != nullptr) return 1;
  return static_cast<int>(std::max(1U, std::thread::hardware_concurrency()));
}

/// The exit status of a sweep that ended early: File if a file is the reason, else bad input.
Exit failWhileRunning(const Problems& problems, const cli::Streams& streams) {
  cli::print(problems, streams.err);
  return problems.front().place.file.empty() ? Exit::BadInput : Exit::File;
}

/// What is wrong before anything is run: an option, or a file that an option names.
Exit refuse(const Problems& problems, const cli::Streams& streams) {
  cli::print(problems, streams.err);
  const bool usage =
      std::all_of(problems.begin(), problems.end(), [](const Problem& one) { return one.place.file.empty(); });
  return usage ? Exit::Usage : cli::exitOf(problems);
}

/// After the first signal, the next one ends the program at once.
class Patience {
 public:
  bool cameOnce() {
    if (interrupt_ && interrupt_->came()) {
      came_ = true;
      interrupt_.reset();
    }
    return came_;
  }

 private:
  std::optional<system::Interrupt> interrupt_{std::in_place};
  bool came_ = false;
};

/// As many digits as a measurement has.
std::string twoDigits(double value) {
  std::array<char, 32> text{};
  const auto end = std::to_chars(text.data(), text.data() + text.size(), value, std::chars_format::general, 2);
  return {text.data(), end.ptr};
}

/// Runs a few cells, spread over all, one after the other, and predicts the time for all of them.
Exit printCost(const Sweep& sweep, int threads, const cli::Streams& streams) {
  constexpr std::size_t kMaxMeasured = 8;
  constexpr std::chrono::seconds kEnough{5};
  const std::size_t wanted = std::min(kMaxMeasured, sweep.cells.count);
  const Clock::time_point begin = Clock::now();
  Clock::time_point now = begin;
  std::size_t measured = 0;
  while (measured < wanted && now - begin < kEnough) {
    const Result<std::string> row = rowOf(sweep, measured * sweep.cells.count / wanted);
    if (!row) return failWhileRunning(row.problems(), streams);
    ++measured;
    now = Clock::now();
  }
  const double each_s = std::chrono::duration<double>(now - begin).count() / static_cast<double>(measured);
  const double all_s = each_s * static_cast<double>(sweep.cells.count) / threads;
  streams.out << sweep.cells.count << " cells. " << measured << " of them, measured one by one, took "
              << twoDigits(each_s) << " s each: on " << threads << (threads == 1 ? " thread" : " threads")
              << " all take about " << inWords(all_s) << ", if each thread has a core.\n";
  return Exit::Success;
}

/// Runs the missing cells, and shows the progress.
Outcome runCells(const Sweep& sweep, Journal& journal, const Request& request, const cli::Streams& streams,
                 Team* team) {
  Patience patience;
  Progress progress(streams.err, streams.progress, request.quiet, journal.rows().size(), sweep.cells.count);
  Watcher watcher;
  watcher.progress = [&progress](std::size_t done) { progress.show(done); };
  watcher.interrupted = [&] {
    if (!patience.cameOnce()) return false;
    progress.end();
    streams.err << "Ending after the running cells. A second signal ends at once.\n" << std::flush;
    return true;
  };
  Outcome outcome = lead(sweep, journal, team, threadsOf(request, team), watcher);
  progress.end();
  return outcome;
}

void printDone(const Sweep& sweep, std::size_t run_now, const Request& request, const cli::Streams& streams) {
  if (request.quiet) return;
  streams.err << request.out << ": " << sweep.cells.count << " cells, " << run_now << " of them run now.\n";
}

/// The sweep of the leader, from its journal to its result.
Exit leadToResult(const Sweep& sweep, const Request& request, const cli::Streams& streams, Team* team) {
  const Result<bool> is_there = isThere(sweep, request.out);
  Result<Journal> opened = is_there ? Journal::open(sweep, request.out) : is_there.problems();
  if (!opened || is_there.value()) {
    if (team != nullptr) dismiss(*team);
    if (!opened) return failWhileRunning(opened.problems(), streams);
    opened.value().remove();  // of a program that was killed when the result was written already
    printDone(sweep, 0, request, streams);
    return Exit::Success;
  }
  Journal& journal = opened.value();
  const std::size_t before = journal.rows().size();
  Outcome outcome = runCells(sweep, journal, request, streams, team);
  if (outcome.problems.empty() && !outcome.interrupted)
    outcome.problems = writeResult(sweep, journal.rows(), request.out);
  if (outcome.problems.empty() && !outcome.interrupted) {
    journal.remove();
    printDone(sweep, sweep.cells.count - before, request, streams);
    return Exit::Success;
  }
  const Exit exit = outcome.problems.empty() ? Exit::File : failWhileRunning(outcome.problems, streams);
  streams.err << journal.rows().size() << " of " << sweep.cells.count << " cells are done and saved in "
              << journal.path() << ". The same command continues from there.\n";
  return exit;
}

/// The command of each cell, or of the one that was asked for.
Exit printCommands(const Sweep& sweep, const std::optional<int>& only, const cli::Streams& streams) {
  if (!sweep.cells.command) {
    streams.err << "The cells of this kind have no command of their own.\n";
    return Exit::BadInput;
  }
  const std::size_t first = only ? static_cast<std::size_t>(*only) : 0;
  const std::size_t end = only ? first + 1 : sweep.cells.count;
  if (end > sweep.cells.count) {
    streams.err << "--cell: this sweep has " << sweep.cells.count << " cells; the last one is number "
                << sweep.cells.count - 1 << ".\n";
    return Exit::Usage;
  }
  for (std::size_t cell = first; cell < end; ++cell)
    streams.out << sweep.cells.command(cell, seedOf(sweep, cell)) << '\n';
  return Exit::Success;
}

}  // namespace

Exit runSweep(const Request& request, const cli::Streams& streams, Team* team) {
  const bool leads = team == nullptr || team->rank() == 0;
  const bool runs = !request.dry_run && !request.print;
  if (!runs && !leads) return Exit::Success;
  // A rank without a sweep tells the leader, so that it is not waited for.
  const Result<Sweep> sweep = request.problems.empty() ? makeSweep(*request.kind, request.values, request.seed)
                                                       : Result<Sweep>(request.problems);
  if (!leads) {
    Patience patience;
    follow(sweep, *team, threadsOf(request, team), [&patience] { return patience.cameOnce(); });
    return Exit::Success;
  }
  if (!sweep) {
    if (team != nullptr && runs) dismiss(*team);
    return refuse(sweep.problems(), streams);
  }
  if (request.print) return printCommands(sweep.value(), request.cell, streams);
  if (request.dry_run)
    return printCost(sweep.value(), threadsOf(request, team) * (team == nullptr ? 1 : team->size()), streams);
  return leadToResult(sweep.value(), request, streams, team);
}

}  // namespace underact::sweep
