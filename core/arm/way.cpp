#include "core/arm/way.h"

#include <algorithm>

namespace underact::arm {

JointAngles onTheWay(const JointAngles& from_rad, const JointAngles& to_rad, double share) noexcept {
  const double held = std::clamp(share, 0.0, 1.0);
  JointAngles at_rad{};
  for (std::size_t joint = 0; joint < at_rad.size(); ++joint) {
    at_rad[joint] = (1.0 - held) * from_rad[joint] + held * to_rad[joint];  // exact at both ends
  }
  return at_rad;
}

}  // namespace underact::arm
