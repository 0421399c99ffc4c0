#include <array>
#include <vector>

#include "core/arm/follower.h"
#include "core/arm/inverse.h"
#include "core/base/norms.h"
#include "core/base/trig.h"
#include "core/base/units.h"
#include "tests/error_bounds/oracle/arm.h"
#include "tests/error_bounds/rows/draws.h"
#include "tests/error_bounds/rows/rows.h"

namespace underact::error_bounds {
namespace arm_solvers_rows {

// Arms of 1 cm to 100 m, since the tolerances for "in line" and "on axis 1" are in m.
constexpr int kArmSize = 7;

Real reachOf(const arm::Geometry& geometry) {
  return Real(geometry.upper_m) + geometry.fore_m;
}
Real placeScale(const arm::Geometry& geometry, const Vec3& p_WT) {
  return reachOf(geometry) + std::max(largestOf(geometry.p_WB), largestOf(p_WT));
}

/// A position inside the reach, on its boundary except for 2^-k, near axis 1, or anywhere.
Vec3 drawPlace(Input& input, const arm::Geometry& geometry) {
  return input.vector("p_WT", [&](Dice& dice) {
    const double outer_m = geometry.upper_m + geometry.fore_m, inner_m = std::abs(geometry.upper_m - geometry.fore_m);
    const Vec3 up_W = Vec3::UnitY();
    switch (dice.below(5)) {
      case 0:
        return Vec3(geometry.p_WB + outer_m * (1.0 + dice.closeness()) * dice.direction());
      case 1:
        return Vec3(geometry.p_WB + inner_m * (1.0 + dice.closeness()) * dice.direction());
      case 2:
        return dice.oddPointAbout(geometry.p_WB, up_W, outer_m);
      default:
        return Vec3(geometry.p_WB + dice.between(inner_m, outer_m) * dice.direction());
    }
  });
}

/// Near the shoulder the elbow is folded, and an ulp of reach^2 is many ulp of a short distance.
Real foldedScale(const arm::Geometry& geometry, const Vec3& p_WT) {
  const Real away = norm(real(p_WT) - real(geometry.p_WB)), reach = reachOf(geometry);
  return placeScale(geometry, p_WT) + (away > 0 ? Real(reach * reach / away) : Real(0));
}

double placeUlps(const arm::Geometry& geometry, const arm::JointAngles& q_rad, const Vec3& p_WT, const Real& lost = 0) {
  for (const double angle_rad : q_rad) {
    if (!std::isfinite(angle_rad)) return kInfinity;
  }
  const Real3 got = oracle::armPose(geometry, oracle::realOf(q_rad)).p_WT;
  const Real off = norm(got - real(p_WT));
  return ulpsOf(off > lost ? Real(off - lost) : Real(0), foldedScale(geometry, p_WT));
}

/// Whether the position can be reached for certain, or certainly cannot.
enum class Reachable { Yes, No, OnTheEdge };
Reachable reachable(const arm::Geometry& geometry, const Vec3& p_WT, const Real& band) {
  const Real away = norm(real(p_WT) - real(geometry.p_WB)), outer = reachOf(geometry);
  const Real inner = abs(Real(geometry.upper_m) - geometry.fore_m);
  if (away > outer + band || away < inner - band) return Reachable::No;
  return away < outer - band && away > inner + band ? Reachable::Yes : Reachable::OnTheEdge;
}

Outcome judgeReach(Input& input) {
  const arm::Geometry geometry = drawArm(input);
  const Vec3 p_WT = drawPlace(input, geometry);
  const arm::PositionSolution got = asTheServo([&] { return arm::solvePosition(geometry, p_WT); });
  const Reachable right = reachable(geometry, p_WT, ldexp(foldedScale(geometry, p_WT), -46));
  if (got.reachable && right == Reachable::No) return {kInfinity, false};
  if (!got.reachable) {
    for (const double angle_rad : got.q_rad) {
      if (!std::isfinite(angle_rad)) return {kInfinity, false};
    }
    const Real3 away = real(p_WT) - real(geometry.p_WB);
    const bool on_axis = sqrt(away.x * away.x + away.z * away.z) <= ldexp(placeScale(geometry, p_WT), -50);
    return {right == Reachable::Yes && !on_axis ? kInfinity : 0.0, true};
  }
  return {placeUlps(geometry, got.q_rad, p_WT), false};
}

/// A pose of given joints, and those joints: near all singularities.
struct Posed {
  Pose X_WT = Pose::Identity();
};
Posed drawPose(Input& input, const arm::Geometry& geometry) {
  Posed posed;
  posed.X_WT.translation() = drawPlace(input, geometry);
  posed.X_WT.linear() = input.matrix("R_WT", [&](Dice& dice) {
    if (dice.one(2)) return dice.turn();
    // The wrist in line except for 2^-k: along the forearm, at the joints that reach the position.
    const arm::JointAngles q_rad = arm::solvePosition(geometry, posed.X_WT.translation()).q_rad;
    const SinCos turret = sinCos(q_rad[0]), shin = sinCos(q_rad[1] + q_rad[2]);
    const Vec3 along_W(turret.sin * shin.sin, -shin.cos, turret.cos * shin.sin);
    const Vec3 z_W = Vec3(dice.sign() * along_W + dice.closeness() * referencePerpendicular(along_W)).normalized();
    Mat3 R;
    const Vec3 x_W = referencePerpendicular(z_W);
    R << x_W, z_W.cross(x_W), z_W;
    return R;
  });
  return posed;
}

Outcome judgeSolveAll(Input& input) {
  const arm::Geometry geometry = drawArm(input, kArmSize);
  const Pose X_WT = drawPose(input, geometry).X_WT;
  const arm::Solutions got = asTheServo([&] { return arm::solveAll(geometry, arm::kNoJointLimits, X_WT); });
  const Vec3 p_WT = X_WT.translation();
  const Reachable right = reachable(geometry, p_WT, 2 * arm::kOnBoundary * reachOf(geometry));
  if (got.reachable != (got.count > 0)) return {kInfinity, false};
  if (!got.reachable) return {right == Reachable::Yes ? kInfinity : 0.0, true};
  if (right == Reachable::No) return {kInfinity, false};
  // On the boundary, and slightly outside, as near as the arm gets; near a singularity within twice the 1e-12 below
  // which a direction counts as undefined.
  const Real away = norm(real(p_WT) - real(geometry.p_WB)), outer = reachOf(geometry);
  const Real inner = abs(Real(geometry.upper_m) - geometry.fore_m);
  const Real beyond = std::max({Real(away - outer), Real(inner - away), Real(0)});
  const oracle::Columns R_WT = oracle::columnsOf(X_WT.linear());
  double worst = 0.0;
  for (const arm::Solution& one : got) {
    for (const double angle_rad : one.q_rad) {
      if (!std::isfinite(angle_rad)) return {kInfinity, false};
    }
    const oracle::ArmPose pose = oracle::armPose(geometry, oracle::realOf(one.q_rad));
    const Real off = norm(pose.p_WT - real(p_WT)) - beyond, turned = oracle::angleOf(pose.R_WT, R_WT);
    const Real lost = Real(2e-12);
    const Real place_off = off > lost ? Real(off - lost) : Real(0),
               turn_off = turned > lost ? Real(turned - lost) : Real(0);
    worst = std::max({worst, ulpsOf(place_off, foldedScale(geometry, p_WT)), ulpsOf(turn_off, 1)});
  }
  return {worst, got.singular()};
}

/// A path of the tip through and near singularities; the joints of each step bring it to its position.
Outcome judgeFollower(Input& input) {
  const arm::Geometry geometry = drawArm(input, kArmSize);
  const auto outer_m = static_cast<double>(reachOf(geometry));
  const Vec3 from_W = input.vector("from", [](Dice& dice) { return dice.inBox(0.7); });
  const Vec3 to_W = input.vector("to", [](Dice& dice) {
    Vec3 place = dice.inBox(0.7);
    if (dice.one(2)) place.x() = place.z() = dice.closeness();
    return place;
  });
  arm::FollowerState state;
  state.q_rad = arm::JointAngles{0.1, 0.9, -0.3, 0.0, 1.0, 0.0};
  double worst = 0.0;
  bool off_reach = false;
  constexpr int kSteps = 16;
  for (int step = 0; step <= kSteps; ++step) {
    const Vec3 p_WT = geometry.p_WB + outer_m * (from_W + (static_cast<double>(step) / kSteps) * (to_W - from_W));
    const arm::Followed got = asTheServo([&] { return arm::followPosition(geometry, state, p_WT); });
    state = got.next;
    if (!got.reachable) {
      off_reach = true;
      for (const double angle_rad : state.q_rad) {
        if (!std::isfinite(angle_rad)) return {kInfinity, false};
      }
      if (reachable(geometry, p_WT, ldexp(foldedScale(geometry, p_WT), -46)) == Reachable::Yes &&
          (p_WT - geometry.p_WB).cwiseProduct(Vec3(1, 0, 1)).norm() > 1e-6 * outer_m)
        return {kInfinity, false};
      continue;
    }
    // On axis 1 joint 1 stays, and the tip is on the other side of the axis at worst.
    const Vec3 from_base = p_WT - geometry.p_WB;
    const bool on_axis = std::hypot(from_base.x(), from_base.z()) <= 1.01 * arm::kSingularDistance_m;
    worst = std::max(worst, placeUlps(geometry, state.q_rad, p_WT, on_axis ? 2.02 * arm::kSingularDistance_m : 0.0));
  }
  return {worst, off_reach};
}

constexpr std::array<Row, 3> kRows{{
    {"arm_reach", Kind::Solver, "Joints 1 to 3 for a position, there and back",
     "ulp of the reach, the positions, and reach^2 / distance from the shoulder", 16, 1, judgeReach},
    {"arm_inverse", Kind::Solver,
     "All joints of arms of 1 cm to 100 m for a pose, there and back, near every singularity",
     "ulp of the same, and of 1 rad; 2e-12 m and rad beside that, where a direction counts for none", 32, 20,
     judgeSolveAll},
    {"arm_follower", Kind::Solver, "Joints along a path through singularities, there and back",
     "ulp of the same; 2e-6 m beside that within 1e-6 m of axis 1, where joint 1 stays", 32, 80, judgeFollower},
}};

}  // namespace arm_solvers_rows

constinit const std::span<const Row> kArmSolverRows = arm_solvers_rows::kRows;

}  // namespace underact::error_bounds
