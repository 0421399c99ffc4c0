#include <memory>
#include <ostream>

#include "app/cli/command.h"
#include "app/cli/json_object.h"
#include "app/cli/progress.h"
#include "app/cli/recording.h"
#include "app/cli/run_summary.h"
#include "app/cli/scene_file.h"
#include "app/cli/verified_answer.h"
#include "core/system/signals.h"
#include "device/rerun_session.h"

namespace underact::cli {
namespace {

struct RerunChoice {
  std::string file, out;
  std::vector<std::string> files_in;
  bool overwrite = false;
  system::Existing existing() const { return overwrite ? system::Existing::Replace : system::Existing::Refuse; }
};

Exit printRerun(const record::SessionInfo& info, const device::RerunResult& result, const RunSummary& summary,
                const Streams& streams) {
  JsonObject object;
  object.addInteger("ticks", info.ticks);
  object.addInteger("identical_ticks", result.verified.ticks);
  object.addBool("identical", !result.verified.differs && result.verified.unknown.empty());
  object.addText("made_from", result.is_from_hand ? "hand" : "recorded input");
  const bool is_same = addDifference(object, result.verified, streams);
  if (result.verified.differs && result.verified.mended.empty())
    streams.err << "What was run differs from the recording; \"log info --diff\" names what does.\n";
  object.addObject("run",
                   summary.json({static_cast<int>(info.header.rate_hz), result.seed, true, "as fast as possible", ""}));
  streams.out << object.text() << '\n';
  return is_same ? Exit::Success : Exit::BadInput;
}

Exit rerun(const RerunChoice& choice, const Streams& streams) {
  if (const Problems problems = Recording::check(choice.out, choice.existing()); !problems.empty())
    return fail(problems, Exit::File, streams);
  Result<record::Session> session = record::Session::open(choice.file);
  if (!session) return fail(session.problems(), streams);
  if (session.value().info().ticks == 0) {
    streams.err << "This session contains no ticks.\n";
    return Exit::BadInput;
  }
  const system::Interrupt interrupt;
  Progress progress(streams);
  RunSummary summary;
  device::RerunOptions options;
  options.out = {choice.out, choice.existing()};
  options.files_in = recordedFilesFolders(choice.files_in);
  options.tick = [&summary](const servo::TickRecord& record) { summary.add(record); };
  options.progress = [&](double share) {
    progress.show(share);
    return !interrupt.came();
  };
  const Result<device::RerunResult> result = device::rerun(session.value(), options);
  if (!result) return fail(result.problems(), streams);
  return printRerun(session.value().info(), result.value(), summary, streams);
}

}  // namespace

void addRerun(Command program, const Streams& streams, Exit& exit) {
  const Command command =
      program.add("rerun", "Make a recorded run again from its session alone, and compare every tick to the last bit");
  const auto choice = std::make_shared<RerunChoice>();
  command.option("file", choice->file, "Session file").required();
  const Option out = command.option("--out", choice->out, "Write the run to this new session");
  command.flag("--overwrite", choice->overwrite, "Replace the file of --out if it exists").needs(out);
  command
      .option("--files", choice->files_in,
              "Folders of the recorded scene's meshes and curves, if they are not beside the session")
      .expected(1, -1)
      .word("FOLDER");
  command.whenChosen([choice, &streams, &exit] { exit = rerun(*choice, streams); });
}

}  // namespace underact::cli
