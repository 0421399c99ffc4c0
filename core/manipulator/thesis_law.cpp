#include "core/manipulator/thesis_law.h"

#include "core/base/axis_geometry.h"
#include "core/manipulator/energy.h"

namespace underact::manipulator {

ThesisPull thesisPull(const Manipulator& m, const Pose& X_WT) noexcept {
  const chain::Joint& joint = m.chain.joints[0];
  const Vec3& axis_W = joint.axis_W;
  const Vec3 p_JV_W = m.chain.X_WT_home.translation() - joint.p_WJ, home_W = perpendicularPart(axis_W, p_JV_W);
  const Vec3 radial_W = perpendicularPart(axis_W, X_WT.translation() - joint.p_WJ);
  const double length_m = p_JV_W.norm(), off_m = radial_W.norm();
  ThesisPull pull;
  pull.p_WP = X_WT.translation();
  if (!(home_W.norm() > 0.0) || off_m <= 8 * 0x1p-52 * (joint.p_WJ.norm() + X_WT.translation().norm())) return pull;
  const Vec3 n_W = radial_W / off_m, t_W = axis_W.cross(n_W), z_W = X_WT.linear().col(2);
  pull.is_unique = true;
  pull.theta_rad = wrapped(angleAround(axis_W, n_W) - angleAround(axis_W, home_W));
  pull.error_rad = wrapped(pull.theta_rad + m.home_rad - angleAround(axis_W, z_W));
  const double pulled_N_m = weightOfAngle(axis_W, z_W) * m.ko_N_m_per_rad * pull.error_rad;
  pull.p_WP = joint.p_WJ + length_m * n_W;
  pull.f_along_T_W = -(pulled_N_m / length_m) * t_W;
  pull.moment_W = pulled_N_m * axis_W;
  return pull;
}

}  // namespace underact::manipulator
