#include "device/wooden_haptics/models.h"

#include <algorithm>

#include "core/base/units.h"

namespace underact::device {
namespace {

constexpr std::array kIds{
    WoodenId{0x1234, 0x0006, "WoodenHaptics", false},    // mbed's own for a HID device; both protocols
    WoodenId{0x16C0, 0x0486, "Teensy (Raw HID)", true},  // any Teensy with Raw HID
};

// forsslund/haptikfabrikenapi, haptikfabrikenapi.h; the lengths of all WoodenHaptics arms are the same there, and those
// of chai3d's CWoodenDevice.cpp (WoodenHaptics/woody-experimental), too.
constexpr std::array kModels{
    WoodenModel{"woody",
                "WoodenHaptics, 2015",
                "CWoodenDevice.cpp, default_woody(); haptikfabrikenapi.h, woodenhaptics_v2015()",
                {0.010, 0.010, 0.010},
                {0.160, 0.120, 0.120},
                {0.080, 0.205, 0.245},
                {0.220, 0.000, 0.080},
                {0.0259, 0.0259, 0.0259},
                {2000.0, 2000.0, 2000.0},
                true},
    WoodenModel{"woody-2019",
                "WoodenHaptics, 2019",
                "haptikfabrikenapi.h, woodenhaptics_v2019()",
                {0.010, 0.010, 0.010},
                {0.160, 0.120, 0.120},
                {0.080, 0.205, 0.245},
                {0.220, 0.000, 0.080},
                {0.321, 0.0603, 0.0603},
                {2000.0, 2000.0, 2000.0},
                true},
    WoodenModel{"polhem-v3",
                "Polhem, version 3",
                "haptikfabrikenapi.h, polhem_v3(); its kinematics is in no published file",
                {0.0288, 0.0130, 0.0100},
                {0.175, 0.100, 0.100},
                {0.100, 0.165, 0.1308},
                {0.2045, 0.000, 0.0325},
                {0.0603, 0.0538, 0.0538},
                {4096.0, 4096.0, 4096.0},
                false},
};

// V1: CWoodenDevice.cpp, the USB branches of getPosition() and setForceAndTorqueAndGripperForce(). The board counts
// from where the arm was when it got its power: upper arm upright, forearm level.
constexpr WoodenWiring kV1{{-1.0, -1.0, -1.0}, {1.0, -1.0, -1.0}, {0.0, 0.0, kPi / 2.0}, {}};
// V2: kinematics.cpp with all "aligned" false, as woodenhaptics_v2015() and _v2019() say; 6000 counts are that level
// forearm.
constexpr WoodenWiring kV2{{1.0, 1.0, 1.0}, {1.0, 1.0, 1.0}, {0.0, 0.0, 0.0}, {0, 0, 6000, 0, 0, 0}};

}  // namespace

std::span<const WoodenId> woodenIds() {
  return kIds;
}

const WoodenId* findWoodenId(std::uint16_t vendor, std::uint16_t product) {
  const auto* const found = std::find_if(
      kIds.begin(), kIds.end(), [&](const WoodenId& id) { return id.vendor == vendor && id.product == product; });
  return found == kIds.end() ? nullptr : &*found;
}

std::span<const WoodenModel> woodenModels() {
  return kModels;
}

const WoodenModel* findWoodenModel(std::string_view key) {
  const auto* const found =
      std::find_if(kModels.begin(), kModels.end(), [&](const WoodenModel& model) { return key == model.key; });
  return found == kModels.end() ? nullptr : &*found;
}

const WoodenModel& defaultWoodenModel(WoodenProtocol protocol) {
  return *findWoodenModel(protocol == WoodenProtocol::V1 ? "woody" : "woody-2019");
}

const WoodenWiring& woodenWiring(WoodenProtocol protocol) {
  return protocol == WoodenProtocol::V1 ? kV1 : kV2;
}

arm::Geometry woodenGeometry(const WoodenModel& model) noexcept {
  const auto& [foot_m, upper_m, fore_m] = model.length_m;
  const auto& [x_m, y_m, z_m] = model.origin_m;
  return {upper_m, fore_m, Vec3(-y_m, foot_m - z_m, -x_m)};  // x_W is the source's y, y_W its z, z_W its x
}

}  // namespace underact::device
