#include <array>

#include "core/base/norms.h"
#include "core/manipulator/closed_form.h"
#include "core/manipulator/descend.h"
#include "tests/error_bounds/oracle/energy.h"
#include "tests/error_bounds/rows/draws.h"
#include "tests/error_bounds/rows/rows.h"

namespace underact::error_bounds {
namespace manipulators_rows {

using manipulator::Energy;
using manipulator::Manipulator;
using manipulator::Orientation;

std::vector<Real> realOf(const Manipulator& m, const manipulator::Values& theta) {
  return {theta.begin(), theta.begin() + static_cast<std::ptrdiff_t>(m.chain.joints.size())};
}

/// The scales of errors: a length (all lengths involved, times the effect of the angles' rounding), the energy and its
/// gradient.
struct Sizes {
  Real length, turn, energy, springs;
  Real slope(bool turns) const { return turns ? energy : Real(energy / length); }
};
Sizes sizesOf(const Manipulator& m, const Pose& X_WT, const manipulator::Values& theta, double min_m = 0.0) {
  Sizes sizes{largestOf(Vec3(X_WT.translation())), 1, 0, 0};
  Real slid = largestOf(Vec3(m.chain.X_WT_home.translation())), springs = 0;
  for (std::size_t i = 0; i < m.chain.joints.size(); ++i) {
    const chain::Joint& joint = m.chain.joints[i];
    const bool turns = joint.type == chain::JointType::Revolute;
    if (turns) {
      sizes.turn += std::abs(theta[i]);
      slid = std::max(slid, Real(largestOf(joint.p_WJ)));
    } else {
      sizes.length += std::abs(theta[i]);
    }
    const Real bent = Real(std::abs(theta[i])) + std::abs(m.rest[i]);
    springs += m.spring[i] * bent * (turns ? Real(bent + 1) : bent);
    sizes.springs += m.spring[i] * (turns ? Real(1) : Real(m.reach_m) * m.reach_m);
  }
  sizes.length = std::max(Real(sizes.length + slid), Real(min_m));
  sizes.energy =
      sizes.turn * (Real(largestOf(m.kp_N_per_m)) * sizes.length * sizes.length + m.ko_N_m_per_rad) + springs;
  return sizes;
}

Outcome judgeEnergy(Input& input) {
  const Manipulator m = drawManipulator(input);
  const Pose X_WT = drawStylus(input, m);
  const manipulator::Values theta = drawTheta(input, m);
  Energy at;
  asTheServo([&] {
    evaluate(m, X_WT, theta, at);
    return 0;
  });
  const std::vector<Real> joints = realOf(m, theta);
  if (m.orientation == Orientation::Full) {  // at half a turn the error changes sign: no derivative
    const oracle::ChainPose tip = oracle::chainPose(m.chain, joints);
    if (oracle::angleOf(oracle::columnsOf(X_WT.linear()), tip.R_WT) > 3) return {0.0, true};
  }
  const Sizes sizes = sizesOf(m, X_WT, theta);
  double worst = ulpsOf(at.energy_J, oracle::energyOf(m, X_WT, joints), sizes.energy);
  for (std::size_t i = 0; i < m.chain.joints.size(); ++i) {
    const bool turns = m.chain.joints[i].type == chain::JointType::Revolute;
    worst = std::max(worst, ulpsOf(at.slope[i], oracle::slopeOf(m, X_WT, joints, i), sizes.slope(turns)));
  }
  return {worst, false};
}

/// The least energy of a chain with a closed form, from the form of the energy over each joint: a parabola for a
/// prismatic one, a sine for a revolute one; three values determine it.
Real minEnergy(const Manipulator& m, const Pose& X_WT) {
  const std::size_t count = m.chain.joints.size();
  std::vector<Real> zero(count, 0);
  const Real start = oracle::energyOf(m, X_WT, zero);
  Real min = start;
  for (std::size_t i = 0; i < count; ++i) {
    const chain::Joint& joint = m.chain.joints[i];
    std::vector<Real> theta = zero;
    const auto at = [&](const Real& value) {
      theta[i] = value;
      return oracle::energyOf(m, X_WT, theta);
    };
    if (joint.type == chain::JointType::Prismatic) {
      const Real step = 1, bend = at(step) - 2 * start + at(-step), slope = (at(step) - at(-step)) / 2;
      if (bend == 0) continue;  // no gain for the position
      const Real best = clamped(Real(-slope / bend), joint.min, joint.max);
      min += best * (slope + bend * best / 2);
      continue;
    }
    const Real mean = (start + at(piReal())) / 2, a = mean - start, b = mean - at(Real(piReal() / 2));
    Real lowest = mean - sqrt(a * a + b * b);
    if (std::isfinite(joint.min) || std::isfinite(joint.max)) {
      const Real best = a == 0 && b == 0 ? Real(0) : Real(atan2(b, a));
      bool within = false;
      for (int turn = -2; turn <= 2; ++turn) {
        const Real value = best + 2 * turn * piReal();
        within = within || (value >= joint.min && value <= joint.max);
      }
      if (!within) lowest = std::min(at(Real(joint.min)), at(Real(joint.max)));
    }
    min += lowest - start;
  }
  return min;
}

/// Two revolute joints about one point: c - |kp r d +- ko z|, whatever the joints.
Real minOnSphere(const Manipulator& m, const Pose& X_WT) {
  const manipulator::ClosedForm& form = *m.closed;
  const Real3 radial = real(m.chain.X_WT_home.translation()) - real(form.p_WC);
  const Real radius = norm(radial), kp = m.kp_N_per_m.x();
  const Real ko = m.orientation == Orientation::Axis ? Real(m.ko_N_m_per_rad) : Real(0);
  const Real3 away = real(X_WT.translation()) - real(form.p_WC), z_V = real(m.chain.X_WT_home.linear().col(2));
  const Real3 z_T = real(X_WT.linear().col(2));
  const Real3 pull = kp * radius * away + (dot(z_V, radial) > 0 ? ko : Real(-ko)) * z_T;
  return kp * (radius * radius + dot(away, away)) / 2 + ko * (dot(z_V, z_V) + dot(z_T, z_T)) / 2 - norm(pull);
}

Outcome judgeClosedForm(Input& input) {
  const Manipulator m = drawClosedManipulator(input);
  const Pose X_WT = drawStylus(input, m);
  if (!m.closed) return {kInfinity, false};
  const manipulator::Closed got = asTheServo([&] { return closedForm(m, X_WT, {}); });
  const Sizes sizes = sizesOf(m, X_WT, got.theta);
  for (const double value : got.theta) {
    if (!std::isfinite(value)) return {kInfinity, false};
  }
  const Real min = m.closed->kind == manipulator::ClosedFormKind::Sphere ? minOnSphere(m, X_WT) : minEnergy(m, X_WT);
  const std::vector<Real> joints = realOf(m, got.theta);
  double worst = ulpsOf(Real(oracle::energyOf(m, X_WT, joints) - min), sizes.energy);
  for (std::size_t i = 0; i < joints.size(); ++i) {
    const chain::Joint& joint = m.chain.joints[i];
    const bool held = got.theta[i] <= joint.min || got.theta[i] >= joint.max;
    const bool turns = joint.type == chain::JointType::Revolute;
    if (!held) worst = std::max(worst, ulpsOf(oracle::slopeOf(m, X_WT, joints, i), sizes.slope(turns)));
  }
  return {worst, !got.is_unique};
}

Outcome judgeDescent(Input& input) {
  const Manipulator m = drawManipulator(input);
  const Pose X_WT = drawStylus(input, m);
  const manipulator::Values start = drawTheta(input, m);
  Energy at;
  double before_J = 0.0;
  const manipulator::Descent got = asTheServo([&] {
    evaluate(m, X_WT, start, at);
    before_J = at.energy_J;
    return descend(m, X_WT, 100, at);
  });
  const std::vector<Real> joints = realOf(m, at.theta);
  for (const double value : at.theta) {
    if (!std::isfinite(value)) return {kInfinity, false};
  }
  const Sizes sizes = sizesOf(m, X_WT, at.theta, m.reach_m);  // of which its tolerance is a share
  const Real energy = oracle::energyOf(m, X_WT, joints);
  // The energy never increases, except by the rounding of the energies compared.
  if (energy > before_J + ldexp(Real(sizes.energy + sizesOf(m, X_WT, start).energy), -44)) return {kInfinity, false};
  if (!got.converged) return {0.0, true};
  double worst = 0.0;
  for (std::size_t i = 0; i < joints.size(); ++i) {
    const chain::Joint& joint = m.chain.joints[i];
    if (at.theta[i] <= joint.min || at.theta[i] >= joint.max) continue;
    const bool turns = joint.type == chain::JointType::Revolute;
    const Real slope = abs(oracle::slopeOf(m, X_WT, joints, i));
    worst = std::max(worst, ulpsOf(slope, (sizes.energy + sizes.springs) / (turns ? Real(1) : sizes.length)));
  }
  return {worst, false};
}

constexpr std::array<Row, 3> kRows{{
    {"robot_energy", Kind::Solver, "Energy of a virtual robot of 1 to 8 joints, and its gradient",
     "ulp of kp times all lengths squared + ko + springs, times the sum of the angles (1 rad at least)", 64, 40,
     judgeEnergy},
    {"robot_closed_form", Kind::Solver, "Least energy of one and two joints in closed form",
     "ulp of the same: energy above the least of all, and gradient left", 64, 2, judgeClosedForm},
    {"robot_descent", Kind::Solver,
     "Descent of 1 to 8 joints to a minimum: never uphill, gradient left at the reported minimum",
     "ulp of the same and of the springs' stiffness: four times a tolerance of 1e-10 of the joints", 1801600, 50,
     judgeDescent},
}};

}  // namespace manipulators_rows

constinit const std::span<const Row> kManipulatorRows = manipulators_rows::kRows;

}  // namespace underact::error_bounds
