#include <algorithm>
#include <cmath>
#include <utility>

#include "core/arm/inverse.h"
#include "core/arm/mechanism.h"
#include "core/base/linear_system.h"
#include "core/base/rotation.h"
#include "core/base/units.h"
#include "core/sim/mechanics.h"

namespace underact::sim {
namespace {

constexpr double kDampingRate_1_per_s = 10.0;  // of the joints, times their inertia: no maker states their friction
constexpr double kArmature_kg = 1e-3;          // at the end of the reach: a joint whose links weigh nothing still moves
constexpr double kSoftSpeed_m_per_s = 1e-3;    // up to which Coulomb's friction grows
constexpr double kLead_rad_per_s = 10.0;       // critically damped, of a hand that leads the joints
constexpr double kGrip_m = 0.05;               // from the fingers to the tip
constexpr int kSearch = 200;                   // steps to a position of the tip
constexpr double kDamping_m2 = 1e-4, kFound_m = 1e-6;

/// Of an arm of up to N joints; 0 beyond its joints. Arms of up to six are computed with six, so that their bits do not
/// depend on how many others have.
template <std::size_t N>
using Square = Eigen::Matrix<double, N, N>;
template <std::size_t N>
using Column = Eigen::Matrix<double, N, 1>;
template <std::size_t N>
using Rows = Eigen::Matrix<double, 3, N>;

/// The Jacobian at the tip, 0 beyond the arm's joints.
template <std::size_t N>
struct Moving {
  Vec3 p_WT = Vec3::Zero();
  Mat3 R_WT = Mat3::Identity();
  Rows<N> J_v = Rows<N>::Zero(), J_w = Rows<N>::Zero();
};

template <std::size_t N>
Moving<N> movingAt(const arm::Mechanism& arm, const arm::JointAngles& q) noexcept UNDERACT_REAL_TIME {
  const chain::Kinematics at = chain::kinematics(arm.chain, q);
  Moving<N> moving;
  moving.p_WT = at.X_WT.translation();
  moving.R_WT = at.X_WT.linear();
  for (Eigen::Index joint = 0; joint < std::min<Eigen::Index>(N, at.J.cols()); ++joint) {
    moving.J_v.col(joint) = at.J.col(joint).head<3>();
    moving.J_w.col(joint) = at.J.col(joint).tail<3>();
  }
  return moving;
}

// Eigen multiplies matrices of eight and more in blocks, for which it may allocate: then they are multiplied here.
constexpr std::size_t kInBlocks = 8;

/// factor J^T J.
template <std::size_t N>
Square<N> squareOf(double factor, const Rows<N>& J) noexcept UNDERACT_REAL_TIME {
  if constexpr (N < kInBlocks) {
    return factor * J.transpose() * J;
  } else {
    Square<N> A;
    for (Eigen::Index i = 0; i < A.rows(); ++i) {
      for (Eigen::Index j = 0; j < A.cols(); ++j) A(i, j) = factor * J.col(i).dot(J.col(j));
    }
    return A;
  }
}

/// J^T X J.
template <std::size_t N>
Square<N> squareWith(const Mat3& X, const Rows<N>& J) noexcept UNDERACT_REAL_TIME {
  if constexpr (N < kInBlocks) {
    return J.transpose() * X * J;
  } else {
    Square<N> A;
    for (Eigen::Index j = 0; j < A.cols(); ++j) {
      const Vec3 X_J = X * J.col(j);
      for (Eigen::Index i = 0; i < A.rows(); ++i) A(i, j) = J.col(i).dot(X_J);
    }
    return A;
  }
}

/// J J^T.
template <std::size_t N>
Mat3 acrossOf(const Rows<N>& J) noexcept UNDERACT_REAL_TIME {
  if constexpr (N < kInBlocks) {
    return J * J.transpose();
  } else {
    Mat3 A = Mat3::Zero();
    for (Eigen::Index j = 0; j < J.cols(); ++j) A += J.col(j) * J.col(j).transpose();
    return A;
  }
}

/// A b.
template <std::size_t N>
Column<N> times(const Square<N>& A, const Column<N>& b) noexcept UNDERACT_REAL_TIME {
  if constexpr (N < kInBlocks) {
    return A * b;
  } else {
    Column<N> sum = Column<N>::Zero();
    for (Eigen::Index j = 0; j < A.cols(); ++j) sum += b[j] * A.col(j);
    return sum;
  }
}

template <std::size_t... I>
std::array<Pose, sizeof...(I)> homesOf(std::index_sequence<I...>) noexcept UNDERACT_REAL_TIME {
  const Pose home = Pose::Identity();
  return {((void)I, home)...};
}

/// The inertia of the links in the joints.
template <std::size_t N>
Square<N> inertiaOf(const arm::Mechanism& arm, const arm::JointAngles& q) noexcept UNDERACT_REAL_TIME {
  const std::size_t count = std::min(N, arm.chain.joints.size());
  std::array<Pose, N> links = homesOf(std::make_index_sequence<N>());
  chain::forward(arm.chain, q, links);
  Square<N> M = Square<N>::Zero();
  for (std::size_t link = 0; link < std::min(count, arm.masses.size()); ++link) {
    const arm::LinkMass& mass = arm.masses[link];
    const Mat3 R = links[link].linear();
    const Vec3 p_WC = links[link] * mass.p_WC;
    Rows<N> v = Rows<N>::Zero(), w = Rows<N>::Zero();
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
    M += squareOf<N>(mass.mass_kg, v) + squareWith<N>(R * mass.inertia_W_kg_m2 * R.transpose(), w);
  }
  return M;
}

/// What does not change within a period.
template <std::size_t N>
struct Period {
  Square<N> M = Square<N>::Zero();  // of arm and hand
  Square<N> D = Square<N>::Zero();  // of the joints
};

bool weighsLinks(const Plant& plant) noexcept UNDERACT_REAL_TIME {
  return plant.model.of_links && !plant.arm.geometry.mechanism->masses.empty();
}

template <std::size_t N>
Period<N> periodOf(const Plant& plant, const PlantState& state) noexcept UNDERACT_REAL_TIME {
  const arm::Mechanism& arm = *plant.arm.geometry.mechanism;
  const Moving<N> at = movingAt<N>(arm, state.q_rad);
  Period<N> period;
  if (weighsLinks(plant)) {
    period.M = inertiaOf<N>(arm, state.q_rad);
    period.D = (kDampingRate_1_per_s * period.M.diagonal()).asDiagonal();
  } else {
    period.M = squareOf<N>(plant.model.mass_kg, at.J_v);
  }
  period.M += squareOf<N>(plant.hand.mass_kg, at.J_v);
  const double reach_m = chain::reachOf(arm.chain);
  for (std::size_t joint = 0; joint < N; ++joint) {
    const bool turns = joint >= arm.chain.joints.size() || arm.chain.joints[joint].type == chain::JointType::Revolute;
    const auto i = static_cast<Eigen::Index>(joint);
    period.M(i, i) += kArmature_kg * (turns ? std::max(1e-4, reach_m * reach_m) : 1.0);
  }
  period.D += squareOf<N>(plant.model.damping_N_s_per_m, at.J_v);
  return period;
}

/// A^-1 b, A symmetric; 0 where rounding leaves A no positive pivot.
template <std::size_t N>
Column<N> solved(const Square<N>& A, const Column<N>& b) noexcept UNDERACT_REAL_TIME {
  SymmetricSystem<N> system;
  system.size = N;
  for (std::size_t i = 0; i < N; ++i) {
    system.b[i] = b[static_cast<Eigen::Index>(i)];
    for (std::size_t j = 0; j <= i; ++j) system.a[i][j] = A(static_cast<Eigen::Index>(i), static_cast<Eigen::Index>(j));
  }
  if (!solveInPlace(system)) return Column<N>::Zero();
  return Eigen::Map<const Column<N>>(system.b.data());
}

/// The joints' rates at the end of a substep.
template <std::size_t N>
Column<N> ratesAfter(const Plant& plant, const Period<N>& period, const Moving<N>& at, const Column<N>& tau,
                     const HandSetpoint& wish, double dt_s, const arm::JointAngles& q,
                     const Column<N>& dq) noexcept UNDERACT_REAL_TIME {
  const Shares shares = sharesOf(plant.integration.integrator);
  // Of dq and dq' in the dampers, and in the way from `at` to where the springs are evaluated, in s.
  const double old = shares.damping_begin, now = 1.0 - old;
  const double old_s = -old * shares.travel_begin * dt_s, now_s = now * (1.0 - shares.travel_begin) * dt_s;
  const bool has_old = shares.travel_begin > 0.0;
  if (wish.posture) {
    const Square<N> A =
        (1.0 + 2.0 * now * dt_s * kLead_rad_per_s + dt_s * now_s * kLead_rad_per_s * kLead_rad_per_s) * period.M +
        now * dt_s * period.D;
    const Column<N> offset = Eigen::Map<const Column<N>>(wish.posture->data()) - Eigen::Map<const Column<N>>(q.data());
    const double kept = 1.0 - 2.0 * old * dt_s * kLead_rad_per_s - dt_s * old_s * kLead_rad_per_s * kLead_rad_per_s;
    Column<N> right = times<N>(period.M, kept * dq + dt_s * kLead_rad_per_s * kLead_rad_per_s * offset) + dt_s * tau;
    if (has_old) right -= (old * dt_s) * times<N>(period.D, dq);
    return solved<N>(A, right);
  }
  const HandModel& hand = plant.hand;
  const double b = hand.damping_N_s_per_m, k = wish.holds ? hand.stiffness_N_per_m : 0.0;
  const double k_w = wish.turns ? kGrip_m * kGrip_m * hand.stiffness_N_per_m : 0.0, b_w = kGrip_m * kGrip_m * b;
  const Square<N> pushing = squareOf<N>(1.0, at.J_v), turning = squareOf<N>(1.0, at.J_w);
  const Vec3 hand_N = k * (wish.p_WT - (old * dt_s) * wish.v_WT - at.p_WT) + b * wish.v_WT;
  Column<N> right = times<N>(period.M, dq) + dt_s * (tau + at.J_v.transpose() * hand_N);
  if (wish.turns) right += (dt_s * k_w) * at.J_w.transpose() * rotationVector(wish.R_WT * at.R_WT.transpose());
  if (has_old) {
    const Square<N> before = old * period.D + (old * b + old_s * k) * pushing + (old * b_w + old_s * k_w) * turning;
    right -= dt_s * times<N>(before, dq);
  }
  Column<N> after = dq;
  for (int pass = has_old ? 2 : 1; pass > 0; --pass) {  // the second one with the friction at the speed of the first
    const double speed_m_per_s = (at.J_v * after).norm();
    const double against = now * b + plant.model.friction_N / (speed_m_per_s + kSoftSpeed_m_per_s);
    const Square<N> A =
        period.M + dt_s * (now * period.D + (against + now_s * k) * pushing + (now * b_w + now_s * k_w) * turning);
    after = solved<N>(A, right);
  }
  return after;
}

/// The torques of the motors for what they render.
template <std::size_t N>
Column<N> torquesOf(const arm::Mechanism& arm, const Moving<N>& at, const Pushed& pushed) noexcept UNDERACT_REAL_TIME {
  Column<N> tau = at.J_v.transpose() * pushed.f_T_W;
  if (pushed.m_T_W != Vec3::Zero()) tau += at.J_w.transpose() * pushed.m_T_W;
  for (std::size_t joint = 0; joint < N; ++joint) {
    if (!arm.driven[joint]) tau[static_cast<Eigen::Index>(joint)] = 0.0;
  }
  return tau;
}

/// One substep's motion at this mean rate, and the stops: a joint there keeps no speed dq towards its stop.
template <std::size_t N>
void move(const Plant& plant, double dt_s, const Column<N>& mean, Column<N>& dq,
          arm::JointAngles& q) noexcept UNDERACT_REAL_TIME {
  arm::JointAngles meant = q;
  for (std::size_t joint = 0; joint < N; ++joint) meant[joint] += dt_s * mean[static_cast<Eigen::Index>(joint)];
  q = arm::withinLimits(plant.arm.limits, meant);
  for (std::size_t joint = 0; joint < N; ++joint) {
    if (q[joint] != meant[joint]) dq[static_cast<Eigen::Index>(joint)] = 0.0;
  }
}

template <std::size_t N>
PlantState jointsAtRest(const Plant& plant, const Vec3* p_WT) noexcept UNDERACT_REAL_TIME {
  const arm::Mechanism& arm = *plant.arm.geometry.mechanism;
  PlantState state;
  state.q_rad = arm::withinLimits(plant.arm.limits, arm.rest);
  state.p_WT = movingAt<N>(arm, state.q_rad).p_WT;
  if (p_WT == nullptr || !(p_WT->allFinite())) return state;
  arm::JointAngles q = state.q_rad;
  for (int step = 0; step < kSearch; ++step) {
    const Moving<N> at = movingAt<N>(arm, q);
    const Vec3 offset_W = *p_WT - at.p_WT;
    if (offset_W.norm() < (state.p_WT - *p_WT).norm()) state.q_rad = q, state.p_WT = at.p_WT;
    if (offset_W.norm() < kFound_m) break;
    SymmetricSystem<3> system;
    system.size = 3;
    const Mat3 square = acrossOf<N>(at.J_v) + kDamping_m2 * Mat3::Identity();
    const Vec3 capped_W = offset_W * std::min(1.0, 0.1 / offset_W.norm());
    for (std::size_t i = 0; i < 3; ++i) {
      system.b[i] = capped_W[static_cast<Eigen::Index>(i)];
      for (std::size_t j = 0; j <= i; ++j)
        system.a[i][j] = square(static_cast<Eigen::Index>(i), static_cast<Eigen::Index>(j));
    }
    if (!solveInPlace(system)) break;
    const Column<N> dq = at.J_v.transpose() * Vec3(system.b[0], system.b[1], system.b[2]);
    for (std::size_t joint = 0; joint < N; ++joint) q[joint] += dq[static_cast<Eigen::Index>(joint)];
    q = arm::withinLimits(plant.arm.limits, q);
  }
  return state;
}

template <std::size_t N>
PlantState advanceBy(const Plant& plant, PlantState state, const Pushed& pushed, const HandSetpoint& setpoint,
                     std::int64_t period_ns) noexcept UNDERACT_REAL_TIME {
  const arm::Mechanism& arm = *plant.arm.geometry.mechanism;
  const Period<N> period = periodOf<N>(plant, state);
  Column<N> dq = Eigen::Map<const Column<N>>(state.dq.data());
  const double travel_begin = sharesOf(plant.integration.integrator).travel_begin;
  HandSetpoint wish = setpoint;
  for (std::int64_t left_ns = period_ns; left_ns > 0;) {
    const std::int64_t step_ns = std::min(left_ns, plant.integration.substep_ns);
    left_ns -= step_ns;
    const double dt_s = kSecondPerNanosecond * static_cast<double>(step_ns);
    wish.p_WT = setpoint.p_WT - (kSecondPerNanosecond * static_cast<double>(left_ns)) * setpoint.v_WT;
    const Column<N> before_dq = dq;
    arm::JointAngles q = state.q_rad;  // in the middle of the substep, as far as dq tells
    for (std::size_t joint = 0; joint < N; ++joint)
      q[joint] += travel_begin * dt_s * dq[static_cast<Eigen::Index>(joint)];
    const Moving<N> at = movingAt<N>(arm, q);
    dq = ratesAfter<N>(plant, period, at, torquesOf<N>(arm, at, pushed), wish, dt_s, q, dq);
    move<N>(plant, dt_s, travel_begin * before_dq + (1.0 - travel_begin) * dq, dq, state.q_rad);
  }
  const Moving<N> at = movingAt<N>(arm, state.q_rad);
  state.p_WT = at.p_WT;
  state.v_WT = at.J_v * dq;
  std::copy_n(dq.data(), N, state.dq.begin());
  return state;
}

/// An encoder measures its own joint.
arm::JointAngles ownAngles(const arm::JointAngles& q) noexcept UNDERACT_REAL_TIME {
  return q;
}

}  // namespace

const Mechanics kSixJointMechanics{jointsAtRest<6>, advanceBy<6>, ownAngles, ownAngles};
const Mechanics kJointMechanics{jointsAtRest<arm::kMaxJoints>, advanceBy<arm::kMaxJoints>, ownAngles, ownAngles};

}  // namespace underact::sim
