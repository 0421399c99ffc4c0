#pragma once
#include "device/driver.h"
#include "device/wooden_haptics/hid_bus.h"

namespace underact::device {

// A row of the catalogue. Address: see WoodenChoice.
Result<std::unique_ptr<servo::DevicePort>> openWooden(const Request& request);
std::vector<Found> searchWooden();

/// Searches any bus.
std::vector<Found> searchWooden(HidBus& bus);

}  // namespace underact::device
