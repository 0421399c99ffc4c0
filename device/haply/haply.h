#pragma once
#include "device/catalogue.h"

namespace underact::device::haply {

/// The row of the catalogue: an Inverse3 behind Haply's service; the address is HOST:PORT, or HOST:PORT/ID.
Result<std::unique_ptr<servo::DevicePort>> openRow(const Request& request);
/// Those of a service at the usual port of this computer. Opens nothing.
std::vector<Found> searchRow();
/// Those of that service; address: as people give it.
std::vector<Found> searchAt(const std::string& address);

}  // namespace underact::device::haply
