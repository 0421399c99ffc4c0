#include "core/arm/sample.h"

#include <algorithm>

#include "core/base/units.h"

namespace underact::arm {

JointAngles interpolated(const JointAngles& from_rad, const JointAngles& to_rad, double share) noexcept {
  const double held = std::clamp(share, 0.0, 1.0);
  JointAngles at_rad{};
  for (std::size_t joint = 0; joint < at_rad.size(); ++joint) {
    at_rad[joint] = (1.0 - held) * from_rad[joint] + held * to_rad[joint];  // exact at both ends
  }
  return at_rad;
}

JointAngles dhFromDevice(const JointAngles& device_rad) noexcept {
  const auto& [turret, thigh, shin, g1, g2, g3, none7, none8] = device_rad;
  return {-turret, thigh, shin - thigh, -g1, g2 + kPi / 2, -g3 - kPi / 2};
}

JointAngles deviceFromDh(const JointAngles& q_rad) noexcept {
  const auto& [q1, q2, q3, q4, q5, q6, none7, none8] = q_rad;
  return {-q1, q2, q2 + q3, -q4, q5 - kPi / 2, -q6 - kPi / 2};
}

}  // namespace underact::arm
