#include <underact/version.h>

#include <array>
#include <ostream>
#include <utility>

#include "app/cli/command.h"
#include "app/cli/printed_stream.h"

namespace underact::cli {

std::span<const AddCommand> commands() {
  static constexpr std::array kCommands{addForward,   addInverse,  addJacobian, addStatics, addArm,      addTarget,
                                        addRun,       addServe,    addLog,      addReplay,  addRerun,    addFigures,
                                        addCalibrate, addIdentify, addRegister, addDevices, addShareArm, addServoCheck,
                                        addLab,       addMesh,     addScene,    addLesson};
  return kCommands;
}

Exit perform(const options::Program& program, std::vector<std::string> arguments, const Streams& streams, Exit& exit) {
  const options::Parsed parsed = program.parse(std::move(arguments), streams.out, streams.err);
  if (parsed != options::Parsed::Done) exit = parsed == options::Parsed::Told ? Exit::Success : Exit::Usage;
  streams.out.flush();
  if (streams.out) return exit;
  streams.err << program.name() << ": the results could not be written.\n";
  return Exit::File;
}

options::Program makeGrammar(const Streams& streams, Exit& exit) {
  options::Program program("underact-cli", "Underact without a window, for scripts, servers and other programs.");
  program.version(std::string("underact-cli ") + kVersion);
  program.mustChoose();
  for (const AddCommand add : commands()) add(program, streams, exit);
  return program;
}

Exit execute(std::vector<std::string> arguments, const Streams& streams) {
  Exit exit = Exit::Success;
  PrintedStream out(streams.out), err(streams.err);
  const Streams clean{streams.in, out, err, streams.progress, streams.out_fd};
  return perform(makeGrammar(clean, exit), std::move(arguments), clean, exit);
}

}  // namespace underact::cli
