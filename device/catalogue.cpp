#include "device/catalogue.h"

#include <algorithm>
#include <array>

#include "device/simulated_arm.h"

namespace underact::device {
namespace {

Result<std::unique_ptr<servo::DevicePort>> openSimulated(const Request& request) {
  SimulatedArm::Options options;
  options.arm = request.arm;
  options.model = request.model;
  options.rate_hz = request.rate_hz;
  return std::unique_ptr<servo::DevicePort>(std::make_unique<SimulatedArm>(options));
}

constexpr std::array<Row, 1> kRows{Row{"simulated", "Simulated arm", openSimulated}};

}  // namespace

std::span<const Row> catalogue() {
  return kRows;
}

const Row* findDevice(std::string_view key) {
  const auto* const found = std::find_if(kRows.begin(), kRows.end(), [&](const Row& row) { return key == row.key; });
  return found == kRows.end() ? nullptr : found;
}

}  // namespace underact::device
