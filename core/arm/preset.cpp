#include "core/arm/preset.h"

#include <algorithm>

#include "core/base/units.h"

namespace underact::arm {
namespace {

// From a public description of the robot, turned into DH angles; to be replaced by a device's own.
constexpr JointLimits kOmniLimits{{-0.98, 0.0, -0.81, -2.54, 0.62, -2.34}, {0.98, 1.75, 1.37, 2.60, 2.60, 2.34}};
// Measured on a device of the kind; gimbal 2 pi / 4915 rad a step.
constexpr EncoderCounts kOmniCounts{15280, 15399, 15419, 4915, 4915, 4915};
// The vendor's figure for what the motors can hold without growing hot; the thesis clamps to it.
constexpr double kOmniContinuous_N = 0.88;

const std::array<Preset, 2>& all() {
  static const std::array<Preset, 2> kPresets{
      Preset{"omni-thesis", "PHANToM Omni, lengths of the thesis",
             "Beckman 2007, table 3.1 and eq. 3.1. Joint limits and encoder steps from public descriptions.",
             Geometry{0.127508, 0.149352, Vec3(0.0, 0.030, -0.176)}, kOmniLimits, kOmniCounts, kOmniContinuous_N},
      Preset{"touch-measured", "Touch, lengths fitted to a recording",
             "Fitted to a public recording of a Touch, 0.015 mm rms. Joint limits as omni-thesis, not measured.",
             Geometry{0.13335, 0.13335, Vec3(0.0, 0.02335, -0.16835)}, kOmniLimits, kOmniCounts, kOmniContinuous_N}};
  return kPresets;
}

}  // namespace

std::span<const Preset> presets() {
  return all();
}

const Preset* findPreset(std::string_view name) {
  const std::span<const Preset> every = presets();
  const auto found =
      std::find_if(every.begin(), every.end(), [&](const Preset& preset) { return name == preset.name; });
  return found == every.end() ? nullptr : &*found;
}

}  // namespace underact::arm
