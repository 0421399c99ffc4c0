#pragma once
#include "device/catalogue.h"
#include "device/wooden/hid_bus.h"

namespace underact::device {

// A row of the catalogue. Address: see WoodenChoice.
Result<std::unique_ptr<servo::DevicePort>> openWooden(const Request& request);
std::vector<Found> lookForWooden();

/// The same on any bus.
std::vector<Found> lookForWooden(HidBus& bus);

}  // namespace underact::device
