#include <fstream>
#include <ostream>

#include "app/cli/command.h"
#include "app/cli/json_object.h"
#include "app/cli/scene_file.h"
#include "core/base/printed.h"
#include "core/system/signals.h"
#include "device/catalogue.h"
#include "device/device_check.h"

namespace underact::cli {
namespace {

void printWords(const device::Driver& driver, const std::vector<device::Found>& all, std::ostream& out) {
  out << driver.name << '\n';
  if (all.empty()) out << "  none is connected\n";
  for (const device::Found& found : all) {
    const std::string chosen_by = "  (--device " + device::nameOf(driver, found) + ")";
    out << "  " << printed(found.title + (found.missing.empty() ? chosen_by : "")) << '\n';
    for (const device::Missing& missing : found.missing) {
      out << "    " << printed(missing.sentence) << '\n';
      if (!missing.command.empty()) out << "      " << printed(missing.command) << '\n';
    }
  }
}

void printJson(const device::Driver& driver, const std::vector<device::Found>& all, std::ostream& out) {
  for (const device::Found& found : all) {
    JsonObject object;
    object.addText("kind", driver.key);
    object.addText("name", driver.name);
    object.addText("title", found.title);
    object.addText("device", device::nameOf(driver, found));
    object.addBool("usable", found.missing.empty());
    std::vector<JsonObject> missing(found.missing.size());
    for (std::size_t index = 0; index < missing.size(); ++index) {
      missing[index].addText("sentence", found.missing[index].sentence);
      missing[index].addText("command", found.missing[index].command);
    }
    object.addList("missing", missing);
    out << object.text() << '\n';
  }
}

struct DevicesOptions {
  bool json = false;
  std::string report, out, words;  // report: the arm to try
  double seconds = 2.0;
};

Exit writeReport(const DevicesOptions& options, const Streams& streams) {
  constexpr int kRate_hz = 1000;
  const arm::Preset& preset = *arm::findPreset(arm::kDefaultArm);
  Result<std::unique_ptr<servo::DevicePort>> arm = device::openDevice(options.report, {preset, {}, kRate_hz, {}});
  if (!arm) return fail(arm.problems(), Exit::Fault, streams);
  const system::Interrupt interrupt;
  streams.err << "Move the stylus around and press its buttons. No force is sent.\n";
  const device::DeviceCheck trial = device::checkDevice(std::move(arm).value(), preset, kRate_hz, options.seconds,
                                                        [&interrupt] { return !interrupt.came(); });
  const std::string text = device::reportText(trial, options.report, options.words);
  if (options.out.empty()) {
    streams.out << text;
    return Exit::Success;
  }
  std::ofstream file(options.out);
  file << text;
  file.close();
  if (file) return Exit::Success;
  print(Problems{{"The report could not be written.", {options.out}}}, streams.err);
  return Exit::File;
}

}  // namespace

void addDevices(Command program, const Streams& streams, Exit& exit) {
  const Command command = program.add("devices", "List the connected arms, and what is missing to use them");
  const auto options = std::make_shared<DevicesOptions>();
  const Option json = command.flag("--json", options->json, "One JSON object per arm");
  const Option report = command.option("--report", options->report,
                                       "Test the arm KIND or KIND:ADDRESS without force, and write a report for the "
                                       "program's makers, so that the arm no longer counts as untested");
  report.excludes(json);
  command.option("--out", options->out, "File for the report; by default the screen").needs(report);
  command.option("--words", options->words, "What you felt and saw, in your own words, for the report").needs(report);
  command.option("--seconds", options->seconds, "Duration of the test, s")
      .needs(report)
      .range(0.1, 600.0)
      .showDefault();
  command.whenChosen([options, &streams, &exit] {
    if (!options->report.empty()) {
      exit = writeReport(*options, streams);
      return;
    }
    for (const device::Driver& driver : device::catalogue())
      (options->json ? printJson : printWords)(driver, driver.search(), streams.out);
  });
}

}  // namespace underact::cli
