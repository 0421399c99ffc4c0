#include <ostream>

#include "app/cli/command.h"
#include "app/cli/json_object.h"
#include "device/catalogue.h"

namespace underact::cli {
namespace {

/// As run --device takes it.
std::string nameOf(const device::Row& row, const device::Found& found) {
  return found.address.empty() ? row.key : std::string(row.key) + ":" + found.address;
}

void printWords(const device::Row& row, const std::vector<device::Found>& all, std::ostream& out) {
  out << row.name << '\n';
  if (all.empty()) out << "  none is plugged in\n";
  for (const device::Found& found : all) {
    out << "  " << found.title;
    out << (found.missing.empty() ? "  (--device " + nameOf(row, found) + ")\n" : "\n");
    for (const device::Missing& missing : found.missing) {
      out << "    " << missing.sentence << '\n';
      if (!missing.command.empty()) out << "      " << missing.command << '\n';
    }
  }
}

void printJson(const device::Row& row, const std::vector<device::Found>& all, std::ostream& out) {
  for (const device::Found& found : all) {
    JsonObject object;
    object.addText("kind", row.key);
    object.addText("name", row.name);
    object.addText("title", found.title);
    object.addText("device", nameOf(row, found));
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

}  // namespace

void addDevices(CLI::App& program, const Streams& streams, Exit&) {
  CLI::App* command = program.add_subcommand("devices", "What arms are plugged in, and what is missing to use them");
  const auto json = std::make_shared<bool>(false);
  command->add_flag("--json", *json, "A JSON object an arm");
  command->callback([json, &streams] {
    for (const device::Row& row : device::catalogue()) (*json ? printJson : printWords)(row, row.look(), streams.out);
  });
}

}  // namespace underact::cli
