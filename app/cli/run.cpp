#include <algorithm>
#include <cmath>
#include <filesystem>
#include <memory>
#include <optional>
#include <ostream>
#include <utility>
#include <vector>

#include "app/cli/arm_choice.h"
#include "app/cli/command.h"
#include "app/cli/hands.h"
#include "app/cli/recording.h"
#include "app/cli/run_in_progress.h"
#include "app/cli/scene_file.h"
#include "app/cli/setting_overrides.h"
#include "app/options/scheduling_options.h"
#include "app/stream/live_stream.h"
#include "core/arm/preset.h"
#include "core/record/provenance.h"
#include "core/scene/compile.h"
#include "core/scene/mirror.h"
#include "core/scene/scene_arm.h"
#include "core/servo/host.h"
#include "core/sim/arm_model.h"
#include "core/sim/arm_model_file.h"
#include "core/sim/hand_script.h"
#include "core/system/signals.h"
#include "device/catalogue.h"
#include "device/simulated_run.h"

namespace underact::cli {
namespace {

constexpr double kLongestRun_s = 1e6;
constexpr const char* kSimulated = "simulated";

struct RunOptions {
  std::string scene;
  std::string hand;
  std::optional<double> mass_kg, damping_N_s_per_m, stiffness_N_per_m;  // of the hand; none: its own
  double seconds = 0.0;
  int rate_hz = 1000;
  int max_late = 20;
  bool fast = false;
  std::uint64_t seed = 1;
  std::string record;
  bool overwrite = false;
  record::SessionMetadata words;  // of the recording
  double block_s = record::kBlock_s;
  bool details = false;
  std::string stream;  // empty: none
  std::string fault_file;
  std::string space;  // empty: the scene's
  bool left_handed = false;
  std::vector<std::string> overrides;  // of the scene's settings, PATH=VALUE
  std::string arm_model{sim::kDefaultArmModel};
  std::string device{kSimulated};
  system::SchedulingRequest scheduling;
  bool isSimulated() const { return device == kSimulated; }
  system::Existing existing() const { return overwrite ? system::Existing::Replace : system::Existing::Refuse; }
};

/// "name: sentence" per line, for --help.
template <class Named, class Words>
std::string namedList(const char* title, std::span<const Named> named, Words Named::*what) {
  std::string list = title;
  for (const Named& one : named) list += std::string("\n  ") + one.name + ": " + one.*what;
  return list;
}

struct Prepared {
  LoadedScene scene;
  device::SimulatedRun run;  // of the simulated arm
};

/// Empty: the options are compatible.
std::string wrongIn(const RunOptions& options) {
  if (options.isSimulated())
    return options.hand.empty() ? "--hand: somebody has to hold the simulated arm. Give a built-in hand, or a file."
                                : "";
  if (!options.hand.empty())
    return "--hand: only the simulated arm has a scripted hand; you hold this arm yourself. Omit --hand.";
  return options.fast ? "--fast: only the simulated arm can run faster than real time. Omit --fast." : "";
}

/// The scene with the given settings, with every control in that space (empty: as it is), and in the mirror where it is
/// for the left hand.
Result<LoadedScene> asAsked(LoadedScene loaded, const RunOptions& options) {
  if (options.space.empty() && !options.left_handed && options.overrides.empty()) return loaded;
  Result<scene::Description> changed = withOverrides(std::move(loaded.description), options.overrides);
  if (!changed) return changed.problems();
  loaded.description = std::move(changed).value();
  if (options.left_handed) loaded.description = scene::mirrored(std::move(loaded.description));
  if (!options.space.empty()) {
    const tick::Space wanted = options.space == "joint" ? tick::Space::Joint : tick::Space::Cartesian;
    loaded.description.control.space = wanted;
    for (scene::Constraint& constraint : loaded.description.constraints) {
      if (constraint.control) constraint.control->space = wanted;
    }
  }
  Result<tick::TickProgram> program = scene::compile(loaded.description);
  if (!program) return program.problems();
  loaded.program = std::move(program).value();
  return loaded;
}

std::int64_t ticksOf(const RunOptions& options) {
  return std::max<std::int64_t>(1, std::llround(options.seconds * options.rate_hz));
}

/// No folders of a person are in a session.
std::string fileName(const std::string& path) {
  return std::filesystem::path(path).filename().string();
}

/// The hand with the options' mass, damping and stiffness in place of its own.
sim::HandScript asHeld(sim::HandScript script, const RunOptions& options) {
  sim::HandModel& hand = script.hand;
  hand.mass_kg = options.mass_kg.value_or(hand.mass_kg);
  hand.damping_N_s_per_m = options.damping_N_s_per_m.value_or(hand.damping_N_s_per_m);
  hand.stiffness_N_per_m = options.stiffness_N_per_m.value_or(hand.stiffness_N_per_m);
  return script;
}

/// Empty: something was wrong; it has been printed, and exit is its status.
std::optional<Prepared> prepare(const RunOptions& options, const Streams& streams, Exit& exit) {
  Result<LoadedScene> scene = loadScene(options.scene, streams);
  if (!scene) {
    exit = fail(scene.problems(), streams);
    return {};
  }
  printNotes(scene.value(), streams.err);
  Result<LoadedScene> asked = asAsked(std::move(scene).value(), options);
  if (!asked) {
    exit = fail(asked.problems(), Exit::BadInput, streams);
    return {};
  }
  if (!options.isSimulated()) return Prepared{std::move(asked).value(), {}};
  Result<sim::HandScript> hand = findHand(options.hand, options.seed);
  if (!hand) {
    exit = fail(hand.problems(), exitOfHand(options.hand, hand.problems()), streams);
    return {};
  }
  Result<sim::ArmModel> model = sim::chooseArmModel(options.arm_model);
  if (!model) {
    exit = fail(model.problems(), streams);
    return {};
  }
  Prepared prepared{std::move(asked).value(), {}};
  prepared.run = {fileName(options.hand),
                  contentOfHand(options.hand),
                  asHeld(std::move(hand).value(), options),
                  sim::modelFor(scene::armOf(prepared.scene.description), std::move(model).value()),
                  ticksOf(options),
                  options.fast,
                  options.seed};
  return prepared;
}

Result<std::unique_ptr<servo::DevicePort>> makeArm(const RunOptions& options, const Prepared& prepared) {
  if (!options.isSimulated()) {
    const arm::Preset& preset = scene::armOf(prepared.scene.description);
    return device::openDevice(options.device, {preset, {}, options.rate_hz, {}});
  }
  const scene::Description& scene = prepared.scene.description;
  return std::unique_ptr<servo::DevicePort>(
      device::makeSimulatedArm(prepared.run, scene::armOf(scene), scene, options.rate_hz));
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
                                                 {.most_ticks = ticksOf(options),
                                                  .block_s = options.block_s,
                                                  .existing = options.existing(),
                                                  .run = runOf(options, prepared),
                                                  .details = options.details,
                                                  .session_id = session_id});
    if (!started) return fail(started.problems(), Exit::File, streams);
    recording = std::move(started).value();
  }
  return Exit::Well;
}

Exit runScene(const RunOptions& options, const Streams& streams) {
  if (const std::string wrong = wrongIn(options); !wrong.empty()) {
    streams.err << wrong << '\n';
    return Exit::Usage;
  }
  if (const Problems problems = Recording::check(options.record, options.existing()); !problems.empty())
    return fail(problems, Exit::File, streams);
  Exit exit = Exit::Well;
  std::optional<Prepared> prepared = prepare(options, streams, exit);
  if (!prepared) return exit;
  const system::Interrupt interrupt(system::Reader::MayGo);
  Result<std::unique_ptr<servo::DevicePort>> arm = makeArm(options, *prepared);
  if (!arm) return fail(arm.problems(), Exit::Fault, streams);
  servo::Host host(std::move(arm).value(), {.rate_hz = options.rate_hz,
                                            .clock = options.fast ? servo::Clock::Manual : servo::Clock::Thread,
                                            .scheduling = options.scheduling,
                                            .max_late = options.max_late});
  const Problems problems = host.load(prepared->scene.description);
  if (!problems.empty()) return fail(problems, Exit::BadInput, streams);
  host.start();
  std::optional<Recording> recording;
  std::optional<stream::LiveStream> live;
  exit = startListeners(options, *prepared, host, recording, live, streams);
  if (exit != Exit::Well) return exit;
  host.begin();
  if (recording) recording->noteServo();
  Run run(ticksOf(options), std::move(recording), std::move(live), streams);
  options.fast ? runFast(host, run, interrupt) : runInRealTime(host, run, interrupt, streams);
  if (const std::int64_t dropped = host.snapshot().dropped; dropped > 0) {
    streams.err << dropped << " ticks were not received, because the machine was too busy.\n";
  }
  const Problems unkept = reportFaults(host, run, options.fault_file, streams);
  const std::string scheduling = options.fast ? "as fast as possible" : host.scheduling().name;
  JsonObject summary = run.summary().json({options.rate_hz, options.seed, options.fast, scheduling, host.guarding()});
  run.addStream(summary);
  streams.out << summary.text() << '\n';
  Problems unwritten = run.closeRecording();
  unwritten.insert(unwritten.end(), unkept.begin(), unkept.end());
  print(unwritten, streams.err);
  if (run.summary().faulted()) return Exit::Fault;
  return unwritten.empty() ? Exit::Well : Exit::File;
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
  const Option hand =
      command.option("--hand", options->hand, "The hand that holds the simulated arm: a built-in hand, or a hand file");
  command.option("--mass_kg", options->mass_kg, "Mass of the hand, kg, instead of its own")
      .range(1e-3, 1e3)
      .needs(hand);
  command.option("--damping_N_s_per_m", options->damping_N_s_per_m, "Damping of the hand, N s/m, instead of its own")
      .range(0.0, 1e6)
      .needs(hand);
  command.option("--stiffness_N_per_m", options->stiffness_N_per_m, "Stiffness of the hand, N/m, instead of its own")
      .range(0.0, 1e9)
      .needs(hand);
  command.option("--seconds", options->seconds, "Duration by the arm's clock, s").required().check(checkSeconds);
  command
      .option("--max-late", options->max_late,
              "Permitted number of consecutive ticks that are a whole period late; more are a fault")
      .showUsual()
      .range(1, 1'000'000);
  command.option("--rate", options->rate_hz, "Ticks per second").showUsual().range(100, 10000);
  command.flag("--fast", options->fast, "Run as fast as the machine allows, with the same numbers as in real time");
  command.option("--seed", options->seed, "Seed of everything that is random").showUsual().nonNegative();
  const Option recording =
      command.option("--record", options->record,
                     "Write every tick to this new file: as CSV if its name ends in .csv, else as a session");
  command.flag("--overwrite", options->overwrite, "Replace the file of --record if it exists").needs(recording);
  command.option("--record-block_s", options->block_s, "Interval at which a session is written, s")
      .showUsual()
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
      .usual(std::to_string(stream::kPort));
  command.option("--fault-file", options->fault_file,
                 "If a fault stops the servo, write it to this file, with the last second of ticks");
  command.option("--space", options->space, "Space of the control, instead of the scene's")
      .oneOf({"cartesian", "joint"});
  addSet(command, options->overrides, "Another value of a setting of the scene, as in --set kp_N_per_mm=0.02");
  command.flag("--left-handed", options->left_handed, "Mirror the scene, for the stylus in the left hand");
  command
      .option("--device", options->device,
              "The arm, KIND or KIND:ADDRESS, as underact-cli devices lists it; it exerts force at once")
      .showUsual();
  addArmModelOption(command, options->arm_model);
  options::addSchedulingOptions(command, options->scheduling);
  command.footer(namedList("Hands:", sim::builtInHands(), &sim::BuiltInHand::what) + "\n" +
                 namedList("Arm models:", sim::armModels(), &sim::ArmModel::title));
  command.whenChosen([options, &streams, &exit] { exit = runScene(*options, streams); });
}

}  // namespace underact::cli
