#pragma once
#include <string>
#include <string_view>

#include "core/servo/device_port.h"

namespace underact::device {

/// What identifies an arm across restarts and sockets: its kind and serial number ("wooden:0042"); for an arm without
/// one, the name by which it was opened. name: as openDevice() takes it; empty: not known.
std::string armKey(std::string_view name, const servo::DeviceInfo& info);

}  // namespace underact::device
