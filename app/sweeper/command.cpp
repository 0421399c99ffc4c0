#include "app/sweeper/command.h"

#include <underact/version.h>

#include <memory>
#include <ostream>
#include <utility>

#include "app/cli/json_object.h"
#include "app/cli/printed_stream.h"
#include "app/sweeper/catalogue.h"
#include "app/sweeper/mpi_team.h"
#include "app/sweeper/request.h"

namespace underact::sweep {
namespace {

using cli::Exit;

struct Setting {
  const cli::Streams& streams;
  Team* team;
  Exit& exit;
};

void addCommon(options::Command command, Request& request) {
  const options::Option out = command.option("--out", request.out, "File of the result (CSV)");
  const options::Option dry =
      command.flag("--dry-run", request.dry_run, "Report the number of cells and how long they take");
  out.excludes(dry);
  const options::Option print =
      command.flag("--print", request.print, "Print the command of each cell, which makes its row again, and run none");
  print.excludes(out).excludes(dry);
  command.option("--cell", request.cell, "With --print: only the cell of this number").range(0, 9'999'999).needs(print);
  command.option("--threads", request.threads, "Cells at a time; by default one per core, under mpirun one per rank")
      .range(1, 4096);
  command.flag("--quiet", request.quiet, "Report errors only");
}

/// Runs the request, if the result has a file.
void run(const Request& request, const Setting& setting) {
  if (request.out.empty() && !request.dry_run && !request.print) {
    setting.streams.err
        << "Name the file of the result: --out FILE. (--dry-run only measures, --print only prints commands.)\n";
    setting.exit = Exit::Usage;
    return;
  }
  setting.exit = runSweep(request, setting.streams, setting.team);
}

std::string defaultOf(const Option& option) {
  std::string text;
  for (const std::string& value : option.default_value) text += (text.empty() ? " [" : " ") + value;
  return text.empty() ? " (required)" : text + "]";
}

void addKind(options::Command program, const SweepKind& kind, const Setting& setting) {
  const auto request = std::make_shared<Request>();
  request->kind = &kind;
  const options::Command command = program.add(kind.key, kind.question);
  for (const Option& option : kind.options) {
    // The parser leaves the given values in a list; without them, the default applies.
    command
        .option(
            "--" + option.name,
            [request, name = option.name](const std::vector<std::string>& given) { request->values[name] = given; },
            option.what + defaultOf(option))
        .expected(1, option.many ? -1 : 1);
  }
  command.option("--seed", request->seed, "Seed of everything that is random").showDefault().nonNegative();
  addCommon(command, *request);
  command.whenChosen([request, setting] { run(*request, setting); });
}

void addFrom(options::Command program, const Setting& setting) {
  const auto request = std::make_shared<Request>();
  const auto file = std::make_shared<std::string>();
  const options::Command command = program.add("from", "Run a sweep whose kind, seed and options are in a file");
  command.option("FILE", *file, "The sweep (JSON)").required();
  addCommon(command, *request);
  command.whenChosen([request, file, setting] {
    readRequest(*file, *request);
    run(*request, setting);
  });
}

void addList(options::Command program, const Setting& setting) {
  const options::Command command = program.add("list", "List the kinds of sweeps");
  const auto json = std::make_shared<bool>(false);
  command.flag("--json", *json, "One JSON object per kind");
  command.whenChosen([json, setting] {
    for (const SweepKind& kind : kinds()) {
      cli::JsonObject object;
      object.addText("kind", kind.key);
      object.addText("question", kind.question);
      setting.streams.out << (*json ? object.text() : kind.key + ": " + kind.question) << '\n';
    }
  });
}

}  // namespace

options::Program makeGrammar(const cli::Streams& streams, Team* team, Exit& exit) {
  options::Program program(
      "underact-sweep",
      "Sweeps: many independent runs, on all cores of this machine, or of many machines with mpirun.");
  program.version(std::string("underact-sweep ") + kVersion + " (MPI: " + mpiVersion() + ")");
  program.mustChoose();
  const Setting setting{streams, team, exit};
  for (const SweepKind& kind : kinds()) addKind(program, kind, setting);
  addFrom(program, setting);
  addList(program, setting);
  return program;
}

Exit execute(std::vector<std::string> arguments, const cli::Streams& streams, Team* team) {
  Exit exit = Exit::Success;
  cli::PrintedStream out(streams.out), err(streams.err);
  const cli::Streams clean{streams.in, out, err, streams.progress};
  return cli::perform(makeGrammar(clean, team, exit), std::move(arguments), clean, exit);
}

}  // namespace underact::sweep
