#include "core/manipulator/energy.h"

#include <algorithm>
#include <cmath>

#include "core/base/around.h"
#include "core/base/rotation.h"

namespace underact::manipulator {
namespace {

using chain::JointType;

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

/// The turn's error, its energy, and the moment that belongs to it: dV = m . w dt where the tip turns by w.
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

/// J_l^-1(e) w: how the rotation vector e grows where the tip turns by w. Source: Sola et al. 2018, "A micro Lie theory
/// for state estimation in robotics", eq. 146.
Vec3 growthOf(const Vec3& e, const Vec3& w) noexcept UNDERACT_REAL_TIME {
  const double squared = e.squaredNorm();
  double share = 1.0 / 12.0;
  if (squared > 1e-6) {
    const double angle = std::sqrt(squared);
    const SinCos half = sinCos(0.5 * angle);
    share = 1.0 / squared - half.cos / (2.0 * angle * half.sin);
  }
  const Vec3 once = e.cross(w);
  return w - 0.5 * once + share * e.cross(once);
}

/// d2V/dtheta_i dtheta_j of the turn's energy over ko, in two parts: what Gauss and Newton keep, and the rest.
struct Parts {
  double first = 0.0;
  double second = 0.0;
};

Parts turnCurvature(const Manipulator& m, const Energy& at, const Vec3& w_i, const Vec3& w_j,
                    bool same) noexcept UNDERACT_REAL_TIME {
  switch (m.orientation) {
    case Orientation::None:
      return {};
    case Orientation::Axis: {
      const Vec3 n_W = at.tip.X_WT.linear().col(2), z_W = n_W - at.e_o_W;  // of V, of the stylus
      const Vec3 n_j = w_j.cross(n_W);
      const double kept = w_i.cross(n_W).dot(n_j);
      return {kept, -z_W.dot(w_i.cross(n_j)) - kept};
    }
    case Orientation::Angle:
      return {at.weight * w_i.dot(w_j), 0.0};
    case Orientation::Full: {
      const double kept = w_i.dot(w_j);
      const double whole = growthOf(at.e_o_W, w_i).dot(w_j) + (same ? 0.0 : at.e_o_W.dot(w_i.cross(w_j)));
      return {kept, whole - kept};
    }
  }
  return {};
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
  H.size = count;
  spread.fill(0.0);
  for (std::size_t j = 0; j < count; ++j) {
    const Vec3 v_j = linear(at, j), w_j = angular(at, j), k_j = m.kp_N_per_m.cwiseProduct(v_j);
    for (std::size_t i = 0; i <= j; ++i) {
      const Vec3 w_i = angular(at, i);
      double kept = linear(at, i).dot(k_j), rest = 0.0;
      if (second_order && m.chain.joints[i].type == JointType::Revolute) rest = at.f_W.dot(w_i.cross(v_j));
      if (turns) {
        const Parts turn = turnCurvature(m, at, w_i, w_j, i == j);
        kept += m.ko_N_m_per_rad * turn.first;
        if (second_order) rest += m.ko_N_m_per_rad * turn.second;
      }
      if (i == j) kept += m.spring[i];
      H.a[j][i] = kept + rest;
      spread[i] += std::abs(rest) + (i == j ? kept : 0.0);
      if (i != j) spread[j] += std::abs(rest);
    }
  }
}

}  // namespace underact::manipulator
