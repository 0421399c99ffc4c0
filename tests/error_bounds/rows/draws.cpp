#include "tests/error_bounds/rows/draws.h"

#include "core/base/norms.h"

namespace underact::error_bounds {
namespace {

using chain::Joint;
using chain::JointType;
using manipulator::Manipulator;
using manipulator::Orientation;

double sizeOf(const Manipulator& m) {
  double size_m = m.chain.X_WT_home.translation().cwiseAbs().maxCoeff();
  for (const Joint& joint : m.chain.joints) size_m = std::max(size_m, joint.p_WJ.cwiseAbs().maxCoeff());
  return size_m;
}

/// Gains, and that of the orientation relative to the position's: of the same weight, or 0.
void drawGains(Input& input, double size_m, manipulator::Wanted& wanted) {
  const double kp = input.number("kp_N_per_m", [](Dice& dice) { return dice.one(8) ? 0.0 : dice.power(-20, 20); });
  wanted.kp_N_per_m.setConstant(kp);
  wanted.ko_N_m_per_rad = input.number("ko_N_m_per_rad", [&](Dice& dice) {
    return dice.one(4) ? 0.0 : std::max(kp, 1e-6) * size_m * size_m * dice.ratio();
  });
}

}  // namespace

chain::Chain drawChain(Input& input, std::size_t max, int size) {
  const std::size_t count = 1 + input.choice("joints", max);
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
  for (double& angle_rad : std::span(q_rad).first<6>())
    angle_rad = input.number("q_rad", [](Dice& dice) { return dice.angle(); });
  return q_rad;
}

Manipulator drawManipulator(Input& input, int size) {
  manipulator::Wanted wanted;
  wanted.chain = drawChain(input, manipulator::kMaxJoints, size);
  const double size_m = std::max(wanted.chain.X_WT_home.translation().cwiseAbs().maxCoeff(), 1e-12);
  constexpr std::array<Orientation, 3> kWhich{Orientation::None, Orientation::Axis, Orientation::Full};
  wanted.orientation = kWhich[input.choice("orientation", kWhich.size())];
  drawGains(input, size_m, wanted);
  if (input.flag("unequal"))
    wanted.kp_N_per_m.y() =
        input.number("kp_y_N_per_m", [&](Dice& dice) { return wanted.kp_N_per_m.x() * dice.share(); });
  if (input.flag("bends")) {
    for (std::size_t i = 0; i < wanted.chain.joints.size(); ++i) {
      const bool turns = wanted.chain.joints[i].type == JointType::Revolute;
      wanted.spring[i] = input.number(
          "spring", [&](Dice& dice) { return wanted.kp_N_per_m.x() * (turns ? size_m * size_m : 1.0) * dice.ratio(); });
      wanted.rest[i] = input.number("rest", [&](Dice& dice) { return (turns ? 1.0 : size_m) * dice.between(-1, 1); });
    }
  }
  wanted.method = manipulator::Method::Iterative;
  return manipulator::makeManipulator(wanted, {}).value();
}

Manipulator drawClosedManipulator(Input& input) {
  manipulator::Wanted wanted;
  const double size_m = input.number("size_m", [](Dice& dice) { return dice.scale(); });
  const std::size_t kind = input.choice("kind", 5);  // circle, sphere, cylinder, line, plane
  const Mat3 R = input.matrix("R", [](Dice& dice) { return dice.turn(); });
  // A sphere's z counts as along its radius up to 1e-9; here it is exact to some ulp.
  const Vec3 p_WC = input.vector("p_WC", [&](Dice& dice) {
    return dice.one(2) ? Vec3(Vec3::Zero()) : dice.inBox(size_m * (kind == 1 ? 2.0 : dice.ratio()));
  });
  const auto joint = [&](JointType type, Eigen::Index axis) { return Joint{type, R.col(axis), p_WC}; };
  if (kind == 0) wanted.chain.joints = {joint(JointType::Revolute, 2)};
  if (kind == 1) wanted.chain.joints = {joint(JointType::Revolute, 2), joint(JointType::Revolute, 1)};
  if (kind == 2) wanted.chain.joints = {joint(JointType::Revolute, 2), joint(JointType::Prismatic, 2)};
  if (kind == 3) wanted.chain.joints = {joint(JointType::Prismatic, 2)};
  if (kind == 4) wanted.chain.joints = {joint(JointType::Prismatic, 2), joint(JointType::Prismatic, 0)};
  wanted.chain.X_WT_home.translation() = p_WC + size_m * R.col(0);
  wanted.chain.X_WT_home.linear() << R.col(1), R.col(2), R.col(0);  // z of V along the radius
  const bool turning = kind < 3;
  wanted.orientation = turning && input.flag("axis") ? Orientation::Axis : Orientation::None;
  drawGains(input, size_m, wanted);
  if (kind != 1 && input.choice("limits", 3) == 0) {
    for (Joint& one : wanted.chain.joints) {
      const double unit = one.type == JointType::Revolute ? 1.0 : size_m;
      one.min = input.number("min", [&](Dice& dice) { return unit * dice.between(-3.0, 1.0); });
      one.max = input.number("max", [&](Dice& dice) { return one.min + unit * dice.between(0.1, 3.0); });
    }
  }
  return manipulator::makeManipulator(wanted, {}).value();
}

Pose drawStylus(Input& input, const Manipulator& m) {
  Pose X_WT = Pose::Identity();
  const double size_m = std::max(sizeOf(m), 1e-12);
  X_WT.translation() = input.vector("p_WT", [&](Dice& dice) {
    if (dice.one(6)) return Vec3(m.chain.X_WT_home.translation());
    return dice.oddPointAbout(m.chain.joints[0].p_WJ, m.chain.joints[0].axis_W, size_m);
  });
  X_WT.linear() =
      input.matrix("R_WT", [&](Dice& dice) { return dice.one(6) ? Mat3(m.chain.X_WT_home.linear()) : dice.turn(); });
  return X_WT;
}

manipulator::Values drawTheta(Input& input, const Manipulator& m) {
  manipulator::Values theta{};
  const std::vector<double> q = drawJoints(input, m.chain);
  std::copy(q.begin(), q.end(), theta.begin());
  return theta;
}

Signal drawSignal(Input& input, int count) {
  const double rate_hz = input.number("rate_hz", [](Dice& dice) { return std::min(dice.power(0, 17), 1e5); });
  const double size = input.number("size", [](Dice& dice) { return dice.one(2) ? dice.power(-14, -3) : dice.scale(); });
  const double offset =
      input.number("offset", [&](Dice& dice) { return dice.one(2) ? 0.0 : size * dice.power(0, 20); });
  const double tremble = input.number("tremble", [](Dice& dice) { return dice.one(2) ? 0.0 : dice.between(0.0, 0.5); });
  const bool stands = input.choice("stands", 4) == 0;
  Dice dice(static_cast<std::uint64_t>(
      input.number("walk", [](Dice& drawn) { return static_cast<double>(drawn.below(std::size_t{1} << 40U)); })));
  Signal signal;
  Vec3 e_W = Vec3::Constant(offset);
  for (int i = 0; i < count; ++i) {
    if (!(stands && dice.one(2))) e_W += size * dice.inBox(dice.one(16) ? 16.0 : 1.0);
    if (dice.one(32)) e_W[static_cast<Eigen::Index>(dice.below(3))] = offset == 0.0 ? 5e-324 : offset;
    const double dt_s = (1.0 + tremble * dice.between(-1.0, 1.0)) / rate_hz;
    signal.dt_s.push_back(i == 0 || dice.one(64) ? 0.0 : dt_s);
    signal.e_W.push_back(e_W);
  }
  return signal;
}

}  // namespace underact::error_bounds
