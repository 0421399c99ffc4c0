#include "core/manipulator/energy.h"

#include <algorithm>
#include <cmath>

#include "core/base/axis_geometry.h"
#include "core/base/rotation.h"

namespace underact::manipulator {
namespace {

constexpr double kBlend_rad = 5.0 * kRadPerDegree;  // as an influence's own default

std::size_t jointsOf(const Manipulator& manipulator) noexcept UNDERACT_REAL_TIME {
  return std::min(manipulator.chain.joints.size(), kMaxJoints);
}

Vec3 linear(const Energy& at, std::size_t i) noexcept UNDERACT_REAL_TIME {
  return at.tip.J.col(static_cast<Eigen::Index>(i)).head<3>();
}
Vec3 angular(const Energy& at, std::size_t i) noexcept UNDERACT_REAL_TIME {
  return at.tip.J.col(static_cast<Eigen::Index>(i)).tail<3>();
}

/// The error of the orientation, its energy, and its moment: dV = m . w dt where the tip rotates with w.
double addTurn(const Manipulator& m, const Mat3& R_WT, Energy& at) noexcept UNDERACT_REAL_TIME {
  const Mat3& R_WV = at.tip.X_WT.linear();
  at.e_o_W.setZero();
  at.m_W.setZero();
  switch (m.orientation) {
    case Orientation::None:
      return 0.0;
    case Orientation::Axis:
      at.e_o_W = R_WV.col(2) - R_WT.col(2);
      at.m_W = m.ko_N_m_per_rad * R_WT.col(2).cross(R_WV.col(2));
      break;
    case Orientation::Angle: {
      const Vec3& axis_W = m.chain.joints[m.turning].axis_W;
      at.weight = weightOfAngle(axis_W, R_WT.col(2));
      at.e_o_W = wrapped(at.theta[m.turning] + m.home_rad - angleAround(axis_W, R_WT.col(2))) * axis_W;
      at.m_W = at.weight * m.ko_N_m_per_rad * at.e_o_W;
      break;
    }
    case Orientation::Full:
      at.e_o_W = rotationVector(R_WV * R_WT.transpose());
      at.m_W = m.ko_N_m_per_rad * at.e_o_W;
      break;
  }
  return 0.5 * at.weight * m.ko_N_m_per_rad * at.e_o_W.squaredNorm();
}

/// J_l^-1(e) w: the rate of the rotation vector e where the tip rotates with w, with J_l^-1 = 1 - [e] / 2 + share
/// [e]^2. Source: Sola et al. 2018, "A micro Lie theory for state estimation in robotics", eq. 146.
double shareOf(const Vec3& e) noexcept UNDERACT_REAL_TIME {
  const double squared = e.squaredNorm();
  if (squared <= 1e-6) return 1.0 / 12.0;
  const double angle = std::sqrt(squared);
  const SinCos half = sinCos(0.5 * angle);
  return 1.0 / squared - half.cos / (2.0 * angle * half.sin);
}

/// d2V/dtheta_i dtheta_j is a product with joint j's own (v_j, w_j) for all j from i on. That of joint i, in two parts:
/// that of Gauss and Newton, and the rest.
struct Row {
  Vec3 kept_v, kept_w;
  Vec3 rest_v, rest_w;
  double kept(const Vec3& v, const Vec3& w) const noexcept UNDERACT_REAL_TIME { return kept_v.dot(v) + kept_w.dot(w); }
  double rest(const Vec3& v, const Vec3& w) const noexcept UNDERACT_REAL_TIME { return rest_v.dot(v) + rest_w.dot(w); }
};

/// Adds the part of the orientation to a row. share: of shareOf(), for Orientation::Full.
void addTurn(const Manipulator& m, const Energy& at, double share, const Vec3& w_i,
             Row& row) noexcept UNDERACT_REAL_TIME {
  const double ko = m.ko_N_m_per_rad;
  switch (m.orientation) {
    case Orientation::None:
      return;
    case Orientation::Axis: {
      const Vec3 n_W = at.tip.X_WT.linear().col(2), z_W = n_W - at.e_o_W;  // of V, of the stylus
      row.kept_w = ko * n_W.cross(w_i.cross(n_W));
      row.rest_w = -ko * n_W.cross(z_W.cross(w_i)) - row.kept_w;
      return;
    }
    case Orientation::Angle:
      row.kept_w = at.weight * ko * w_i;
      return;
    case Orientation::Full: {
      // From J_l^-1 w less w, and from the later joint's axis, which rotates with the earlier: e . (w_i x w_j).
      const Vec3 once = at.e_o_W.cross(w_i);
      row.kept_w = ko * w_i;
      row.rest_w = ko * (0.5 * once + share * at.e_o_W.cross(once));
      return;
    }
  }
}

}  // namespace

double weightOfAngle(const Vec3& axis_W, const Vec3& stylus_W) noexcept {
  const double along = stylus_W.dot(axis_W);
  const Vec3 across_W = stylus_W - along * axis_W;
  const double x = std::min(1.0, atan2Of(across_W.norm(), std::abs(along)) / kBlend_rad);
  return x * x * (3.0 - 2.0 * x);
}

void evaluate(const Manipulator& m, const Pose& X_WT, const Values& theta, Energy& at) noexcept {
  const std::size_t count = jointsOf(m);
  at.theta = theta;
  at.tip = chain::kinematics(m.chain, std::span<const double>(theta).first(count));
  at.e_p_W = at.tip.X_WT.translation() - X_WT.translation();
  at.f_W = m.kp_N_per_m.cwiseProduct(at.e_p_W);
  at.energy_J = 0.5 * at.e_p_W.dot(at.f_W) + addTurn(m, X_WT.linear(), at);
  for (std::size_t i = 0; i < count; ++i) {
    const double bent = m.bends ? theta[i] - m.rest[i] : 0.0;
    at.slope[i] = linear(at, i).dot(at.f_W) + angular(at, i).dot(at.m_W) + m.spring[i] * bent;
    at.energy_J += 0.5 * m.spring[i] * bent * bent;
  }
}

void curvature(const Manipulator& m, const Energy& at, bool second_order, Hessian& H, Values& spread) noexcept {
  const std::size_t count = jointsOf(m);
  const bool turns = m.orientation != Orientation::None && m.ko_N_m_per_rad > 0.0;
  const double share = turns && m.orientation == Orientation::Full ? shareOf(at.e_o_W) : 0.0;
  std::array<Vec3, kMaxJoints> v, w;
  for (std::size_t i = 0; i < count; ++i) v[i] = linear(at, i), w[i] = angular(at, i);
  H.size = count;
  spread.fill(0.0);
  Values mixed{};  // of a revolute and a prismatic joint: a different unit
  for (std::size_t i = 0; i < count; ++i) {
    // The tip of the later joint rotates about the earlier one's axis; a prismatic one has no rotation.
    Row row{m.kp_N_per_m.cwiseProduct(v[i]), Vec3::Zero(), at.f_W.cross(w[i]), Vec3::Zero()};
    if (turns) addTurn(m, at, share, w[i], row);
    for (std::size_t j = i; j < count; ++j) {
      const double rest = second_order ? row.rest(v[j], w[j]) : 0.0;
      H.a[j][i] = row.kept(v[j], w[j]) + rest;
      Values& sum = m.chain.joints[i].type == m.chain.joints[j].type ? spread : mixed;
      sum[i] += std::abs(rest);
      if (i != j) sum[j] += std::abs(rest);
    }
    const double own = row.kept(v[i], w[i]) + m.spring[i];
    H.a[i][i] += m.spring[i];
    spread[i] += own;
  }
  // Where i is revolute and j prismatic, |2 x_i x_j| <= reach x_i^2 + x_j^2 / reach.
  for (std::size_t i = 0; i < count; ++i) {
    const bool is_turning = m.chain.joints[i].type == chain::JointType::Revolute;
    spread[i] += is_turning ? mixed[i] * m.reach_m : mixed[i] / m.reach_m;
  }
}

}  // namespace underact::manipulator
