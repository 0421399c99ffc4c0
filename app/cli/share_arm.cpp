#include <chrono>
#include <ostream>
#include <thread>

#include "app/cli/command.h"
#include "app/cli/lines.h"
#include "app/cli/scene_file.h"
#include "core/sim/arm_model.h"
#include "core/system/signals.h"
#include "core/system/this_process.h"
#include "device/catalogue.h"
#include "device/remote/share.h"

namespace underact::cli {
namespace {

using device::remote::Address;
using device::remote::KeyFolder;
using device::remote::KeyPair;

constexpr std::chrono::milliseconds kBetweenLooks{20};
constexpr const char* kRemote = "remote";

struct ShareArmOptions {
  std::string device = "simulated";
  std::string arm{arm::kDefaultArm};
  std::string listen;
  std::string allow;  // "KEY NAME"
  std::string trust;  // "HOST:PORT KEY"
  int rate_hz = 1000;
  double seconds = 0.0;  // 0: until Ctrl+C
  bool force = false, no_passivity = false, new_key = false, show_key = false;
};

/// The command for the other computer, with which it can reach an arm that is shared here at address.
std::string trustLine(Address address, const std::string& key) {
  if (address.host == "0.0.0.0" || address.host == "::") address.host = system::computerName();
  return "underact-cli share-arm --trust='" + address.text() + " " + key + "'";
}

/// "HOST:PORT KEY", as the other computer printed it.
Exit trust(const KeyFolder& folder, const std::string& words, const Streams& streams) {
  const std::size_t space = std::min(words.find(' '), words.size());
  const Result<Address> address = device::remote::readAddress(words.substr(0, space));
  if (!address) return fail(address.problems(), Exit::Usage, streams);
  const std::string key = space < words.size() ? words.substr(space + 1) : "";
  const bool is_key = device::remote::isKey(key);
  const Problems problems = folder.trust(address.value(), key);
  if (!problems.empty()) return fail(problems, is_key ? Exit::File : Exit::Usage, streams);
  streams.out << "Known from now on. The arm there is --device remote:" << address.value().text() << '\n';
  return Exit::Success;
}

/// "KEY", with whatever words behind it tell people whose it is.
Exit allow(const KeyFolder& folder, const std::string& words, const Streams& streams) {
  const std::string key = words.substr(0, words.find(' '));
  const bool is_key = device::remote::isKey(key);
  const Problems problems = folder.allow(key, key.size() < words.size() ? words.substr(key.size() + 1) : "");
  if (!problems.empty()) return fail(problems, is_key ? Exit::File : Exit::Usage, streams);
  streams.out << "Permitted from now on, for every arm that you share with others: share-arm --listen 0.0.0.0\n";
  return Exit::Success;
}

void printSharedArm(const device::remote::ShareOptions& options, const Address& address, const std::string& title,
                    Lines& say) {
  say(title + " is shared at " + address.text() + ", " + std::to_string(options.rate_hz) + " Hz, joints of " +
      options.arm.name + (options.allows_force ? ", with force" : ", without force (--force allows it)") +
      (options.is_passive ? ", with passivity control." : ", without passivity control."));
  if (address.isThisMachine()) {
    say("Your own programs on this computer open it with --device remote:" + address.text());
  } else {
    say("Permitted keys: " + std::to_string(options.clients.size()) + ". Run this once on each of those computers:");
    say("  " + trustLine(address, options.keys.public_key));
  }
}

Exit share(const ShareArmOptions& asked, const KeyFolder& folder, const KeyPair& keys, const Streams& streams) {
  const arm::Preset* const preset = arm::findPreset(asked.arm);
  if (preset == nullptr) return fail({{"There is no arm \"" + asked.arm + "\".", {}}}, Exit::Usage, streams);
  if (!arm::isDevice(*preset))
    return fail(
        {{"The arm \"" + asked.arm + "\" exists as a simulated arm of a scene only; there is none to share.", {}}},
        Exit::Usage, streams);
  if (asked.device == kRemote || asked.device.starts_with(std::string(kRemote) + ":"))
    return fail({{"An arm that is shared over the network cannot be shared again. Share it on its own computer.", {}}},
                Exit::Usage, streams);
  const Result<Address> listen = device::remote::readAddress(asked.listen);
  if (!listen) return fail(listen.problems(), Exit::Usage, streams);
  const Result<std::vector<std::string>> clients = folder.clients();
  if (!clients) return fail(clients.problems(), Exit::File, streams);
  device::remote::ShareOptions options{listen.value(), keys,        clients.value(),    *preset,
                                       asked.rate_hz,  asked.force, !asked.no_passivity};
  const system::Interrupt interrupt(system::Reader::MayGo);
  Result<std::unique_ptr<servo::DevicePort>> arm =
      device::openDevice(asked.device, {*preset, *sim::findArmModel(sim::kDefaultArmModel), asked.rate_hz, {}});
  if (!arm) return fail(arm.problems(), Exit::Fault, streams);
  const std::string title = arm.value()->info().title;
  Lines say(streams.out, streams.out_fd);
  Result<std::unique_ptr<device::remote::Share>> shared = device::remote::Share::open(
      std::move(arm).value(), options, [&say](const std::string& sentence) { say(sentence); });
  if (!shared) return fail(shared.problems(), Exit::Fault, streams);
  printSharedArm(options, shared.value()->address(), title, say);
  const auto end = std::chrono::steady_clock::now() + std::chrono::duration<double>(asked.seconds);
  while (!interrupt.came() && (asked.seconds == 0.0 || std::chrono::steady_clock::now() < end))
    std::this_thread::sleep_for(kBetweenLooks);
  std::move(shared).value().reset();
  say("Zero force. The arm is no longer shared.");
  return Exit::Success;
}

Exit perform(const ShareArmOptions& asked, const Streams& streams) {
  const KeyFolder folder;
  if (!asked.trust.empty()) return trust(folder, asked.trust, streams);
  if (!asked.allow.empty()) return allow(folder, asked.allow, streams);
  const Result<KeyPair> keys = asked.new_key ? folder.makeNew() : folder.own();
  if (!keys) return fail(keys.problems(), Exit::File, streams);
  if (!asked.new_key && !asked.show_key) return share(asked, folder, keys.value(), streams);
  streams.out << "Your key is " << keys.value().public_key
              << "\n"
                 "Run this once on the computer of the arm:\n"
              << "  underact-cli share-arm --allow='" << keys.value().public_key << " " << system::computerName()
              << "'\n";
  return Exit::Success;
}

}  // namespace

void addShareArm(Command program, const Streams& streams, Exit& exit) {
  const Command command =
      program.add("share-arm", "Let one program at a time, on this computer or another, drive an arm of this computer");
  const auto options = std::make_shared<ShareArmOptions>();
  command.option("--device", options->device, "The arm, KIND or KIND:ADDRESS, as underact-cli devices lists it")
      .showDefault();
  command.option("--arm", options->arm, "The arm that the joint samples belong to, as scenes name it").showDefault();
  command
      .option("--listen", options->listen,
              "HOST or HOST:PORT of this computer; 0.0.0.0 for all of its networks, for permitted users only")
      .defaultText(Address{}.text());
  command.option("--rate", options->rate_hz, "Ticks per second, until a program requests another rate")
      .showDefault()
      .range(servo::kSlowest_hz, servo::kFastest_hz);
  command.flag("--force", options->force, "Permit force; without it, the arm is only read");
  command.flag("--no-passivity", options->no_passivity,
               "Do not damp the energy that a wall generates because of the network's delay");
  command.option(
      "--allow", options->allow,
      "Permit a user: \"KEY NAME\", as share-arm --show-key prints it on that user's computer. Shares nothing");
  command.option("--trust", options->trust,
                 "Trust an arm: \"HOST:PORT KEY\", as share-arm prints it on the arm's computer. Shares nothing");
  const Option show = command.flag("--show-key", options->show_key, "Print your key; shares nothing");
  command.flag("--new-key", options->new_key, "Make a new key and print it; shares nothing").excludes(show);
  command.option("--seconds", options->seconds, "Duration, s; 0: until Ctrl+C").range(0.0, 1e9).showDefault();
  command.whenChosen([options, &streams, &exit] { exit = perform(*options, streams); });
}

}  // namespace underact::cli
