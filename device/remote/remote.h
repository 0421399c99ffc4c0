#pragma once
#include "device/catalogue.h"

namespace underact::device::remote {

// A row of the catalogue. Address: HOST:PORT; empty: this computer's own.
Result<std::unique_ptr<servo::DevicePort>> openRow(const Request& request);
/// An arm that is shared at this computer's own port, if there is one.
std::vector<Found> searchRow();

}  // namespace underact::device::remote
