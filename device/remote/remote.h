#pragma once
#include "device/catalogue.h"

namespace underact::device::remote {

// A row of the catalogue. Address: HOST:PORT; empty: this machine's own.
Result<std::unique_ptr<servo::DevicePort>> openRow(const Request& request);
/// An arm that is shared at this machine's own port, if somebody listens there.
std::vector<Found> lookRow();

}  // namespace underact::device::remote
