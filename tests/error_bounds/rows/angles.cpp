#include <array>
#include <optional>

#include "core/base/norms.h"
#include "core/manipulator/energy.h"
#include "core/manipulator/thesis_law.h"
#include "tests/error_bounds/oracle/energy.h"
#include "tests/error_bounds/rows/draws.h"
#include "tests/error_bounds/rows/rows.h"

// The stylus's angle about a joint's axis: in the energy, and in the thesis's own force law.
namespace underact::error_bounds {
namespace angles_rows {

using chain::Joint;
using chain::JointType;
using manipulator::Manipulator;

constexpr double kSteepestBlend = 17.2;  // of the weight over 5 degrees: 1.5 / (pi / 36)

/// A robot with one revolute joint, with prismatic ones before and after it; none where it is refused.
struct Drawn {
  std::optional<Manipulator> made;
  Outcome refused;  // right where z of V lies along the axis
};
Drawn drawTurning(Input& input, std::size_t max_slides, manipulator::ForceLaw law) {
  manipulator::Wanted wanted;
  wanted.law = law;
  const double size_m = input.number("size_m", [](Dice& dice) { return dice.scale(); });
  const std::size_t count = 1 + (max_slides > 0 ? input.choice("slides", max_slides + 1) : 0);
  const std::size_t turning = count > 1 ? input.choice("turning", count) : 0;
  for (std::size_t i = 0; i < count; ++i) {
    const Vec3 axis_W = input.vector("axis_W", [](Dice& dice) { return dice.direction(); });
    const Vec3 p_WJ = input.vector("p_WJ", [&](Dice& dice) { return Vec3(size_m * dice.inBox(dice.ratio())); });
    wanted.chain.joints.push_back({i == turning ? JointType::Revolute : JointType::Prismatic, axis_W, p_WJ});
  }
  const Joint& joint = wanted.chain.joints[turning];
  wanted.chain.X_WT_home.translation() = input.vector("p_WV", [&](Dice& dice) {
    if (dice.one(4)) return dice.oddPointAbout(joint.p_WJ, joint.axis_W, size_m);
    return Vec3(joint.p_WJ + size_m * dice.ratio() * dice.direction());
  });
  wanted.chain.X_WT_home.linear() = input.matrix("R_WV", [](Dice& dice) { return dice.turn(); });
  const double kp = input.number("kp_N_per_m", [](Dice& dice) { return dice.one(8) ? 0.0 : dice.power(-20, 20); });
  wanted.kp_N_per_m.setConstant(kp);
  wanted.ko_N_m_per_rad =
      input.number("ko_N_m_per_rad", [&](Dice& dice) { return std::max(kp, 1e-6) * size_m * size_m * dice.ratio(); });
  wanted.orientation = manipulator::Orientation::Angle;
  wanted.method = manipulator::Method::Iterative;
  const Result<Manipulator> made = manipulator::makeManipulator(wanted, {});
  const double across = wanted.chain.X_WT_home.linear().col(2).cross(joint.axis_W).norm();
  if (!made) return {{}, {across < 1.001e-6 ? 0.0 : kInfinity, true}};
  return {made.value(), {}};
}

/// The uncertainty of an angle between directions about an axis, in ulp: it grows as a component across it shrinks.
Real lostAbout(const Real3& axis, const Real3& direction) {
  return norm(direction) / norm(without(direction, axis));
}

struct Turned {
  Real angle = 0, weight = 0;
  Real lost = 0;        // ulp of weight times angle
  bool is_tie = false;  // half a turn: either way round
};
/// z_V: of the tip. aside: further uncertainty of the angle, in ulp.
Turned turnedBy(const Manipulator& m, const Real3& z_V, const Real3& z_T, const Real& aside) {
  const Real3 axis = unit(real(m.chain.joints[m.turning].axis_W));
  Turned turned{oracle::turnAbout(axis, z_T, z_V), oracle::weightAbout(axis, z_T)};
  const Real angle_lost = aside + 2 * piReal() + lostAbout(axis, z_V) + lostAbout(axis, z_T);
  turned.lost = turned.weight * angle_lost + piReal() * kSteepestBlend;
  turned.is_tie = abs(turned.angle) > piReal() - ldexp(angle_lost, -48);
  return turned;
}

/// A stylus whose z is along the axis except for 2^-k, within the blend, or anywhere.
Pose drawTurnedStylus(Input& input, const Manipulator& m) {
  const Vec3 axis_W = m.chain.joints[m.turning].axis_W;
  Pose X_WT = Pose::Identity();
  X_WT.translation() = input.vector("p_WT", [&](Dice& dice) {
    const double size_m = std::max(largestOf(m.chain.X_WT_home.translation()), 1e-150);
    return dice.oddPointAbout(m.chain.joints[m.turning].p_WJ, axis_W, size_m);
  });
  const Vec3 z_W = input.vector("z_WT", [&](Dice& dice) -> Vec3 {
    if (dice.one(3)) return (dice.sign() * axis_W + dice.closeness() * referencePerpendicular(axis_W)).normalized();
    if (dice.one(3)) return (dice.sign() * axis_W + 0.1 * dice.inBox(1.0)).normalized();
    return dice.direction();
  });
  const Vec3 x_W = referencePerpendicular(z_W);
  X_WT.linear() << x_W, z_W.cross(x_W), z_W;
  return X_WT;
}

Outcome judgeAngle(Input& input) {
  const Drawn drawn = drawTurning(input, 3, manipulator::ForceLaw::Energy);
  if (!drawn.made) return drawn.refused;
  const Manipulator& m = *drawn.made;
  const Pose X_WT = drawTurnedStylus(input, m);
  manipulator::Values theta{};
  const std::vector<double> q = drawJoints(input, m.chain);
  std::copy(q.begin(), q.end(), theta.begin());
  manipulator::Energy at;
  asTheServo([&] {
    evaluate(m, X_WT, theta, at);
    return 0;
  });
  const std::vector<Real> joints(q.begin(), q.end());
  const Turned turned = turnedBy(m, oracle::chainPose(m.chain, joints).R_WT[2], real(X_WT.linear().col(2)),
                                 Real(std::abs(theta[m.turning])));
  if (turned.is_tie) return {std::isfinite(at.energy_J) ? 0.0 : kInfinity, true};
  Real length = largestOf(X_WT.translation()), turn = 1 + Real(std::abs(theta[m.turning]));
  length += largestOf(m.chain.X_WT_home.translation()) + largestOf(m.chain.joints[m.turning].p_WJ);
  for (std::size_t i = 0; i < joints.size(); ++i) length += i == m.turning ? Real(0) : Real(abs(joints[i]));
  const Real place = Real(largestOf(m.kp_N_per_m)) * length * length * turn;
  const Real moment = Real(m.ko_N_m_per_rad) * turned.lost;
  double worst = ulpsOf(at.energy_J, oracle::energyOf(m, X_WT, joints), place + piReal() * moment);
  for (std::size_t i = 0; i < joints.size(); ++i) {
    const Real scale = i == m.turning ? Real(place + moment) : Real(place / length);
    worst = std::max(worst, ulpsOf(at.slope[i], oracle::slopeOf(m, X_WT, joints, i), scale));
  }
  return {worst, false};
}

/// By the angle between the radius of the tip and the position of the stylus: no cosine, no reference direction.
Outcome judgeThesis(Input& input) {
  const Drawn drawn = drawTurning(input, 0, manipulator::ForceLaw::Thesis52);
  if (!drawn.made) return drawn.refused;
  const Manipulator& m = *drawn.made;
  const Pose X_WT = drawTurnedStylus(input, m);
  const manipulator::ThesisPull got = asTheServo([&] { return thesisPull(m, X_WT); });
  const Joint& joint = m.chain.joints[0];
  const Vec3 p_WV = m.chain.X_WT_home.translation(), p_WT = X_WT.translation();
  const Real3 axis = unit(real(joint.axis_W)), pivot = real(joint.p_WJ);
  const Real3 home = real(p_WV) - pivot, radial = without(real(p_WT) - pivot, axis);
  const Real off = norm(radial), length = norm(home), home_off = norm(without(home, axis));
  const Real place = std::max(largestOf(joint.p_WJ), largestOf(p_WT)),
             rest = std::max(largestOf(joint.p_WJ), largestOf(p_WV));
  if (!got.p_WP.allFinite() || !got.f_along_T_W.allFinite() || !got.moment_W.allFinite()) return {kInfinity, false};
  if (!got.is_unique)  // on the axis, within the rounding of coordinates
    return {off <= ldexp(place, -47) + 1e-300 || home_off <= ldexp(rest, -47) + 1e-300 ? 0.0 : kInfinity, true};
  if (home_off <= ldexp(rest, -50) || off <= ldexp(place, -50)) return {0.0, true};
  const Real by_place = place / off, by_home = rest / home_off;
  const Real theta = oracle::turnAbout(axis, home, radial);
  const Real3 z_V = oracle::turned(oracle::about(axis, theta), real(m.chain.X_WT_home.linear().col(2)));
  const Turned turned = turnedBy(m, z_V, real(X_WT.linear().col(2)), by_place + by_home);
  const auto off_by_turns = [](double got_rad, const Real& right) {
    const Real apart = Real(got_rad) - right;
    return Real(apart - 2 * piReal() * floor(Real(apart / (2 * piReal()) + Real(0.5))));
  };
  double worst = ulpsOf(off_by_turns(got.theta_rad, theta), 2 * piReal() + by_place + by_home);
  worst = std::max(worst, ulpsOf(got.p_WP, pivot + Real(length / off) * radial, place + rest + length * by_place));
  if (turned.is_tie) return {worst, false};
  const Real moment = Real(m.ko_N_m_per_rad) * turned.weight * turned.angle;
  const Real lost = Real(m.ko_N_m_per_rad) * turned.lost;
  const Real3 tangent = Real(1 / off) * cross(axis, radial);
  worst = std::max(worst, ulpsOf(got.moment_W, moment * axis, lost));
  worst = std::max(worst, ulpsOf(got.f_along_T_W, Real(-moment / length) * tangent,
                                 (lost + abs(moment) * (by_place + rest / length)) / length));
  return {worst, false};
}

constexpr std::array<Row, 2> kRows{{
    {"robot_angle", Kind::Solver,
     "Energy of a virtual robot that follows the stylus's angle about its joint, and its gradient",
     "ulp of kp times all lengths squared, times the angle; of ko times (weight times all angles and one over what is "
     "across the axis, and 54)",
     16, 30, judgeAngle},
    {"robot_thesis", Kind::Solver, "Force law of the thesis's code 5.2: position, angle, tangential pull, moment",
     "ulp of positions, of L and the angles times (largest coordinate / off the axis); of the force the same over L",
     16, 2, judgeThesis},
}};

}  // namespace angles_rows

constinit const std::span<const Row> kAngleRows = angles_rows::kRows;

}  // namespace underact::error_bounds
