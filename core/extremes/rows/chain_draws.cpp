#include "core/extremes/rows/chain_draws.h"

#include "core/base/norms.h"

namespace underact::extremes {

chain::Chain drawChain(Input& input, std::size_t most, int size) {
  const std::size_t count = 1 + input.choice("joints", most);
  const double size_m = input.number("size_m", [&](Dice& dice) { return dice.power(-size, size); });
  chain::Chain chain;
  for (std::size_t i = 0; i < count; ++i) {
    chain::Joint joint;
    joint.type = input.choice("slides", 2, [](Dice& dice) { return dice.one(4) ? 1U : 0U; }) == 1
                     ? chain::JointType::Prismatic
                     : chain::JointType::Revolute;
    joint.axis_W = input.vector("axis_W", [&](Dice& dice) {
      return i > 0 && dice.one(3) ? Vec3(dice.sign() * chain.joints[i - 1].axis_W) : dice.direction();
    });
    joint.p_WJ = input.vector("p_WJ", [&](Dice& dice) {
      if (i > 0 && dice.one(4)) return chain.joints[i - 1].p_WJ;
      return Vec3(size_m * dice.inBox(dice.one(4) ? dice.power(-20, 1) : 1.0));
    });
    chain.joints.push_back(joint);
  }
  chain.X_WT_home.translation() = input.vector("p_WT", [&](Dice& dice) { return dice.inBox(size_m); });
  chain.X_WT_home.linear() = input.matrix("R_WT", [](Dice& dice) { return dice.turn(); });
  return chain;
}

std::vector<double> drawJoints(Input& input, const chain::Chain& chain) {
  double size_m = largestOf(chain.X_WT_home.translation());
  for (const chain::Joint& joint : chain.joints) size_m = std::max(size_m, largestOf(joint.p_WJ));
  std::vector<double> q;
  for (const chain::Joint& joint : chain.joints) {
    const bool slides = joint.type == chain::JointType::Prismatic;
    q.push_back(
        input.number("q", [&](Dice& dice) { return slides ? size_m * dice.between(-1.0, 1.0) : dice.angle(); }));
  }
  return q;
}

}  // namespace underact::extremes
