#include "core/arm/mechanism.h"

#include <algorithm>
#include <cmath>

namespace underact::arm {
namespace {

/// Projects onto the span of so many columns: Gram and Schmidt, the longest remainder first. One that is shorter than
/// least fades out.
template <int D>
Eigen::Matrix<double, D, D> ontoSpan(std::array<Eigen::Matrix<double, D, 1>, chain::kMaxJoints>& rest,
                                     std::size_t count, double min) noexcept UNDERACT_REAL_TIME {
  using Column = Eigen::Matrix<double, D, 1>;
  Eigen::Matrix<double, D, D> P = Eigen::Matrix<double, D, D>::Zero();
  for (int rank = 0; rank < D; ++rank) {
    std::size_t longest = count;
    double size2 = 0.0;
    for (std::size_t i = 0; i < count; ++i) {
      if (rest[i].squaredNorm() > size2) longest = i, size2 = rest[i].squaredNorm();
    }
    if (longest == count) break;
    const Column unit_W = rest[longest] / std::sqrt(size2);
    P += std::min(1.0, size2 / (min * min)) * unit_W * unit_W.transpose();
    for (std::size_t i = 0; i < count; ++i) {
      // Twice: once leaves a remainder of a rounding of the whole column, which is a direction like any other.
      for (int pass = 0; pass < 2; ++pass) rest[i] -= rest[i].dot(unit_W) * unit_W;
    }
  }
  return P;
}

/// Onto what the joints do to the tip's position for which take(joint) is true.
template <class Take>
Mat3 ontoMoved(const chain::Jacobian& J, const Take& take) noexcept UNDERACT_REAL_TIME {
  std::array<Vec3, chain::kMaxJoints> columns;
  std::size_t count = 0;
  for (std::size_t joint = 0; joint < std::min(static_cast<std::size_t>(J.cols()), columns.size()); ++joint) {
    if (take(joint)) columns[count++] = J.col(static_cast<Eigen::Index>(joint)).head<3>();
  }
  return ontoSpan<3>(columns, count, kMinLever_m);
}

bool isSame(const chain::Joint& a, const chain::Joint& b) noexcept UNDERACT_REAL_TIME {
  return a.type == b.type && a.axis_W == b.axis_W && a.p_WJ == b.p_WJ && a.min == b.min && a.max == b.max;
}

bool isSameMass(const LinkMass& a, const LinkMass& b) noexcept UNDERACT_REAL_TIME {
  return a.mass_kg == b.mass_kg && a.p_WC == b.p_WC && a.inertia_W_kg_m2 == b.inertia_W_kg_m2;
}

}  // namespace

bool operator==(const Mechanism& a, const Mechanism& b) noexcept {
  return std::equal(a.chain.joints.begin(), a.chain.joints.end(), b.chain.joints.begin(), b.chain.joints.end(),
                    isSame) &&
         a.chain.X_WT_home.matrix() == b.chain.X_WT_home.matrix() && a.driven == b.driven &&
         std::equal(a.masses.begin(), a.masses.end(), b.masses.begin(), b.masses.end(), isSameMass) &&
         a.X_WB.matrix() == b.X_WB.matrix() && a.rest == b.rest && a.max_torque == b.max_torque &&
         a.max_moment_N_m == b.max_moment_N_m;
}

bool Geometry::operator==(const Geometry& other) const noexcept {
  if (by_chain != other.by_chain) return false;
  if (by_chain) return mechanism == other.mechanism || *mechanism == *other.mechanism;
  return upper_m == other.upper_m && fore_m == other.fore_m && p_WB == other.p_WB;
}

Watched watchedJoints(const Geometry& geometry) noexcept {
  if (solvesInTick(geometry)) return {{0, 1, 2}, 3, {}, true, false};
  const Mechanism& arm = *geometry.mechanism;
  Watched watched;
  watched.turn = arm.renders_moment;
  const std::size_t count = std::min(arm.chain.joints.size(), arm.driven.size());
  for (std::size_t joint = 0; joint < count && watched.count < watched.joint.size(); ++joint) {
    if (!arm.driven[joint]) continue;
    watched.slides[watched.count] = arm.chain.joints[joint].type == chain::JointType::Prismatic;
    watched.joint[watched.count++] = joint;
  }
  return watched;
}

bool slides(const Geometry& geometry, std::size_t joint) noexcept {
  return geometry.by_chain && joint < geometry.mechanism->chain.joints.size() &&
         geometry.mechanism->chain.joints[joint].type == chain::JointType::Prismatic;
}

std::size_t jointsOf(const Geometry& geometry) noexcept {
  constexpr std::size_t kOfLengths = 6;
  return geometry.mechanism != nullptr ? geometry.mechanism->chain.joints.size() : kOfLengths;
}

Mat3 watchedColumns(const Watched& watched, const chain::Jacobian& J) noexcept {
  Mat3 J_p = Mat3::Zero();
  for (std::size_t i = 0; i < std::min<std::size_t>(3, watched.count); ++i) {
    J_p.col(static_cast<Eigen::Index>(i)) = J.col(static_cast<Eigen::Index>(watched.joint[i])).head<3>();
  }
  return J_p;
}

Mat3 renderable(const Mechanism& arm, const chain::Jacobian& J) noexcept {
  const Mat3 reached = ontoMoved(J, [](std::size_t) { return true; });
  const Mat3 slack = ontoMoved(J, [&](std::size_t joint) { return joint >= arm.driven.size() || !arm.driven[joint]; });
  return reached - slack;
}

Mat6 renderableWrench(const chain::Jacobian& J, double moment_arm_m) noexcept {
  std::array<Vec6, chain::kMaxJoints> columns;
  const std::size_t count = std::min(static_cast<std::size_t>(J.cols()), columns.size());
  for (std::size_t joint = 0; joint < count; ++joint) {
    columns[joint] = J.col(static_cast<Eigen::Index>(joint));
    columns[joint].head<3>() /= moment_arm_m;
  }
  return ontoSpan<6>(columns, count, kMinLever_m / moment_arm_m);
}

bool rendersMoment(const Mechanism& arm) {
  const std::size_t joints = arm.chain.joints.size();
  if (joints < 6 || !std::all_of(arm.driven.begin(), arm.driven.begin() + static_cast<std::ptrdiff_t>(joints),
                                 [](bool driven) { return driven; }))
    return false;
  constexpr double kAsLong_m = 0.1;  // a turn of a radian counts as that far
  const Mat6 P = renderableWrench(chain::jacobian(arm.chain, arm.rest), kAsLong_m);
  return (P - Mat6::Identity()).norm() < 1e-9;
}

}  // namespace underact::arm
