#include "device/catalogue.h"

#include <algorithm>
#include <array>

#include "core/base/translate.h"
#include "device/haply/haply.h"
#include "device/openhaptics/openhaptics_arm.h"
#include "device/remote/remote.h"
#include "device/simulated_arm.h"
#include "device/wooden_haptics/wooden.h"

namespace underact::device {
namespace {

Result<std::unique_ptr<servo::DevicePort>> openSimulated(const Request& request) {
  SimulatedArm::Options options;
  options.arm = request.arm;
  options.model = request.model;
  options.rate_hz = request.rate_hz;
  return std::unique_ptr<servo::DevicePort>(std::make_unique<SimulatedArm>(options));
}

constexpr const char* kSimulated = TRANSLATE_NOOP("problem", "Simulated arm");

std::vector<Found> searchSimulated() {
  return {{phrase(kSimulated), "", {}}};
}

// One kind of arm per line.
constexpr std::array kDrivers{
    Driver{"simulated", kSimulated, openSimulated, searchSimulated},
    Driver{"openhaptics", TRANSLATE_NOOP("problem", "Touch, Omni (vendor's driver)"), openhaptics::openArm,
           openhaptics::searchArms},
    Driver{"wooden", TRANSLATE_NOOP("problem", "WoodenHaptics (HID)"), openWooden, searchWooden},
    Driver{"haply", TRANSLATE_NOOP("problem", "Inverse3 (Haply's service)"), haply::openArm, haply::searchArms},
    Driver{"remote", TRANSLATE_NOOP("problem", "Arm over the network"), remote::openArm, remote::searchArms},
};

}  // namespace

std::span<const Driver> catalogue() {
  return kDrivers;
}

std::string nameOf(const Driver& driver, const Found& found) {
  return found.address.empty() ? driver.key : std::string(driver.key) + ":" + found.address;
}

const Driver* findDevice(std::string_view key) {
  const auto* const found =
      std::find_if(kDrivers.begin(), kDrivers.end(), [&](const Driver& driver) { return key == driver.key; });
  return found == kDrivers.end() ? nullptr : &*found;
}

Result<std::unique_ptr<servo::DevicePort>> openDevice(std::string_view name, Request request) {
  const std::size_t colon = std::min(name.find(':'), name.size());
  const Driver* const driver = findDevice(name.substr(0, colon));
  if (driver == nullptr) {
    std::string known;
    for (const Driver& one : kDrivers) known += (known.empty() ? "" : ", ") + std::string(one.key);
    return Problems{{phrase(TRANSLATE_NOOP("problem", "There is no arm of the kind \"%1\". Known kinds: %2."),
                            {std::string(name.substr(0, colon)), known}),
                     {}}};
  }
  if (!arm::isDevice(request.arm) && driver != kDrivers.data()) {
    return Problems{{phrase(TRANSLATE_NOOP("problem",
                                           "The scene is for the arm \"%1\", which exists as a simulated arm only. "
                                           "Choose the simulated arm, or open another scene first."),
                            {request.arm.name}),
                     {}}};
  }
  if (colon < name.size()) request.address = name.substr(colon + 1);
  return driver->open(request);
}

}  // namespace underact::device
