#pragma once
#include <span>
#include <string>
#include <string_view>

#include "device/driver.h"

namespace underact::device {

std::span<const Driver> catalogue();

/// As openDevice() takes it: "wooden:0042".
std::string nameOf(const Driver& driver, const Found& found);

/// The one of that key, or null.
const Driver* findDevice(std::string_view key);

/// Opens what "KEY" or "KEY:ADDRESS" names ("wooden:0042", "remote:127.0.0.1:7878"). Problems: no such kind, with a
/// list of those that exist; or it cannot be opened.
Result<std::unique_ptr<servo::DevicePort>> openDevice(std::string_view name, Request request);

}  // namespace underact::device
