#include "core/manipulator/closed_form.h"

#include <algorithm>
#include <cmath>

#include "core/base/axis_geometry.h"

namespace underact::manipulator {
namespace {

constexpr double kNoDirection = 8 * 0x1p-52;  // relative to the terms: below it only rounding is left

/// The value of a prismatic joint nearest to the stylus, within its limits.
double slideTo(const Manipulator& m, std::size_t i, const Vec3& p_WT) noexcept UNDERACT_REAL_TIME {
  const chain::Joint& joint = m.chain.joints[i];
  return std::clamp(joint.axis_W.dot(p_WT - m.chain.X_WT_home.translation()), joint.min, joint.max);
}

/// The value best_rad + k 2 pi nearest to near_rad that the limits allow; if they allow none, the limit nearer to
/// best_rad on the circle, as the energy grows with the angle from it.
double turnTo(const chain::Joint& joint, double best_rad, double near_rad) noexcept UNDERACT_REAL_TIME {
  const double turn = 2.0 * kPi;
  if (joint.min == -kInfinity && joint.max == kInfinity) return wrapped(best_rad);
  const double value_rad = best_rad + turn * std::floor((near_rad - best_rad) / turn + 0.5);
  if (value_rad >= joint.min && value_rad <= joint.max) return value_rad;
  // The nearest allowed one: the first beyond the limit that was passed.
  const bool under = value_rad < joint.min;
  const double first_rad = under ? best_rad + turn * std::ceil((joint.min - best_rad) / turn)
                                 : best_rad + turn * std::floor((joint.max - best_rad) / turn);
  if (under ? first_rad <= joint.max : first_rad >= joint.min) return first_rad;
  return std::abs(wrapped(joint.min - best_rad)) <= std::abs(wrapped(joint.max - best_rad)) ? joint.min : joint.max;
}

Closed around(const Manipulator& m, const ClosedForm& form, const Pose& X_WT,
              const Values& near) noexcept UNDERACT_REAL_TIME {
  const Vec3 p_CT_W = X_WT.translation() - form.p_WC;
  const double kp = m.kp_N_per_m.x(), ko = m.orientation == Orientation::Axis ? m.ko_N_m_per_rad : 0.0;
  const Vec3 z_W = X_WT.linear().col(2);
  // V = const - a cos(theta) - b sin(theta): one joint rotates both parts.
  const double a = kp * form.radial_W.dot(p_CT_W) + ko * form.z_W.dot(z_W);
  const double b = kp * form.axis_W.cross(form.radial_W).dot(p_CT_W) + ko * form.axis_W.cross(form.z_W).dot(z_W);
  const double size = kp * form.radial_W.norm() * (X_WT.translation().norm() + form.p_WC.norm()) + ko;
  Closed closed{near, std::sqrt(a * a + b * b) > kNoDirection * size};
  if (closed.is_unique)
    closed.theta[form.turning] = turnTo(m.chain.joints[form.turning], atan2Of(b, a), near[form.turning]);
  if (form.kind == ClosedFormKind::Cylinder) closed.theta[form.sliding] = slideTo(m, form.sliding, X_WT.translation());
  return closed;
}

double apart(double a_rad, double b_rad) noexcept UNDERACT_REAL_TIME {
  return std::abs(wrapped(a_rad - b_rad));
}

Closed onSphere(const Manipulator& m, const ClosedForm& form, const Pose& X_WT,
                const Values& near) noexcept UNDERACT_REAL_TIME {
  const double kp = m.kp_N_per_m.x(), ko = m.orientation == Orientation::Axis ? m.ko_N_m_per_rad : 0.0;
  const double radius_m = form.radial_W.norm(), along = form.z_W.dot(form.radial_W) > 0.0 ? 1.0 : -1.0;
  const Vec3 n_W = kp * radius_m * (X_WT.translation() - form.p_WC) + along * ko * X_WT.linear().col(2);
  const double size = kp * radius_m * (X_WT.translation().norm() + form.p_WC.norm()) + ko;
  Closed closed{near, n_W.norm() > kNoDirection * size};
  if (!closed.is_unique) return closed;
  // Joint 2 raises the tip in a plane with axis 1; joint 1 rotates that plane.
  const Vec3 &one_W = m.chain.joints[0].axis_W, &two_W = m.chain.joints[1].axis_W;
  const Vec3 out_W = one_W.cross(two_W);
  const double home_rad = atan2Of(form.radial_W.dot(one_W), form.radial_W.dot(out_W));
  const double x = n_W.dot(out_W), y = -n_W.dot(two_W), up = n_W.dot(one_W), flat = std::sqrt(x * x + y * y);
  const bool pole = flat <= kNoDirection * size;
  const double turn_rad = pole ? near[0] : atan2Of(y, x);
  const Values direct{wrapped(turn_rad), wrapped(atan2Of(up, flat) - home_rad)};
  const Values over{wrapped(turn_rad + kPi), wrapped(atan2Of(up, -flat) - home_rad)};
  const auto distance = [&](const Values& to) { return apart(to[0], near[0]) + apart(to[1], near[1]); };
  closed.theta = pole || distance(direct) <= distance(over) ? direct : over;
  return closed;
}

}  // namespace

Closed closedForm(const Manipulator& m, const Pose& X_WT, const Values& near) noexcept {
  const ClosedForm& form = *m.closed;
  switch (form.kind) {
    case ClosedFormKind::Circle:
    case ClosedFormKind::Cylinder:
      return around(m, form, X_WT, near);
    case ClosedFormKind::Sphere:
      return onSphere(m, form, X_WT, near);
    case ClosedFormKind::Plane:
      return {{slideTo(m, 0, X_WT.translation()), slideTo(m, 1, X_WT.translation())}, true};
    case ClosedFormKind::Line:
      return {{slideTo(m, 0, X_WT.translation())}, true};
  }
  return {near, false};
}

}  // namespace underact::manipulator
