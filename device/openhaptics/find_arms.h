#pragma once
#include <filesystem>
#include <vector>

#include "device/driver.h"

namespace underact::device::openhaptics {

/// Where to look; tests use their own.
struct SearchPaths {
  std::filesystem::path usb = "/sys/bus/usb/devices";
  std::filesystem::path nodes = "/dev";
  std::filesystem::path home, shared;  // folders of the driver's settings
  bool settings_are_named = false;     // GTDD_HOME is set
};

/// The machine's own.
SearchPaths places();

/// The arms on USB, each with what is missing to use it; if there is none, the driver alone, and the arm is among what
/// is missing. library: what the library lacks.
std::vector<Found> findArms(const SearchPaths& places, const std::vector<Missing>& library);

}  // namespace underact::device::openhaptics
