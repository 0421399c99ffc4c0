#pragma once
#include <iosfwd>
#include <span>
#include <string>
#include <vector>

#include "app/options/command.h"

namespace underact::cli {

using options::Command;
using options::Option;

/// Exit status of underact-cli. Library: an export takes a library that is not installed.
enum class Exit : int { Success = 0, BadInput = 1, Usage = 2, Fault = 3, File = 4, Library = 5 };

/// Results go to out, messages and progress to err.
struct Streams {
  std::istream& in;
  std::ostream& out;
  std::ostream& err;
  bool progress = false;  // err is a terminal that a line of progress may move on
  int out_fd = -1;        // behind out, for those who must not wait for its reader; below 0: none
};

/// Adds a command to the grammar of the command line; when it is chosen, it does its work and leaves its exit status.
using AddCommand = void (*)(Command program, const Streams& streams, Exit& exit);

void addForward(Command program, const Streams& streams, Exit& exit);
void addInverse(Command program, const Streams& streams, Exit& exit);
void addJacobian(Command program, const Streams& streams, Exit& exit);
void addStatics(Command program, const Streams& streams, Exit& exit);
void addArm(Command program, const Streams& streams, Exit& exit);
void addTarget(Command program, const Streams& streams, Exit& exit);
void addRun(Command program, const Streams& streams, Exit& exit);
void addCalibrate(Command program, const Streams& streams, Exit& exit);
void addIdentify(Command program, const Streams& streams, Exit& exit);
void addShareArm(Command program, const Streams& streams, Exit& exit);
void addRegister(Command program, const Streams& streams, Exit& exit);
void addDevices(Command program, const Streams& streams, Exit& exit);
void addServoCheck(Command program, const Streams& streams, Exit& exit);
void addLog(Command program, const Streams& streams, Exit& exit);
void addServe(Command program, const Streams& streams, Exit& exit);
void addReplay(Command program, const Streams& streams, Exit& exit);
void addRerun(Command program, const Streams& streams, Exit& exit);
void addFigures(Command program, const Streams& streams, Exit& exit);
void addLab(Command program, const Streams& streams, Exit& exit);
void addMesh(Command program, const Streams& streams, Exit& exit);
void addScene(Command program, const Streams& streams, Exit& exit);
void addLesson(Command program, const Streams& streams, Exit& exit);

/// All commands, in the order of --help.
std::span<const AddCommand> commands();

/// The grammar of the whole program; help, man pages and completion are made from it. streams, exit: outlive it.
options::Program makeGrammar(const Streams& streams, Exit& exit);

/// Runs a grammar's commands: answers help, version and wrong usage, and flushes the results at the end or reports that
/// they could not be written. arguments: without the program's name; exit: where the commands leave their exit status.
Exit perform(const options::Program& program, std::vector<std::string> arguments, const Streams& streams, Exit& exit);

/// The whole program. arguments: without the program's name.
Exit execute(std::vector<std::string> arguments, const Streams& streams);

// The parts of `lab`: each adds its own subcommand. A new one is a line here and in lab.cpp.
void addLabStep(Command lab, const Streams& streams, Exit& exit);
void addLabSearch(Command lab, const Streams& streams, Exit& exit);
void addLabModel(Command lab, const Streams& streams, Exit& exit);
void addLabTrade(Command lab, const Streams& streams, Exit& exit);
void addLabStability(Command lab, const Streams& streams, Exit& exit);
void addLabExtremes(Command lab, const Streams& streams, Exit& exit);

}  // namespace underact::cli
