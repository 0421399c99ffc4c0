#include <chrono>
#include <memory>
#include <ostream>
#include <thread>
#include <utility>

#include "app/cli/command.h"
#include "app/cli/held_arm.h"
#include "app/cli/json_object.h"
#include "app/cli/recording.h"
#include "app/cli/shipped.h"
#include "app/serve/haply.h"
#include "app/serve/host_alone.h"
#include "app/serve/server.h"
#include "app/serve/token.h"
#include "core/record/csv.h"
#include "core/servo/host.h"
#include "core/system/signals.h"
#include "device/simulated_run.h"

namespace underact::cli {
namespace {

struct ServeOptions : HeldArm {
  int port = serve::kDefaultPort;
  bool starts = false;
  std::string token_file;  // empty: a new one in the runtime folder
  std::vector<std::string> origins;
  bool anyone_steers = false;
  int haply_port = serve::kHaplyPort;
  bool haply = false;
  std::string sessions;  // empty: where the window keeps them
};

double nowSeconds() {
  return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

/// Takes the last ticks, with the force ramping to zero; an arm that hangs is not waited for any longer.
void letGo(serve::Service& service) {
  service.letGo();
  const double end_s = nowSeconds() + 0.3;
  do {
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
    service.poll(nowSeconds());
  } while (service.pushes() && nowSeconds() < end_s);
}

Exit runService(ServeOptions options, const Streams& streams) {
  if (options.scene.empty()) {
    const Result<std::vector<std::string>> shipped = shippedScenes();
    if (!shipped) return fail(shipped.problems(), streams);
    if (!shipped.value().empty()) options.scene = shipped.value().front();
  }
  if (options.hand.empty() && options.isSimulated()) options.hand = "still";
  Exit exit = Exit::Success;
  std::optional<Prepared> prepared = prepare(options, 0, streams, exit);
  if (!prepared) return exit;
  const system::Interrupt interrupt(system::Reader::MayGo);
  Result<serve::Server> server = serve::Server::open(options.port, options.origins);
  if (!server) return fail(server.problems(), Exit::File, streams);
  if (options.haply) {
    const Problems problems = server.value().alsoListen(options.haply_port, options.origins);
    if (!problems.empty()) return fail(problems, Exit::File, streams);
  }
  const Result<serve::Token> token = serve::tokenFor(options.token_file, server.value().port());
  if (!token) return fail(token.problems(), Exit::File, streams);
  const serve::MadeToken made(token.value());
  Result<std::unique_ptr<servo::DevicePort>> arm = openArm(options, *prepared);
  if (!arm) return fail(arm.problems(), Exit::Fault, streams);
  servo::Host host(std::move(arm).value(),
                   {.rate_hz = options.rate_hz, .scheduling = options.scheduling, .max_late = options.max_late});
  if (const Problems problems = host.load(prepared->scene.description); !problems.empty())
    return fail(problems, Exit::BadInput, streams);
  if (options.starts) host.start();
  std::optional<record::CsvWriter> csv;
  serve::HostAlone alone(host, {options.sessions.empty() ? serve::sessionsFolder() : options.sessions,
                                [&csv](const servo::TickRecord& record) {
                                  if (csv) csv->add(record);
                                },
                                device::provenanceOfService(options.isSimulated() ? &prepared->run : nullptr)});
  serve::Service service(alone, {token.value().text, options.anyone_steers});
  if (formatOf(options.record) == "csv") {
    Result<record::CsvWriter> opened = record::CsvWriter::create(options.record, options.existing());
    if (!opened) return fail(opened.problems(), Exit::File, streams);
    csv = std::move(opened).value();
  } else if (!options.record.empty()) {
    const Problems problems = alone.startRecordingAt(options.record, options.existing());
    if (!problems.empty()) return fail(problems, Exit::File, streams);
  }
  // From here on a signal ends the force itself, even while this thread is busy.
  const system::Interrupt stopping(system::Reader::MayGo, &host.stops());
  host.begin();
  alone.noteServo();
  JsonObject line;
  line.addText("serving", "ws://127.0.0.1:" + std::to_string(server.value().port()));
  line.addText("token_file", token.value().file);
  if (options.haply) line.addText("haply", "ws://127.0.0.1:" + std::to_string(server.value().port(1)));
  streams.out << line.text() << std::endl;
  bool is_guarded = true;
  serve::HaplyService haply(service);
  std::vector<serve::Endpoint*> endpoints{&service};
  if (options.haply) endpoints.push_back(&haply);
  server.value().run(endpoints, [&] {
    const Sentence unguarded = host.unguarded();
    if (std::exchange(is_guarded, unguarded.empty()) != is_guarded)
      streams.err << (is_guarded ? "The arm is guarded again." : unguarded) << '\n';
    for (const Sentence& sentence : alone.news()) streams.err << sentence << '\n';
    return !interrupt.came();
  });
  letGo(service);
  Problems unwritten = alone.close();
  if (csv) {
    const Problems of_csv = csv->close();
    unwritten.insert(unwritten.end(), of_csv.begin(), of_csv.end());
    if (const std::int64_t untaken = host.snapshot().dropped; untaken > 0)
      unwritten.push_back(
          {std::to_string(untaken) + " ticks are missing in the recording: the computer was too busy to write them."});
  }
  print(unwritten, streams.err);
  return unwritten.empty() ? Exit::Success : Exit::File;
}

}  // namespace

void addServe(Command program, const Streams& streams, Exit& exit) {
  const Command command =
      program.add("serve", "Let other programs of this computer listen to a running scene and steer it");
  const auto options = std::make_shared<ServeOptions>();
  command.option("scene", options->scene, "Scene file; by default the first one that comes with the program");
  command.option("--port", options->port, "Port of this computer; 0: a free one").showDefault().range(0, 65535);
  command.flag("--start", options->starts, "Start at once; otherwise it begins stopped, with ticks running");
  command.option(
      "--token-file", options->token_file,
      "File with the token that clients need; a new one is made if it does not exist. By default a new token "
      "in the runtime folder");
  command
      .option("--allow-origin", options->origins,
              "Let the pages of this origin, as in https://lab.example, connect from a browser")
      .oneEachTime()
      .word("ORIGIN");
  command.flag("--anyone-steers", options->anyone_steers, "Let each client that steers take the lease from another");
  const Option recording = command.option(
      "--record", options->record,
      "Write every tick to this new file: as CSV if its name ends in .csv, else as a session, which has every act of a "
      "client, too");
  command.flag("--overwrite", options->overwrite, "Replace the file of --record if it exists").needs(recording);
  command
      .option(
          "--haply", options->haply_port,
          "Serve clients of Haply's Inverse service, too, at this port: the arm as an Inverse3. Without a token: any "
          "program of this computer can push then")
      .expected(0, 1)
      .defaultText(std::to_string(serve::kHaplyPort))
      .range(0, 65535)
      .whenGiven([options] { options->haply = true; });
  command.option("--sessions", options->sessions,
                 "Folder for the recordings of clients; by default that of the window: Underact/sessions in the user's "
                 "documents folder");
  addHandOptions(command, *options);
  addRateOptions(command, *options);
  addSeedOption(command, *options);
  addArmOptions(command, *options);
  command.whenChosen([options, &streams, &exit] { exit = runService(*options, streams); });
}

}  // namespace underact::cli
