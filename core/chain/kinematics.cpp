#include "core/chain/kinematics.h"

#include <algorithm>

#include "core/base/trig.h"

namespace underact::chain {
namespace {

/// The product of the exponentials so far, which maps points at home to where they are now.
struct Motion {
  Mat3 R = Mat3::Identity();
  Vec3 p = Vec3::Zero();
};

/// A joint's axis, and a point J on it, as moved by the joints before it.
struct MovedAxis {
  Vec3 axis_W;
  Vec3 p_WJ;
};

/// motion := motion e^(S q). The exponential of a screw is a rotation about J, so J stays, and its translation need not
/// be computed.
MovedAxis advance(const Joint& joint, double q, const SinCos& turn, Motion& motion) noexcept {
  const Vec3& axis = joint.axis_W;
  const MovedAxis moved{motion.R * axis, motion.R * joint.p_WJ + motion.p};
  if (joint.type == JointType::Prismatic) {
    motion.p += q * moved.axis_W;
    return moved;
  }
  // R [axis]x, column by column.
  const Vec3 x = motion.R.col(0), y = motion.R.col(1), z = motion.R.col(2);
  const Vec3 along = (1.0 - turn.cos) * moved.axis_W;
  motion.R.col(0) = turn.cos * x + turn.sin * (axis.z() * y - axis.y() * z) + axis.x() * along;
  motion.R.col(1) = turn.cos * y + turn.sin * (axis.x() * z - axis.z() * x) + axis.y() * along;
  motion.R.col(2) = turn.cos * z + turn.sin * (axis.y() * x - axis.x() * y) + axis.z() * along;
  motion.p = moved.p_WJ - motion.R * joint.p_WJ;
  return moved;
}

/// Goes through the chain from its base; calls each(i, moved axis, motion after joint i).
template <class Each>
Motion walk(const Chain& chain, std::span<const double> q, const Each& each) noexcept {
  const std::size_t count = std::min(chain.joints.size(), kMaxJoints);
  const auto valueOf = [&](std::size_t i) { return i < q.size() ? q[i] : 0.0; };
  Motion motion;
  SinCosPair turns;
  for (std::size_t i = 0; i < count; ++i) {
    if (i % 2 == 0) turns = sinCosOfTwo(valueOf(i), valueOf(i + 1));
    const MovedAxis moved = advance(chain.joints[i], valueOf(i), i % 2 == 0 ? turns.first : turns.second, motion);
    each(i, moved, motion);
  }
  return motion;
}

Pose poseOf(const Motion& motion) noexcept {
  Pose X = Pose::Identity();
  X.linear() = motion.R;
  X.translation() = motion.p;
  return X;
}

/// X_WT of a walk to the end.
Pose tipOf(const Chain& chain, const Motion& motion) noexcept {
  Pose X_WT = Pose::Identity();
  X_WT.linear() = motion.R * chain.X_WT_home.linear();
  X_WT.translation() = motion.R * chain.X_WT_home.translation() + motion.p;
  return X_WT;
}

}  // namespace

Pose forward(const Chain& chain, std::span<const double> q) noexcept {
  return tipOf(chain, walk(chain, q, [](std::size_t, const MovedAxis&, const Motion&) {}));
}

Pose forward(const Chain& chain, std::span<const double> q, std::span<Pose> X_WLinks) noexcept {
  return tipOf(chain, walk(chain, q, [&](std::size_t i, const MovedAxis&, const Motion& motion) {
                 if (i < X_WLinks.size()) X_WLinks[i] = poseOf(motion);
               }));
}

Jacobian jacobian(const Chain& chain, std::span<const double> q) noexcept {
  return kinematics(chain, q).J;
}

Kinematics kinematics(const Chain& chain, std::span<const double> q) noexcept {
  const Eigen::Index count = static_cast<Eigen::Index>(std::min(chain.joints.size(), kMaxJoints));
  Kinematics result;
  result.J.resize(6, count);
  // First each axis, as (J, direction); the lever arm to the tip is known only at the end.
  const Motion motion = walk(chain, q, [&](std::size_t i, const MovedAxis& moved, const Motion&) {
    result.J.col(static_cast<Eigen::Index>(i)).head<3>() = moved.p_WJ;
    result.J.col(static_cast<Eigen::Index>(i)).tail<3>() = moved.axis_W;
  });
  result.X_WT = tipOf(chain, motion);
  for (Eigen::Index i = 0; i < count; ++i) {
    const Vec3 p_WJ = result.J.col(i).head<3>(), axis_W = result.J.col(i).tail<3>();
    if (chain.joints[static_cast<std::size_t>(i)].type == JointType::Revolute) {
      result.J.col(i).head<3>() = axis_W.cross(result.X_WT.translation() - p_WJ);
    } else {
      result.J.col(i).head<3>() = axis_W;
      result.J.col(i).tail<3>().setZero();
    }
  }
  return result;
}

}  // namespace underact::chain
