#include <underact/version.h>

#include <algorithm>
#include <array>
#include <ostream>
#include <utility>

#include "app/cli/command.h"

namespace underact::cli {

std::span<const AddCommand> commands() {
  static constexpr std::array kCommands{addForward,  addInverse,    addJacobian,  addTarget,   addRun,      addLog,
                                        addReplay,   addFigures,    addCalibrate, addIdentify, addRegister, addDevices,
                                        addShareArm, addServoCheck, addLab,       addMesh,     addScene,    addLesson};
  return kCommands;
}

Exit perform(CLI::App& program, std::vector<std::string> arguments, const Streams& streams, Exit& exit) {
  std::reverse(arguments.begin(), arguments.end());  // as CLI11 wants them
  try {
    program.parse(std::move(arguments));
  } catch (const CLI::ParseError& error) {
    // Help and version come this way, too, with 0.
    exit = program.exit(error, streams.out, streams.err) == 0 ? Exit::Well : Exit::Usage;
  }
  streams.out.flush();
  if (streams.out) return exit;
  streams.err << program.get_name() << ": the results could not be written.\n";
  return Exit::File;
}

std::unique_ptr<CLI::App> makeGrammar(const Streams& streams, Exit& exit) {
  auto program = std::make_unique<CLI::App>(
      "Underact without a window: kinematics of arms, and what a scene does to the stylus.", "underact-cli");
  program->set_version_flag("--version", std::string("underact-cli ") + kVersion, "Print the version and exit");
  program->require_subcommand(1);
  program->failure_message(CLI::FailureMessage::simple);
  for (const AddCommand add : commands()) add(*program, streams, exit);
  return program;
}

Exit execute(std::vector<std::string> arguments, const Streams& streams) {
  Exit exit = Exit::Well;
  return perform(*makeGrammar(streams, exit), std::move(arguments), streams, exit);
}

}  // namespace underact::cli
