#pragma once
#include "device/driver.h"

namespace underact::device::remote {

// A row of the catalogue. Address: HOST:PORT; empty: this computer's own.
Result<std::unique_ptr<servo::DevicePort>> openArm(const Request& request);
/// An arm that is shared at this computer's own port, if there is one.
std::vector<Found> searchArms();

}  // namespace underact::device::remote
