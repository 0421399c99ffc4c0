#include "device/wooden_haptics/kinematics.h"

#include <algorithm>
#include <cmath>

#include "core/arm/statics.h"
#include "core/base/excepted.h"
#include "core/base/units.h"

namespace underact::device {

arm::JointAngles woodenJoints(const WoodenModel& model, const WoodenWiring& wiring,
                              const std::array<int, 3>& counts) noexcept {
  std::array<double, 3> body_rad{};
  for (std::size_t body = 0; body < 3; ++body) {
    const double motor_rad = 2.0 * kPi * static_cast<double>(counts[body]) / model.counts_per_turn[body];
    body_rad[body] =
        wiring.angle_rad[body] + wiring.count_sign[body] * motor_rad * model.capstan_m[body] / model.body_m[body];
  }
  const auto& [a_rad, b_rad, c_rad] = body_rad;
  return {a_rad, kPi / 2.0 - b_rad, b_rad + c_rad - kPi / 2.0, 0.0, 0.0, 0.0};
}

bool isWoodenPosture(const arm::JointAngles& q_rad) {
  const arm::JointLimits& limits = arm::findPreset("woodenhaptics")->limits;
  for (std::size_t joint = 0; joint < 3; ++joint) {
    if (!(q_rad[joint] >= limits.min_rad[joint] && q_rad[joint] <= limits.max_rad[joint])) return false;
  }
  return true;
}

Currents_mA woodenCurrents(const WoodenModel& model, const WoodenWiring& wiring, const arm::JointAngles& q_rad,
                           const Vec3& f_T_W) noexcept {
  const Vec3 torque_N_m =
      UNDERACT_EXCEPTED("lengths alone: nothing to free", arm::torqueOf(woodenGeometry(model), q_rad, f_T_W));
  // From the angles of the bodies: q2 decreases with B, and q3 increases with B and C.
  const std::array<double, 3> body_N_m{torque_N_m[0], torque_N_m[2] - torque_N_m[1], torque_N_m[2]};
  std::array<double, 3> wanted_mA{};
  double largest_mA = 0.0;
  for (std::size_t body = 0; body < 3; ++body) {
    const double motor_N_m = wiring.current_sign[body] * body_N_m[body] * model.capstan_m[body] / model.body_m[body];
    wanted_mA[body] = 1e3 * motor_N_m / model.torque_N_m_per_A[body];
    if (!std::isfinite(wanted_mA[body])) return {};
    largest_mA = std::max(largest_mA, std::abs(wanted_mA[body]));
  }
  const double share = largest_mA > kMaxCurrent_mA ? kMaxCurrent_mA / largest_mA : 1.0;
  Currents_mA currents_mA{};
  for (std::size_t body = 0; body < 3; ++body)
    currents_mA[body] = static_cast<std::int16_t>(std::round(share * wanted_mA[body]));
  return currents_mA;
}

}  // namespace underact::device
