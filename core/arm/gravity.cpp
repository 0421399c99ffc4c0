#include "core/arm/gravity.h"

#include "core/chain/kinematics.h"

namespace underact::arm {

std::vector<double> holdingTorques(const Model& model, std::span<const double> q, const Vec3& gravity_W) {
  if (model.masses.empty()) return {};
  const chain::Chain& chain = model.chain;
  std::vector<Pose> links(chain.joints.size(), Pose::Identity());  // the displacement of each since home
  chain::forward(chain, q, links);
  std::vector<double> torques(chain.joints.size(), 0.0);
  for (std::size_t link = 0; link < links.size(); ++link) {
    const Vec3 weight_W = model.masses[link].mass_kg * gravity_W, p_WC = links[link] * model.masses[link].p_WC;
    for (std::size_t i = 0; i <= link; ++i) {
      const Pose& X = links[i];  // a joint's own motion leaves its axis where it is
      const Vec3 axis_W = X.linear() * chain.joints[i].axis_W;
      const bool turns = chain.joints[i].type == chain::JointType::Revolute;
      const Vec3 moves_W = turns ? Vec3(axis_W.cross(p_WC - X * chain.joints[i].p_WJ)) : axis_W;
      torques[i] -= moves_W.dot(weight_W);
    }
  }
  return torques;
}

}  // namespace underact::arm
