#include "core/arm/general_arm.h"

#include <algorithm>
#include <cmath>

#include "core/arm/preset.h"

namespace underact::arm {
namespace {

/// Projects onto the span of the columns for which take(joint) is true: Gram and Schmidt, the longest remainder first.
template <class Take>
Mat3 ontoSpan(const chain::Jacobian& J, const Take& take) noexcept {
  const auto columns = static_cast<std::size_t>(J.cols());
  std::array<Vec3, chain::kMaxJoints> rest;
  std::size_t count = 0;
  for (std::size_t joint = 0; joint < std::min(columns, rest.size()); ++joint) {
    if (take(joint)) rest[count++] = J.col(static_cast<Eigen::Index>(joint)).head<3>();
  }
  Mat3 P = Mat3::Zero();
  for (int rank = 0; rank < 3; ++rank) {
    std::size_t longest = count;
    double size2 = 0.0;
    for (std::size_t i = 0; i < count; ++i) {
      if (rest[i].squaredNorm() > size2) longest = i, size2 = rest[i].squaredNorm();
    }
    if (longest == count) break;
    const Vec3 way_W = rest[longest] / std::sqrt(size2);
    P += std::min(1.0, size2 / (kLeastLever_m * kLeastLever_m)) * way_W * way_W.transpose();
    for (std::size_t i = 0; i < count; ++i) {
      // Twice: once leaves a remainder of a rounding of the whole column, which is a direction like any other.
      for (int pass = 0; pass < 2; ++pass) rest[i] -= rest[i].dot(way_W) * way_W;
    }
  }
  return P;
}

bool isSame(const chain::Joint& a, const chain::Joint& b) noexcept UNDERACT_REAL_TIME {
  return a.type == b.type && a.axis_W == b.axis_W && a.p_WJ == b.p_WJ && a.min == b.min && a.max == b.max;
}

bool isSameMass(const LinkMass& a, const LinkMass& b) noexcept UNDERACT_REAL_TIME {
  return a.mass_kg == b.mass_kg && a.p_WC == b.p_WC && a.inertia_W_kg_m2 == b.inertia_W_kg_m2;
}

}  // namespace

bool operator==(const GeneralArm& a, const GeneralArm& b) noexcept {
  return std::equal(a.chain.joints.begin(), a.chain.joints.end(), b.chain.joints.begin(), b.chain.joints.end(),
                    isSame) &&
         a.chain.X_WT_home.matrix() == b.chain.X_WT_home.matrix() && a.driven == b.driven &&
         std::equal(a.masses.begin(), a.masses.end(), b.masses.begin(), b.masses.end(), isSameMass) &&
         a.X_WB.matrix() == b.X_WB.matrix() && a.rest == b.rest;
}

Watched watchedJoints(const GeneralArm& arm) noexcept {
  Watched watched;
  const std::size_t count = std::min(arm.chain.joints.size(), arm.driven.size());
  for (std::size_t joint = 0; joint < count && watched.count < watched.joint.size(); ++joint) {
    if (arm.driven[joint]) watched.joint[watched.count++] = joint;
  }
  return watched;
}

Mat3 watchedColumns(const GeneralArm& arm, const chain::Jacobian& J) noexcept {
  Mat3 J_p = Mat3::Zero();
  const Watched watched = watchedJoints(arm);
  for (std::size_t i = 0; i < watched.count; ++i) {
    J_p.col(static_cast<Eigen::Index>(i)) = J.col(static_cast<Eigen::Index>(watched.joint[i])).head<3>();
  }
  return J_p;
}

Mat3 renderable(const GeneralArm& arm, const chain::Jacobian& J) noexcept {
  const Mat3 reached = ontoSpan(J, [](std::size_t) { return true; });
  const Mat3 slack = ontoSpan(J, [&](std::size_t joint) { return joint >= arm.driven.size() || !arm.driven[joint]; });
  return reached - slack;
}

}  // namespace underact::arm
