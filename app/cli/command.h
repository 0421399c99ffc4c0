#pragma once
#include <CLI/CLI.hpp>
#include <iosfwd>
#include <memory>
#include <span>
#include <string>
#include <vector>

namespace underact::cli {

/// Exit status of underact-cli.
enum class Exit : int { Well = 0, BadInput = 1, Usage = 2, Fault = 3, File = 4 };

/// Results go to out, messages and progress to err.
struct Streams {
  std::istream& in;
  std::ostream& out;
  std::ostream& err;
  bool progress = false;  // err is a terminal that a line of progress may move on
  int out_fd = -1;        // behind out, for those who must not wait for its reader; below 0: there is none
};

/// Adds a command to the grammar of the command line; when it is chosen, it does its work and leaves its exit status.
using AddCommand = void (*)(CLI::App& program, const Streams& streams, Exit& exit);

void addForward(CLI::App& program, const Streams& streams, Exit& exit);
void addInverse(CLI::App& program, const Streams& streams, Exit& exit);
void addJacobian(CLI::App& program, const Streams& streams, Exit& exit);
void addTarget(CLI::App& program, const Streams& streams, Exit& exit);
void addRun(CLI::App& program, const Streams& streams, Exit& exit);
void addCalibrate(CLI::App& program, const Streams& streams, Exit& exit);
void addIdentify(CLI::App& program, const Streams& streams, Exit& exit);
void addShareArm(CLI::App& program, const Streams& streams, Exit& exit);
void addRegister(CLI::App& program, const Streams& streams, Exit& exit);
void addDevices(CLI::App& program, const Streams& streams, Exit& exit);
void addServoCheck(CLI::App& program, const Streams& streams, Exit& exit);
void addLog(CLI::App& program, const Streams& streams, Exit& exit);
void addReplay(CLI::App& program, const Streams& streams, Exit& exit);
void addFigures(CLI::App& program, const Streams& streams, Exit& exit);
void addLab(CLI::App& program, const Streams& streams, Exit& exit);
void addMesh(CLI::App& program, const Streams& streams, Exit& exit);
void addScene(CLI::App& program, const Streams& streams, Exit& exit);
void addLesson(CLI::App& program, const Streams& streams, Exit& exit);

/// All commands, in the order of --help.
std::span<const AddCommand> commands();

/// The grammar of the whole program; help, man pages and completion are made from it. streams, exit: outlive it.
std::unique_ptr<CLI::App> makeGrammar(const Streams& streams, Exit& exit);

/// Runs a grammar's commands: help, version and wrong usage are answered, and the results are out at the end, or it is
/// said that they are not. arguments: without the program's name; exit: where the commands leave their exit status.
Exit perform(CLI::App& program, std::vector<std::string> arguments, const Streams& streams, Exit& exit);

/// The whole program. arguments: without the program's name.
Exit execute(std::vector<std::string> arguments, const Streams& streams);

}  // namespace underact::cli
