#include "core/arm/apparent_mass.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "core/arm/inverse.h"
#include "core/chain/kinematics.h"

namespace underact::arm {
namespace {

constexpr std::size_t kFree = 3;  // joints: those that a hand at the tip moves

/// The inertia of the links in the first joints, the others held.
Mat3 inertiaOf(const Model& model, const JointAngles& q_rad) {
  const chain::Chain& chain = model.chain;
  std::vector<Pose> links(chain.joints.size(), Pose::Identity());
  chain::forward(chain, q_rad, links);
  Mat3 M = Mat3::Zero();
  for (std::size_t link = 0; link < links.size(); ++link) {
    const LinkMass& mass = model.masses[link];
    const Mat3& R = links[link].linear();
    const Vec3 p_WC = links[link] * mass.p_WC;
    Mat3 v_W = Mat3::Zero(), w_W = Mat3::Zero();  // of the centre and of the link, for each joint's rate
    for (std::size_t joint = 0; joint < std::min(kFree, link + 1); ++joint) {
      const Vec3 axis_W = links[joint].linear() * chain.joints[joint].axis_W;
      const auto column = static_cast<Eigen::Index>(joint);
      v_W.col(column) = axis_W.cross(p_WC - links[joint] * chain.joints[joint].p_WJ);
      w_W.col(column) = axis_W;
    }
    M += mass.mass_kg * v_W.transpose() * v_W + w_W.transpose() * (R * mass.inertia_W_kg_m2 * R.transpose()) * w_W;
  }
  return M;
}

}  // namespace

double apparentMass_kg(const Model& model) {
  const std::optional<Geometry> geometry = omniGeometry(model);
  if (!geometry || model.masses.size() != 6) return 0.0;
  const JointAngles middle_rad = withinLimits(limitsOf(model), dhFromDevice({}));
  JointAngles q_rad = middle_rad;
  const JointAngles reached_rad = withinLimits(limitsOf(model), solvePosition(*geometry, Vec3::Zero()).q_rad);
  std::copy_n(reached_rad.begin(), kFree, q_rad.begin());
  const Mat3 J_p = chain::jacobian(model.chain, q_rad).topLeftCorner<3, 3>();
  const Mat3 inverse = J_p.inverse();
  const double mass_kg = (inverse.transpose() * inertiaOf(model, q_rad) * inverse).trace() / 3.0;
  return std::isfinite(mass_kg) && mass_kg > 0.0 ? mass_kg : 0.0;
}

}  // namespace underact::arm
