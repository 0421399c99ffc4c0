#pragma once
#include <sys/types.h>

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "app/cli/command.h"
#include "tests/support/scratch_folder.h"

namespace underact::test {

/// What underact-sweep said, and how it ended.
struct Given {
  cli::Exit exit = cli::Exit::Success;
  std::string out, err;
};

/// The program in this process.
Given sweepHere(std::vector<std::string> arguments);

/// The path of underact-sweep, in quotes; and that of the same program with the kind of tests/gated_sweep alone.
std::string sweepProgram();
std::string gatedProgram();

/// A command of the shell that runs beside the test; what is left of it dies with the object.
class Process {
 public:
  /// Its messages go to the file `said`.
  Process(const std::string& command, const std::string& given);
  ~Process();
  Process(const Process&) = delete;
  Process& operator=(const Process&) = delete;
  pid_t pid() const { return pid_; }
  /// Waits for its end, a minute at most. Its exit status; of one that a signal ended, minus the signal.
  int wait();
  bool hasEnded();

 private:
  pid_t pid_ = -1;
  std::optional<int> status_;  // as waitpid() has it
};

/// A printed command as a shell splits it, without the program; words in quotes are not for it.
std::vector<std::string> argumentsOf(const std::string& command);

/// The lines of a text, without their ends.
std::vector<std::string> linesOf(const std::string& text);

/// The child of mpirun that is this rank; -1: there is none.
pid_t rankOf(pid_t mpirun, int rank);

/// Waits, a minute at most, until a process has ended, even where its parent has not asked how. False: it has not.
bool waitForEnd(pid_t pid);

/// Waits, a minute at most, until so many cells are in the journal of a result. False: they did not come.
bool waitForCells(const std::string& result, std::size_t cells);

/// Cells in the journal of a result; 0 where there is none.
std::size_t cellsIn(const std::string& result);

/// Whether nobody holds the journal of a result: a process that was killed may take a moment to end.
bool isFree(const std::string& result);

/// How many cells a program says it has run, in the file of its messages; -1: it does not say.
int runNow(const std::string& given);

/// What is in a file that must be there; and in one that need not.
std::string textOf(const std::string& path);
std::string contentOf(const std::string& path);
std::string scene(const std::string& name);

using Table = std::vector<std::vector<std::string>>;

/// The lines of a result below its header, each cut at its commas; the columns first.
Table table(const std::string& result);
/// The field of a row by the name of its column.
const std::string& field(const Table& table, std::size_t row, const std::string& column);

double number(const Table& table, std::size_t row, const std::string& column);

}  // namespace underact::test
