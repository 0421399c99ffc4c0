#include "device/arm_key.h"

namespace underact::device {
namespace {

constexpr std::string_view kLine = "Serial number: ", kTitle = ", serial ";

std::string serialOf(const servo::DeviceInfo& info, const std::vector<std::string>& listing) {
  for (const std::string& line : listing) {
    if (line.starts_with(kLine)) return line.substr(kLine.size());
  }
  const std::size_t at = info.title.rfind(kTitle);
  return at == std::string::npos ? std::string() : info.title.substr(at + kTitle.size());
}

}  // namespace

std::string armKey(std::string_view name, const servo::DeviceInfo& info, const std::vector<std::string>& listing) {
  if (info.simulated) return "simulated";
  const std::string serial = serialOf(info, listing);
  const std::string_view kind = name.substr(0, name.find(':'));
  if (!serial.empty() && !kind.empty()) return std::string(kind) + ":" + serial;
  return name.empty() ? std::string(info.title) : std::string(name);
}

}  // namespace underact::device
