#include "core/arm/conventions.h"

#include "core/base/units.h"

namespace underact::arm {

JointAngles dhFromDevice(const JointAngles& device_rad) noexcept {
  const auto& [turret, thigh, shin, g1, g2, g3] = device_rad;
  return {-turret, thigh, shin - thigh, -g1, g2 + kPi / 2, -g3 - kPi / 2};
}

JointAngles deviceFromDh(const JointAngles& q_rad) noexcept {
  const auto& [q1, q2, q3, q4, q5, q6] = q_rad;
  return {-q1, q2, q2 + q3, -q4, q5 - kPi / 2, -q6 - kPi / 2};
}

}  // namespace underact::arm
