#pragma once
#include <array>
#include <cstdint>
#include <span>
#include <string_view>

#include "core/arm/preset.h"
#include "core/base/real_time.h"
#include "device/wooden/report.h"

namespace underact::device {

/// What an open HID arm says it is when it is plugged in.
struct WoodenId {
  std::uint16_t vendor, product;
  const char* board;
  bool
      is_shared;  // every board of this kind says so, whatever it is used for: taken only where it is asked for by name
};
std::span<const WoodenId> woodenIds();
const WoodenId* findWoodenId(std::uint16_t vendor, std::uint16_t product);

// Of both boards.
inline constexpr std::uint16_t kWoodenUsagePage = 0xFFAB, kWoodenUsage = 0x0200;

/// How an arm is built. Three bodies, each driven by a motor with a capstan: A turns about the upright, B is the upper
/// arm, C the forearm, both measured from the upright. The figures of the source, in its frame (x towards the person, y
/// to the right, z up), SI.
struct WoodenModel {
  const char* key;    // in an address
  const char* title;  // for people
  const char* source;
  std::array<double, 3> capstan_m;  // diameters
  std::array<double, 3> body_m;     // diameters of what the capstans drive
  std::array<double, 3> length_m;   // height of the shoulder, upper arm, forearm
  std::array<double, 3> origin_m;   // of the workspace, from the foot
  std::array<double, 3> torque_N_m_per_A;
  std::array<double, 3> counts_per_turn;  // of the motors
  bool is_open;                           // false: how it moves is not published
};
std::span<const WoodenModel> woodenModels();
const WoodenModel* findWoodenModel(std::string_view key);

/// The model that is taken where none is asked for: never one whose motors need more current than those of another
/// that speaks the same protocol, so that a wrong guess makes forces too weak.
const WoodenModel& defaultWoodenModel(WoodenProtocol protocol);

/// No motor gets more, mA.
inline constexpr double kMostCurrent_mA = 2000.0;

/// Which way counts and currents go, and where counting begins. The same for all arms of a protocol.
struct WoodenWiring {
  std::array<double, 3> count_sign;         // of a body's angle by a count
  std::array<double, 3> current_sign;       // of the torque on a body by a current
  std::array<double, 3> angle_rad;          // of the bodies where the counts are 0
  std::array<std::int16_t, 6> home_counts;  // V2: of the encoders in the home posture
};
const WoodenWiring& woodenWiring(WoodenProtocol protocol);

/// The arm's lengths as those of core/arm: an Omni of another size. See woodenJoints().
arm::Geometry woodenGeometry(const WoodenModel& model) noexcept UNDERACT_REAL_TIME;

}  // namespace underact::device
