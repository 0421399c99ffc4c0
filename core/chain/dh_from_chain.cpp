#include "core/chain/dh_from_chain.h"

#include <algorithm>
#include <cmath>

#include "core/base/axis_geometry.h"
#include "core/base/rotation.h"
#include "core/chain/kinematics.h"
#include "core/chain/numeric_inverse.h"
#include "core/chain/trig_equation.h"

namespace underact::chain {
namespace {

/// x of a frame on axis a, and where it meets axes a and b: along their common normal. p: where the frame before it
/// came to axis a, x_before its x; both are kept where the axes leave the choice.
struct CommonNormal {
  Vec3 x, p_a, p_b;
};
CommonNormal commonNormal(const Joint& a, const Joint& b, const Vec3& p, const Vec3& x_before, double near_m) {
  if (!areParallel(a.axis_W, b.axis_W)) {
    const Vec3 p_a = nearestOn(a, b), p_b = nearestOn(b, a), offset = p_b - p_a;
    const Vec3 common = a.axis_W.cross(b.axis_W).normalized();
    return {offset.dot(common) < -near_m ? Vec3(-common) : common, p_a, p_b};
  }
  const Vec3 offset = perpendicularPart(a.axis_W, b.p_WJ - p);
  const bool apart = offset.norm() > near_m;
  return {apart ? Vec3(offset.normalized()) : perpendicularPart(a.axis_W, x_before).normalized(), p, p + offset};
}

double angleFrom(const Vec3& axis, const Vec3& u, const Vec3& v) {
  const double angle_rad = angleAbout(axis, u, v);
  for (const double round : {0.0, 0.5 * kPi, -0.5 * kPi, kPi, -kPi}) {  // what is meant, where rounding hides it
    if (std::abs(angle_rad - round) <= 4e-16) return round == -kPi ? kPi : round;
  }
  return angle_rad;
}

}  // namespace

DhForm dhOf(const Chain& chain) {
  DhForm form;
  const double near_m = kSame * std::max(reachOf(chain), 1e-12);
  Vec3 x = chain.joints.front().axis_W.unitOrthogonal();  // of the frame before, and where its normal meets this axis
  Vec3 p = chain.joints.front().p_WJ;
  double a_m = 0.0;
  for (std::size_t i = 0; i < chain.joints.size(); ++i) {
    const Joint& joint = chain.joints[i];
    DhRow row{joint.type, 0.0, a_m, 0.0, 0.0, joint.min, joint.max};
    CommonNormal next{perpendicularPart(joint.axis_W, x).normalized(), p, p};
    if (i + 1 < chain.joints.size()) next = commonNormal(joint, chain.joints[i + 1], p, x, near_m);
    if (i == 0) {
      form.X_WB.linear() << next.x, joint.axis_W.cross(next.x), joint.axis_W;
      form.X_WB.translation() = next.p_a;
    } else {
      row.alpha_rad = angleFrom(x, chain.joints[i - 1].axis_W, joint.axis_W);
      row.theta_rad = angleFrom(joint.axis_W, x, next.x);
      row.d_m = joint.axis_W.dot(next.p_a - p);
    }
    form.rows.push_back(row);
    x = next.x, p = next.p_b;
    a_m = next.x.dot(next.p_b - next.p_a);
    if (std::abs(a_m) <= near_m * 1e-6) a_m = 0.0;
  }
  const std::vector<double> home(chain.joints.size(), 0.0);
  std::vector<Pose> frames(chain.joints.size(), Pose::Identity());
  framesOf(form.rows, form.X_WB, home, frames);
  form.X_NT = frames.back().inverse(Eigen::Isometry) * chain.X_WT_home;
  const Chain back = chainFromDh(form.rows, form.X_WB, form.X_NT);
  std::uint64_t random = 1;
  for (int draw = 0; draw < 16; ++draw) {
    const JointValues q = drawnJoints(chain, random);
    const Pose X = forward(chain, q), Y = forward(back, q);
    form.error_m = std::max(form.error_m, (X.translation() - Y.translation()).norm());
    form.error_rad = std::max(form.error_rad, rotationVector(X.linear().transpose() * Y.linear()).norm());
  }
  return form;
}

}  // namespace underact::chain
