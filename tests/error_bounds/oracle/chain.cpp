#include "tests/error_bounds/oracle/chain.h"

namespace underact::error_bounds::oracle {

ChainPose chainPose(const chain::Chain& chain, const std::vector<Real>& q) {
  Motion all;
  for (std::size_t i = 0; i < chain.joints.size(); ++i) {
    const chain::Joint& joint = chain.joints[i];
    const Real3 axis = unit(real(joint.axis_W)), point = real(joint.p_WJ);
    if (joint.type == chain::JointType::Prismatic) {
      all = all * Motion{Quaternion{}, q[i] * axis};
    } else {
      const Quaternion turn = about(axis, q[i]);
      all = all * Motion{turn, point - turned(turn, point)};
    }
  }
  return {turned(all.turn, columnsOf(chain.X_WT_home.linear())), moved(all, real(chain.X_WT_home.translation()))};
}

std::vector<Real> realOf(std::span<const double> q) {
  return {q.begin(), q.end()};
}

Twist chainTwist(const chain::Chain& chain, std::vector<Real> q, std::size_t joint) {
  const Real tiny = ldexp(Real(1), -110), middle = q[joint];
  q[joint] = middle + tiny;
  const ChainPose after = chainPose(chain, q);
  q[joint] = middle - tiny;
  const ChainPose before = chainPose(chain, q);
  Real3 sum{0, 0, 0};
  for (std::size_t i = 0; i < 3; ++i) sum = sum + cross(before.R_WT[i], after.R_WT[i]);
  return {(1 / (2 * tiny)) * (after.p_WT - before.p_WT), (1 / (4 * tiny)) * sum};
}

}  // namespace underact::error_bounds::oracle
