#include "tests/error_bounds/oracle/energy.h"

namespace underact::error_bounds::oracle {

Real turnAbout(const Real3& axis, const Real3& from, const Real3& to) {
  const Real3 a = unit(axis), across = without(from, a);
  return atan2(dot(a, cross(across, to)), dot(across, to));
}

Real weightAbout(const Real3& axis, const Real3& stylus) {
  const Real off = atan2(norm(cross(axis, stylus)), Real(abs(dot(axis, stylus))));
  const Real share = clamped(off / (piReal() / 36), 0, 1);
  return share * share * (3 - 2 * share);
}

Real energyOf(const manipulator::Manipulator& manipulator, const Pose& X_WT, const std::vector<Real>& theta) {
  const ChainPose tip = chainPose(manipulator.chain, theta);
  const Real3 off = tip.p_WT - real(X_WT.translation());
  const Vec3& kp = manipulator.kp_N_per_m;
  Real twice = kp.x() * off.x * off.x + kp.y() * off.y * off.y + kp.z() * off.z * off.z;
  const Columns stylus = columnsOf(X_WT.linear());
  if (manipulator.orientation == manipulator::Orientation::Axis) {
    const Real3 apart = tip.R_WT[2] - stylus[2];
    twice += manipulator.ko_N_m_per_rad * dot(apart, apart);
  } else if (manipulator.orientation == manipulator::Orientation::Full) {
    const Real angle = angleOf(stylus, tip.R_WT);
    twice += manipulator.ko_N_m_per_rad * angle * angle;
  } else if (manipulator.orientation == manipulator::Orientation::Angle) {
    const Real3 axis = real(manipulator.chain.joints[manipulator.turning].axis_W);
    const Real angle = turnAbout(axis, stylus[2], tip.R_WT[2]);
    twice += weightAbout(axis, stylus[2]) * manipulator.ko_N_m_per_rad * angle * angle;
  }
  for (std::size_t i = 0; i < theta.size(); ++i) {
    const Real bent = theta[i] - manipulator.rest[i];
    twice += manipulator.spring[i] * bent * bent;
  }
  return twice / 2;
}

Real slopeOf(const manipulator::Manipulator& manipulator, const Pose& X_WT, std::vector<Real> theta,
             std::size_t joint) {
  const Real tiny = ldexp(Real(1), -110), middle = theta[joint];
  theta[joint] = middle + tiny;
  const Real after = energyOf(manipulator, X_WT, theta);
  theta[joint] = middle - tiny;
  return (after - energyOf(manipulator, X_WT, theta)) / (2 * tiny);
}

}  // namespace underact::error_bounds::oracle
