#pragma once
#include <array>
#include <cstdint>
#include <span>
#include <string_view>

#include "core/arm/preset.h"
#include "core/base/real_time.h"
#include "device/wooden_haptics/report.h"

namespace underact::device {

/// How an open HID arm identifies itself on USB.
struct WoodenId {
  std::uint16_t vendor, product;
  const char* board;
  bool is_shared;  // every board of this kind identifies itself so, whatever it drives:
                   // used only if asked for by name
};
std::span<const WoodenId> woodenIds();
const WoodenId* findWoodenId(std::uint16_t vendor, std::uint16_t product);

// For both boards.
inline constexpr std::uint16_t kWoodenUsagePage = 0xFFAB, kWoodenUsage = 0x0200;

/// The geometry and drives of an arm. Three bodies, each driven by a motor with a capstan: A turns about the vertical,
/// B is the upper arm, C the forearm, both measured from the vertical. The figures of the source, in its frame (x
/// towards the person, y to the right, z up), SI.
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
  bool is_open;                           // false: its kinematics are not published
};
std::span<const WoodenModel> woodenModels();
const WoodenModel* findWoodenModel(std::string_view key);

/// The default model: never one whose motors need more current than those of another with the same protocol, so that a
/// wrong guess makes forces too weak.
const WoodenModel& defaultWoodenModel(WoodenProtocol protocol);

/// The limit of each motor, mA.
inline constexpr double kMaxCurrent_mA = 2000.0;

/// The signs of counts and currents, and where counting begins. The same for all arms of a protocol.
struct WoodenWiring {
  std::array<double, 3> count_sign;         // of a body's angle by a count
  std::array<double, 3> current_sign;       // of the torque on a body by a current
  std::array<double, 3> angle_rad;          // of the bodies where the counts are 0
  std::array<std::int16_t, 6> home_counts;  // V2: of the encoders in the home posture
};
const WoodenWiring& woodenWiring(WoodenProtocol protocol);

/// The arm's lengths for core/arm: an Omni of another size. See woodenJoints().
arm::Geometry woodenGeometry(const WoodenModel& model) noexcept UNDERACT_REAL_TIME;

}  // namespace underact::device
