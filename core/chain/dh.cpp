#include "core/chain/dh.h"

#include <algorithm>

#include "core/base/trig.h"

namespace underact::chain {

Pose rowPose(const DhRow& row, double q) noexcept {
  const bool turns = row.type == JointType::Revolute;
  const auto [twist, turn] = sinCosOfTwo(row.alpha_rad, turns ? row.theta_rad + q : row.theta_rad);
  const double d_m = turns ? row.d_m : row.d_m + q;
  Pose X = Pose::Identity();
  X.linear() << turn.cos, -turn.sin, 0.0,                      //
      turn.sin * twist.cos, turn.cos * twist.cos, -twist.sin,  //
      turn.sin * twist.sin, turn.cos * twist.sin, twist.cos;
  X.translation() << row.a_m, -twist.sin * d_m, twist.cos * d_m;
  return X;
}

void framesOf(std::span<const DhRow> rows, const Pose& X_WB, std::span<const double> q,
              std::span<Pose> X_WFrames) noexcept {
  const std::size_t count = std::min({rows.size(), q.size(), X_WFrames.size()});
  Pose X_WFrame = X_WB;
  for (std::size_t i = 0; i < count; ++i) {
    const Pose X_Next = rowPose(rows[i], q[i]);
    // In parts, since the effect analysis cannot see through Eigen's product of two poses.
    X_WFrame.translation() += X_WFrame.linear() * X_Next.translation();
    X_WFrame.linear() *= X_Next.linear();
    X_WFrames[i] = X_WFrame;
  }
}

}  // namespace underact::chain
