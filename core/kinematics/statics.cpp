#include "core/kinematics/statics.h"

#include "core/arm/gravity.h"
#include "core/base/units.h"
#include "core/chain/kinematics.h"
#include "core/chain/statics.h"
#include "core/kinematics/units.h"

namespace underact::kinematics {
namespace {

constexpr double kGravity_m_per_s2 = 9.80665;

std::vector<double> inNewtonMillimetres(const SolvedArm& arm, std::vector<double> torques) {
  for (std::size_t i = 0; i < torques.size(); ++i) {
    if (turns(arm.chain().joints[i])) torques[i] *= kMillimetrePerMetre;
  }
  return torques;
}

}  // namespace

std::vector<bool> drivenOf(const SolvedArm& arm) {
  std::vector<bool> driven;
  for (const arm::JointFacts& facts : arm.model.joints) driven.push_back(facts.driven);
  return driven;
}

Statics staticsOf(const SolvedArm& arm, const chain::JointValues& q, const Vec3& f_N, const Vec3& moment_N_mm) {
  const std::span<const double> joints = std::span(q).first(arm.joints());
  const chain::Jacobian J = chain::jacobian(arm.chain(), joints);
  Vec6 wrench;
  wrench << f_N, kMetrePerMillimetre * moment_N_mm;
  const chain::Ellipsoid ellipsoid = chain::positionEllipsoid(J, drivenOf(arm));
  Statics found;
  found.torque = inNewtonMillimetres(arm, chain::torquesOf(J, wrench));
  // The workspace of a haptic arm has y up; another robot stands in a frame with z up.
  const Vec3 down_m_per_s2 = -kGravity_m_per_s2 * (arm.model.device ? Vec3::UnitY() : Vec3::UnitZ());
  found.holding = inNewtonMillimetres(arm, arm::holdingTorques(arm.model, joints, down_m_per_s2));
  for (std::size_t i = 0; i < 3; ++i) {
    found.gains_mm[i] = kMillimetrePerMetre * ellipsoid.gain[i];
    found.axes_W.row(static_cast<Eigen::Index>(i)) = ellipsoid.axis_W[i].transpose();
  }
  return found;
}

}  // namespace underact::kinematics
