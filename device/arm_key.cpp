#include "device/arm_key.h"

namespace underact::device {

std::string armKey(std::string_view name, const servo::DeviceInfo& info) {
  if (info.simulated) return "simulated";
  const std::string_view kind = name.substr(0, name.find(':'));
  if (!info.serial.empty() && !kind.empty()) return std::string(kind) + ":" + info.serial;
  return name.empty() ? std::string(info.title) : std::string(name);
}

}  // namespace underact::device
