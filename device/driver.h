#pragma once
#include <memory>
#include <string>
#include <vector>

#include "core/arm/preset.h"
#include "core/base/result.h"
#include "core/base/sentence.h"
#include "core/servo/device_port.h"
#include "core/sim/arm_model.h"

namespace underact::device {

/// Options for any arm that is opened.
struct Request {
  arm::Preset arm;
  sim::ArmModel model;  // of a simulated arm
  int rate_hz = 1000;
  std::string address;  // which one, if there may be several: see Found::address; empty: the first
};

/// Something missing that an arm needs.
struct Missing {
  Sentence sentence;
  std::string command;  // that fixes it, for a terminal; empty: there is none
};

/// An arm that was found, or a driver that could be used.
struct Found {
  Sentence title;                // "WoodenHaptics, serial 0042"
  std::string address;           // serial number, path, or HOST:PORT
  std::vector<Missing> missing;  // empty: it can be opened
};

/// A kind of arm that a person can choose.
struct Driver {
  const char* key;   // "simulated": what the command line takes
  const char* name;  // "Simulated arm": as the window shows it, marked for translators
  /// The open arm. Problems: why it cannot be opened, and what to do.
  Result<std::unique_ptr<servo::DevicePort>> (*open)(const Request& request);
  /// What is plugged in of this kind, and what is missing to use it. Opens nothing; may take some 10 ms.
  std::vector<Found> (*search)();
};

}  // namespace underact::device
