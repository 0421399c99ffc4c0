#include "core/sim/joint_plant.h"

#include <algorithm>
#include <cmath>

#include "core/arm/general_arm.h"
#include "core/arm/inverse.h"
#include "core/base/linear_system.h"
#include "core/base/rotation.h"
#include "core/base/units.h"

namespace underact::sim {
namespace {

constexpr std::size_t kJoints = 6;
constexpr double kDampingRate_1_per_s = 10.0;  // of the joints, times their inertia: no maker states their friction
constexpr double kArmature_kg = 1e-3;          // at the end of the reach: a joint whose links weigh nothing still moves
constexpr double kSoftSpeed_m_per_s = 1e-3;    // up to which Coulomb's friction grows
constexpr double kLead_rad_per_s = 10.0;       // critically damped, of a hand that leads the joints
constexpr double kGrip_m = 0.05;               // from the fingers to the tip
constexpr int kSearch = 200;                   // steps to a position of the tip
constexpr double kDamping_m2 = 1e-4, kFound_m = 1e-6;

using Square = Eigen::Matrix<double, kJoints, kJoints>;
using Column = Eigen::Matrix<double, kJoints, 1>;
using Rows = Eigen::Matrix<double, 3, kJoints>;

/// The Jacobian at the tip, 0 beyond the arm's joints.
struct Moving {
  Vec3 p_WT = Vec3::Zero();
  Mat3 R_WT = Mat3::Identity();
  Rows J_v = Rows::Zero(), J_w = Rows::Zero();
};

Moving movingAt(const arm::GeneralArm& arm, const arm::JointAngles& q) noexcept UNDERACT_REAL_TIME {
  const chain::Kinematics at = chain::kinematics(arm.chain, q);
  Moving moving;
  moving.p_WT = at.X_WT.translation();
  moving.R_WT = at.X_WT.linear();
  for (Eigen::Index joint = 0; joint < std::min<Eigen::Index>(kJoints, at.J.cols()); ++joint) {
    moving.J_v.col(joint) = at.J.col(joint).head<3>();
    moving.J_w.col(joint) = at.J.col(joint).tail<3>();
  }
  return moving;
}

/// The inertia of the links in the joints.
Square inertiaOf(const arm::GeneralArm& arm, const arm::JointAngles& q) noexcept UNDERACT_REAL_TIME {
  const std::size_t count = std::min(kJoints, arm.chain.joints.size());
  const Pose home = Pose::Identity();
  std::array<Pose, kJoints> links{home, home, home, home, home, home};
  chain::forward(arm.chain, q, links);
  Square M = Square::Zero();
  for (std::size_t link = 0; link < std::min(count, arm.masses.size()); ++link) {
    const arm::LinkMass& mass = arm.masses[link];
    const Mat3 R = links[link].linear();
    const Vec3 p_WC = links[link] * mass.p_WC;
    Rows v = Rows::Zero(), w = Rows::Zero();
    for (std::size_t joint = 0; joint <= link; ++joint) {
      const chain::Joint& one = arm.chain.joints[joint];
      const Vec3 axis_W = links[joint].linear() * one.axis_W;  // a joint's own motion leaves its axis where it is
      const auto column = static_cast<Eigen::Index>(joint);
      if (one.type == chain::JointType::Prismatic) {
        v.col(column) = axis_W;
      } else {
        v.col(column) = axis_W.cross(p_WC - links[joint] * one.p_WJ);
        w.col(column) = axis_W;
      }
    }
    M += mass.mass_kg * v.transpose() * v + w.transpose() * (R * mass.inertia_W_kg_m2 * R.transpose()) * w;
  }
  return M;
}

/// What does not change within a period.
struct Period {
  Square M = Square::Zero();  // of arm and hand
  Square D = Square::Zero();  // of the joints
};

bool weighsLinks(const Plant& plant) noexcept UNDERACT_REAL_TIME {
  return plant.model.of_links && !plant.arm.geometry.general->masses.empty();
}

Period periodOf(const Plant& plant, const PlantState& state) noexcept UNDERACT_REAL_TIME {
  const arm::GeneralArm& arm = *plant.arm.geometry.general;
  const Moving at = movingAt(arm, state.q_rad);
  Period period;
  if (weighsLinks(plant)) {
    period.M = inertiaOf(arm, state.q_rad);
    period.D = (kDampingRate_1_per_s * period.M.diagonal()).asDiagonal();
  } else {
    period.M = plant.model.mass_kg * at.J_v.transpose() * at.J_v;
  }
  period.M += plant.hand.mass_kg * at.J_v.transpose() * at.J_v;
  const double reach_m = chain::reachOf(arm.chain);
  for (std::size_t joint = 0; joint < kJoints; ++joint) {
    const bool turns = joint >= arm.chain.joints.size() || arm.chain.joints[joint].type == chain::JointType::Revolute;
    const auto i = static_cast<Eigen::Index>(joint);
    period.M(i, i) += kArmature_kg * (turns ? std::max(1e-4, reach_m * reach_m) : 1.0);
  }
  period.D += plant.model.damping_N_s_per_m * at.J_v.transpose() * at.J_v;
  return period;
}

/// A^-1 b, A symmetric; 0 where rounding leaves A no positive pivot.
Column solved(const Square& A, const Column& b) noexcept UNDERACT_REAL_TIME {
  SymmetricSystem<kJoints> system;
  system.size = kJoints;
  for (std::size_t i = 0; i < kJoints; ++i) {
    system.b[i] = b[static_cast<Eigen::Index>(i)];
    for (std::size_t j = 0; j <= i; ++j) system.a[i][j] = A(static_cast<Eigen::Index>(i), static_cast<Eigen::Index>(j));
  }
  if (!solveInPlace(system)) return Column::Zero();
  return Eigen::Map<const Column>(system.b.data());
}

/// The joints' rates at the end of a substep.
Column ratesAfter(const Plant& plant, const Period& period, const Moving& at, const Column& tau,
                  const HandSetpoint& wish, double dt_s, const arm::JointAngles& q,
                  const Column& dq) noexcept UNDERACT_REAL_TIME {
  if (wish.posture) {
    const Square A = (1.0 + 2.0 * dt_s * kLead_rad_per_s + dt_s * dt_s * kLead_rad_per_s * kLead_rad_per_s) * period.M +
                     dt_s * period.D;
    const Column way = Eigen::Map<const Column>(wish.posture->data()) - Eigen::Map<const Column>(q.data());
    return solved(A, period.M * (dq + dt_s * kLead_rad_per_s * kLead_rad_per_s * way) + dt_s * tau);
  }
  const HandModel& hand = plant.hand;
  const double speed_m_per_s = (at.J_v * dq).norm();
  const double b = hand.damping_N_s_per_m, k = wish.holds ? hand.stiffness_N_per_m : 0.0;
  const double against = b + plant.model.friction_N / (speed_m_per_s + kSoftSpeed_m_per_s);
  const double k_w = wish.turns ? kGrip_m * kGrip_m * hand.stiffness_N_per_m : 0.0, b_w = kGrip_m * kGrip_m * b;
  const Square pushing = at.J_v.transpose() * at.J_v, turning = at.J_w.transpose() * at.J_w;
  const Square A = period.M + dt_s * (period.D + (against + dt_s * k) * pushing + (b_w + dt_s * k_w) * turning);
  const Vec3 hand_N = k * (wish.p_WT - at.p_WT) + b * wish.v_WT;
  Column right = period.M * dq + dt_s * (tau + at.J_v.transpose() * hand_N);
  if (wish.turns) right += (dt_s * k_w) * at.J_w.transpose() * rotationVector(wish.R_WT * at.R_WT.transpose());
  return solved(A, right);
}

/// The torques of the motors for the force that they render.
Column torquesOf(const arm::GeneralArm& arm, const Moving& at, const Vec3& f_T_W) noexcept UNDERACT_REAL_TIME {
  Column tau = at.J_v.transpose() * f_T_W;
  for (std::size_t joint = 0; joint < kJoints; ++joint) {
    if (!arm.driven[joint]) tau[static_cast<Eigen::Index>(joint)] = 0.0;
  }
  return tau;
}

/// One substep's motion, and the stops: a joint there keeps no speed towards its stop.
void move(const Plant& plant, double dt_s, Column& dq, arm::JointAngles& q) noexcept UNDERACT_REAL_TIME {
  arm::JointAngles meant = q;
  for (std::size_t joint = 0; joint < kJoints; ++joint) meant[joint] += dt_s * dq[static_cast<Eigen::Index>(joint)];
  q = arm::withinLimits(plant.arm.limits, meant);
  for (std::size_t joint = 0; joint < kJoints; ++joint) {
    if (q[joint] != meant[joint]) dq[static_cast<Eigen::Index>(joint)] = 0.0;
  }
}

}  // namespace

PlantState restingJoints(const Plant& plant, const Vec3* p_WT) noexcept {
  const arm::GeneralArm& arm = *plant.arm.geometry.general;
  PlantState state;
  state.q_rad = arm::withinLimits(plant.arm.limits, arm.rest);
  state.p_WT = movingAt(arm, state.q_rad).p_WT;
  if (p_WT == nullptr || !(p_WT->allFinite())) return state;
  arm::JointAngles q = state.q_rad;
  for (int step = 0; step < kSearch; ++step) {
    const Moving at = movingAt(arm, q);
    const Vec3 way_W = *p_WT - at.p_WT;
    if (way_W.norm() < (state.p_WT - *p_WT).norm()) state.q_rad = q, state.p_WT = at.p_WT;
    if (way_W.norm() < kFound_m) break;
    SymmetricSystem<3> system;
    system.size = 3;
    const Mat3 square = at.J_v * at.J_v.transpose() + kDamping_m2 * Mat3::Identity();
    const Vec3 capped_W = way_W * std::min(1.0, 0.1 / way_W.norm());
    for (std::size_t i = 0; i < 3; ++i) {
      system.b[i] = capped_W[static_cast<Eigen::Index>(i)];
      for (std::size_t j = 0; j <= i; ++j)
        system.a[i][j] = square(static_cast<Eigen::Index>(i), static_cast<Eigen::Index>(j));
    }
    if (!solveInPlace(system)) break;
    const Column dq = at.J_v.transpose() * Vec3(system.b[0], system.b[1], system.b[2]);
    for (std::size_t joint = 0; joint < kJoints; ++joint) q[joint] += dq[static_cast<Eigen::Index>(joint)];
    q = arm::withinLimits(plant.arm.limits, q);
  }
  return state;
}

PlantState advanceJoints(const Plant& plant, PlantState state, const Vec3& f_T_W, const HandSetpoint& setpoint,
                         std::int64_t period_ns) noexcept {
  const arm::GeneralArm& arm = *plant.arm.geometry.general;
  const PlantState before = state;
  const Period period = periodOf(plant, state);
  Column dq = Eigen::Map<const Column>(state.dq.data());
  HandSetpoint wish = setpoint;
  for (std::int64_t left_ns = period_ns; left_ns > 0;) {
    const std::int64_t step_ns = std::min(left_ns, plant.integration.substep_ns);
    left_ns -= step_ns;
    const double dt_s = kSecondPerNanosecond * static_cast<double>(step_ns);
    wish.p_WT = setpoint.p_WT - (kSecondPerNanosecond * static_cast<double>(left_ns)) * setpoint.v_WT;
    const Moving at = movingAt(arm, state.q_rad);
    dq = ratesAfter(plant, period, at, torquesOf(arm, at, f_T_W), wish, dt_s, state.q_rad, dq);
    move(plant, dt_s, dq, state.q_rad);
  }
  const Moving at = movingAt(arm, state.q_rad);
  state.p_WT = at.p_WT;
  state.v_WT = at.J_v * dq;
  std::copy_n(dq.data(), kJoints, state.dq.begin());
  if (dq.allFinite() && at.p_WT.allFinite() && state.v_WT.allFinite()) return state;
  state = before;  // an overflow
  state.v_WT.setZero();
  state.dq = {};
  return state;
}

}  // namespace underact::sim
