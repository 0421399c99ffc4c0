#include <cmath>

#include "core/base/axis_geometry.h"
#include "core/manipulator/manipulator.h"

namespace underact::manipulator {
namespace {

using chain::Joint;
using chain::JointType;

constexpr double kSame = 1e-9;  // rad, and of the reach

bool turns(const Joint& joint) {
  return joint.type == JointType::Revolute;
}
bool parallel(const Joint& a, const Joint& b) {
  return a.axis_W.cross(b.axis_W).norm() <= kSame;
}
bool crossing(const Joint& a, const Joint& b) {
  return std::abs(a.axis_W.dot(b.axis_W)) <= kSame;
}
bool unlimited(const Joint& joint) {
  return joint.min == -kInfinity && joint.max == kInfinity;
}

/// Circle and cylinder; none where the tip does not move and has no orientation to follow.
std::optional<ClosedForm> circularForm(const Manipulator& m, std::size_t turning, std::size_t sliding,
                                       ClosedFormKind kind) {
  if (m.orientation != Orientation::None && m.orientation != Orientation::Axis) return std::nullopt;
  const Joint& joint = m.chain.joints[turning];
  ClosedForm form{kind, turning, sliding, joint.p_WJ, joint.axis_W};
  const Vec3 tip_W = m.chain.X_WT_home.translation() - joint.p_WJ;
  form.radial_W = perpendicularPart(joint.axis_W, tip_W);
  form.z_W = perpendicularPart(joint.axis_W, m.chain.X_WT_home.linear().col(2));
  return form;
}

std::optional<ClosedForm> sphericalForm(const Manipulator& m) {
  const Joint &one = m.chain.joints[0], &two = m.chain.joints[1];
  if (!crossing(one, two) || !unlimited(one) || !unlimited(two)) return std::nullopt;
  const double near_m = kSame * m.reach_m;
  const Vec3 between_W = two.p_WJ - one.p_WJ;
  if (std::abs(between_W.dot(one.axis_W.cross(two.axis_W))) > near_m) return std::nullopt;
  ClosedForm form{ClosedFormKind::Sphere, 0, 1, one.p_WJ + between_W.dot(one.axis_W) * one.axis_W, one.axis_W};
  form.radial_W = m.chain.X_WT_home.translation() - form.p_WC;
  const double radius_m = form.radial_W.norm();
  if (radius_m <= near_m || std::abs(form.radial_W.dot(two.axis_W)) > near_m) return std::nullopt;
  form.z_W = m.chain.X_WT_home.linear().col(2);
  const bool radial = form.z_W.cross(form.radial_W).norm() <= kSame * radius_m;
  if (m.orientation != Orientation::None && !(m.orientation == Orientation::Axis && radial)) return std::nullopt;
  return form;
}

}  // namespace

std::optional<ClosedForm> closedFormOf(const Manipulator& m) {
  const std::vector<Joint>& joints = m.chain.joints;
  const bool equal = m.kp_N_per_m.x() == m.kp_N_per_m.y() && m.kp_N_per_m.y() == m.kp_N_per_m.z();
  if (!equal || m.bends || joints.empty() || joints.size() > 2) return std::nullopt;
  if (joints.size() == 1)
    return turns(joints[0]) ? circularForm(m, 0, 0, ClosedFormKind::Circle) : ClosedForm{ClosedFormKind::Line};
  if (turns(joints[0]) && turns(joints[1])) return sphericalForm(m);
  if (!turns(joints[0]) && !turns(joints[1])) {
    return crossing(joints[0], joints[1]) ? std::optional(ClosedForm{ClosedFormKind::Plane}) : std::nullopt;
  }
  const std::size_t turning = turns(joints[0]) ? 0 : 1;
  if (!parallel(joints[0], joints[1])) return std::nullopt;
  return circularForm(m, turning, 1 - turning, ClosedFormKind::Cylinder);
}

}  // namespace underact::manipulator
