#include "device/openhaptics/find_arms.h"

#include <algorithm>
#include <cstdlib>
#include <fstream>
#include <string>

#include "core/base/translate.h"
#include "core/system/file.h"
#include "device/openhaptics/settings.h"

namespace underact::device::openhaptics {
namespace {

namespace fs = std::filesystem;

/// The vendor's USB identity, now and formerly; the product says which interface it uses.
bool isTheMakers(const std::string& vendor, const std::string& product) {
  return vendor == "2988" || (vendor == "0301" && product == "2988");
}

std::string wordIn(const fs::path& file) {
  std::ifstream stream(file);
  std::string word;
  std::getline(stream, word);
  while (!word.empty() && (word.back() == ' ' || word.back() == '\r')) word.pop_back();
  return word;
}

bool startsWith(const std::string& text, const char* beginning) {
  return text.rfind(beginning, 0) == 0;
}

/// The names of its device nodes: ttyACM0, hidraw3.
std::vector<std::string> nodesOf(const fs::path& device) {
  constexpr int kDeepest = 4;  // 1-1/1-1:1.0/0003:2988:0304.0001/hidraw/hidraw0
  std::vector<std::string> nodes;
  std::error_code error;
  fs::recursive_directory_iterator at(device, fs::directory_options::skip_permission_denied, error), end;
  for (; !error && at != end; at.increment(error)) {
    const std::string name = at->path().filename().string();
    if (at.depth() >= kDeepest) at.disable_recursion_pending();
    const bool is_node = startsWith(name, "ttyACM") || (startsWith(name, "hidraw") && name != "hidraw");
    if (is_node && std::find(nodes.begin(), nodes.end(), name) == nodes.end()) nodes.push_back(name);
  }
  std::sort(nodes.begin(), nodes.end());
  return nodes;
}

std::string ruleFor(const std::string& node, const std::string& vendor) {
  const std::string subsystem = startsWith(node, "tty") ? "tty" : "hidraw";
  return "echo 'SUBSYSTEM==\"" + subsystem + "\", ATTRS{idVendor}==\"" + vendor +
         "\", TAG+=\"uaccess\"' | sudo tee -a /etc/udev/rules.d/70-underact-touch.rules && sudo udevadm control "
         "--reload && sudo udevadm trigger";
}

std::vector<Missing> permissions(const SearchPaths& places, const fs::path& device, const std::string& vendor) {
  std::vector<Missing> missing;
  for (const std::string& node : nodesOf(device)) {
    const fs::path path = places.nodes / node;
    std::error_code ignored;
    if (!fs::exists(path, ignored)) {
      missing.push_back(
          {phrase(TRANSLATE_NOOP("problem", "The system has not created %1 for the arm. Plug it in again."),
                  {path.string()}),
           ""});
    } else if (!system::mayReadAndWrite(path.string())) {
      missing.push_back(
          {phrase(TRANSLATE_NOOP("problem",
                                 "You do not have permission to use %1 of the arm. This rule gives it to "
                                 "whoever is logged in at the computer; plug the arm in again afterwards."),
                  {path.string()}),
           ruleFor(node, vendor)});
    }
  }
  return missing;
}

std::vector<Missing> settings(const SearchPaths& places) {
  if (places.settings_are_named || settingsFolder(places.home, places.shared)) return {};
  return {{phrase(TRANSLATE_NOOP(
                      "problem",
                      "The vendor's driver has no settings: there is no folder config in %1 or %2, and GTDD_HOME "
                      "names no other. Run the vendor's Touch_Setup, or set GTDD_HOME to the folder."),
                  {places.home.string(), places.shared.string()}),
           std::string("export ") + kSettingsVariable + "=" + places.home.string()}};
}

void append(std::vector<Missing>& to, const std::vector<Missing>& from) {
  to.insert(to.end(), from.begin(), from.end());
}

}  // namespace

SearchPaths places() {
  SearchPaths the;
  the.home = homeFolder();
  the.shared = sharedFolder();
  the.settings_are_named = std::getenv(kSettingsVariable) != nullptr;
  return the;
}

std::vector<Found> findArms(const SearchPaths& places, const std::vector<Missing>& library) {
  std::vector<Missing> common = library;
  append(common, settings(places));
  std::vector<Found> found;
  std::error_code error;
  for (fs::directory_iterator at(places.usb, error), end; !error && at != end; at.increment(error)) {
    const std::string vendor = wordIn(at->path() / "idVendor"), product = wordIn(at->path() / "idProduct");
    if (!isTheMakers(vendor, product)) continue;
    const std::string serial = wordIn(at->path() / "serial");
    Found one{serial.empty() ? phrase(TRANSLATE_NOOP("problem", "Touch or Omni on USB"))
                             : phrase(TRANSLATE_NOOP("problem", "Touch or Omni on USB, serial %1"), {serial}),
              "", common};
    append(one.missing, permissions(places, at->path(), vendor));
    found.push_back(std::move(one));
  }
  if (!found.empty()) return found;
  common.push_back({phrase(TRANSLATE_NOOP("problem",
                                          "No Touch or Omni was found on USB. Plug it in and switch it on. An arm on "
                                          "FireWire or Ethernet is not detected here, but may still open.")),
                    "lsusb -d 2988:"});
  return {{phrase(TRANSLATE_NOOP("problem", "Touch, Omni (vendor's driver)")), "", common}};
}

}  // namespace underact::device::openhaptics
