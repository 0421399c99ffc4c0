#include "core/extremes/rows/arm_draws.h"

namespace underact::extremes {

arm::Geometry drawArm(Input& input, int size) {
  arm::Geometry geometry;
  geometry.upper_m =
      input.number("upper_m", [&](Dice& dice) { return dice.one(2) ? 0.127508 : dice.power(-size, size); });
  geometry.fore_m = input.number("fore_m", [&](Dice& dice) {
    return dice.one(2) ? geometry.upper_m * dice.between(0.5, 1.5) : geometry.upper_m * dice.ratio();
  });
  geometry.p_WB = input.vector("p_WB", [&](Dice& dice) {
    return dice.one(2) ? Vec3(Vec3::Zero()) : dice.inBox(2.0 * geometry.upper_m * dice.ratio());
  });
  return geometry;
}

arm::JointAngles drawJoints(Input& input) {
  arm::JointAngles q_rad{};
  for (double& angle_rad : q_rad) angle_rad = input.number("q_rad", [](Dice& dice) { return dice.angle(); });
  return q_rad;
}

}  // namespace underact::extremes
