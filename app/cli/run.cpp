#include <algorithm>
#include <cmath>
#include <filesystem>
#include <memory>
#include <optional>
#include <ostream>
#include <utility>

#include "app/cli/command.h"
#include "app/cli/held_arm.h"
#include "app/cli/recording.h"
#include "app/cli/run_in_progress.h"
#include "app/stream/live_stream.h"
#include "core/record/provenance.h"
#include "core/scene/scene_arm.h"
#include "core/servo/host.h"
#include "core/system/signals.h"
#include "device/simulated_run.h"

namespace underact::cli {
namespace {

constexpr double kLongestRun_s = 1e6;

struct RunOptions : HeldArm {
  double seconds = 0.0;
  record::SessionMetadata words;  // of the recording
  double block_s = record::kBlock_s;
  bool details = false;
  std::string stream;  // empty: none
  std::string fault_file;
};

std::int64_t ticksOf(const RunOptions& options) {
  return std::max<std::int64_t>(1, std::llround(options.seconds * options.rate_hz));
}

/// The name of an unnamed session: what was run.
record::SessionMetadata wordsOf(const RunOptions& options) {
  record::SessionMetadata words = options.words;
  if (words.name.empty()) words.name = std::filesystem::path(options.scene).stem().string();
  if (words.notes.empty() && options.isSimulated()) {
    words.notes = "Hand " + fileName(options.hand) + ", seed " + std::to_string(options.seed) + ", arm model " +
                  fileName(options.arm_model) + ".";
  }
  return words;
}

/// What the servo does not know of the run.
JsonObject runOf(const RunOptions& options, const Prepared& prepared) {
  return options.isSimulated() ? device::provenanceOf(prepared.run) : device::provenanceOfPerson(nullptr);
}

/// Opens the requested destinations of the ticks besides the summary.
Exit startListeners(const RunOptions& options, const Prepared& prepared, servo::Host& host,
                    std::optional<Recording>& recording, std::optional<stream::LiveStream>& live,
                    const Streams& streams) {
  const std::string session_id = record::newSessionId();
  if (!options.stream.empty()) {
    const Result<stream::Address> address = stream::readAddress(options.stream);
    if (!address) return fail(address.problems(), Exit::Usage, streams);
    Result<stream::LiveStream> opened = stream::LiveStream::open(address.value(), options.rate_hz);
    if (!opened) return fail(opened.problems(), Exit::File, streams);
    live = std::move(opened).value();
    live->setSession(session_id);
    if (options.fast) live->pace();
  }
  if (!options.record.empty()) {
    Result<Recording> started = Recording::start(host, options.record, wordsOf(options),
                                                 {.max_ticks = ticksOf(options),
                                                  .block_s = options.block_s,
                                                  .existing = options.existing(),
                                                  .run = runOf(options, prepared),
                                                  .details = options.details,
                                                  .session_id = session_id});
    if (!started) return fail(started.problems(), Exit::File, streams);
    recording = std::move(started).value();
  }
  return Exit::Success;
}

Exit runScene(const RunOptions& options, const Streams& streams) {
  Exit exit = Exit::Success;
  std::optional<Prepared> prepared = prepare(options, ticksOf(options), streams, exit);
  if (!prepared) return exit;
  const system::Interrupt interrupt(system::Reader::MayGo);
  Result<std::unique_ptr<servo::DevicePort>> arm = openArm(options, *prepared);
  if (!arm) return fail(arm.problems(), Exit::Fault, streams);
  servo::Host host(std::move(arm).value(), {.rate_hz = options.rate_hz,
                                            .clock = options.fast ? servo::Clock::Manual : servo::Clock::Thread,
                                            .scheduling = options.scheduling,
                                            .max_late = options.max_late});
  const Problems problems = host.load(prepared->scene.description);
  if (!problems.empty()) return fail(problems, Exit::BadInput, streams);
  const system::Interrupt stopping(system::Reader::MayGo, &host.stops());
  host.start();
  std::optional<Recording> recording;
  std::optional<stream::LiveStream> live;
  exit = startListeners(options, *prepared, host, recording, live, streams);
  if (exit != Exit::Success) return exit;
  host.begin();
  if (recording) recording->noteServo();
  Run run(ticksOf(options), std::move(recording), std::move(live), streams);
  options.fast ? runFast(host, run, interrupt) : runInRealTime(host, run, interrupt, streams);
  host.stop();  // whoever reads the results may take their time
  const std::int64_t untaken = host.snapshot().dropped;
  if (untaken > 0) streams.err << untaken << " ticks were not received, because the machine was too busy.\n";
  Problems unwritten = reportFaults(host, run, options.fault_file, streams);
  const std::string scheduling = options.fast ? "as fast as possible" : host.scheduling().name;
  JsonObject summary = run.summary().json({options.rate_hz, options.seed, options.fast, scheduling, host.guarding(),
                                           scene::rendersMoment(prepared->scene.description)});
  run.addStream(summary);
  streams.out << summary.text() << '\n';
  const Problems unrecorded = run.closeRecording(untaken);
  unwritten.insert(unwritten.end(), unrecorded.begin(), unrecorded.end());
  print(unwritten, streams.err);
  if (run.summary().faulted()) return Exit::Fault;
  return unwritten.empty() ? Exit::Success : Exit::File;
}

std::string checkSeconds(const std::string& text) {
  const std::optional<double> seconds = options::numberOf(text);
  if (seconds && *seconds > 0.0 && *seconds <= kLongestRun_s) return {};
  return "must be a number of seconds above 0, at most 1e6";
}

}  // namespace

void addRun(Command program, const Streams& streams, Exit& exit) {
  const Command command =
      program.add("run", "Run a scene on the simulated arm, held by a scripted hand, or on another arm, held by you");
  const auto options = std::make_shared<RunOptions>();
  command.option("scene", options->scene, "Scene file").required();
  addHandOptions(command, *options);
  command.option("--seconds", options->seconds, "Duration by the arm's clock, s").required().check(checkSeconds);
  addRateOptions(command, *options);
  command.flag("--fast", options->fast, "Run as fast as the machine allows, with the same numbers as in real time");
  addSeedOption(command, *options);
  const Option recording =
      command.option("--record", options->record,
                     "Write every tick to this new file: as CSV if its name ends in .csv, else as a session");
  command.flag("--overwrite", options->overwrite, "Replace the file of --record if it exists").needs(recording);
  command.option("--record-block_s", options->block_s, "Interval at which a session is written, s")
      .showDefault()
      .range(record::kShortestBlock_s, record::kLongestBlock_s);
  command
      .flag("--record-details", options->details,
            "Record the simulated arm's true tip and the hand's force, and each constraint's target and force, too")
      .needs(recording);
  command.option("--name", options->words.name, "Name of the session; by default that of the scene file");
  command.option("--notes", options->words.notes, "Notes on the session");
  command.option("--tags", options->words.tags, "Tags of the session, separated by commas");
  command.option("--subject", options->words.subject, "Code for the person whose hand it is; nothing personal");
  command.option("--consent", options->words.consent,
                 "What that person agreed to, and how: the consent form's version and date");
  command
      .option("--stream", options->stream,
              "Send ticks as JSON over UDP (PlotJuggler) to PORT, HOST or HOST:PORT; by default to port 9870 of this "
              "machine; with --fast, at most some 10,000 a second, so that none is lost")
      .expected(0, 1)
      .defaultText(std::to_string(stream::kPort));
  command.option("--fault-file", options->fault_file,
                 "If a fault stops the servo, write it to this file, with the last second of ticks");
  addArmOptions(command, *options);
  command.whenChosen([options, &streams, &exit] { exit = runScene(*options, streams); });
}

}  // namespace underact::cli
