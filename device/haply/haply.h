#pragma once
#include "device/driver.h"

namespace underact::device::haply {

/// The row of the catalogue: an Inverse3 behind Haply's service; the address is HOST:PORT, or HOST:PORT/ID.
Result<std::unique_ptr<servo::DevicePort>> openArm(const Request& request);
/// Those of a service at the usual port of this computer. Opens nothing.
std::vector<Found> searchArms();
/// Those of that service; address: as people give it.
std::vector<Found> searchAt(const std::string& address);

}  // namespace underact::device::haply
