#include "core/target/influence.h"

#include <algorithm>
#include <cmath>

#include "core/base/axis_geometry.h"
#include "core/manipulator/follow.h"

namespace underact::target {
namespace {

/// Below this a cross product of unit vectors has no direction.
constexpr double kNoDirection = 8 * 0x1p-52;

/// A smooth step from 0 to 1 over [0, 1], with slope 0 at both ends.
double smooth(double share) noexcept UNDERACT_REAL_TIME {
  const double x = std::clamp(share, 0.0, 1.0);
  return x * x * (3.0 - 2.0 * x);
}

/// The weight of the stylus's direction, at most 1, by its angle from the shape's axis.
double weightOf(const Influence& influence, double across_axis, double along_axis) noexcept UNDERACT_REAL_TIME {
  if (across_axis <= kNoDirection) return 0.0;
  if (!(influence.blend_rad > 0.0)) return 1.0;
  return smooth(atan2Of(across_axis, std::abs(along_axis)) / influence.blend_rad);
}

/// delta on the side of the last one, if both are near half a turn.
double onTheSameSide(double delta_rad, const InfluenceState& state) noexcept UNDERACT_REAL_TIME {
  const bool near_tie = std::abs(delta_rad) > kPi - kTie_rad && std::abs(state.delta_rad) > 0.5 * kPi;
  if (!state.begun || !near_tie || delta_rad * state.delta_rad >= 0.0) return delta_rad;
  return delta_rad + std::copysign(2.0 * kPi, state.delta_rad);
}

/// The direction from the centre to the target, at right angles to the axis, and what is known of it. on_axis: that of
/// the tip is undefined.
struct Around {
  Vec3 n_W = Vec3::Zero();
  Angles angles;
  bool is_unique = false;
  Arc arc;  // about the origin, of radius 1
};

Arc placed(const Arc& arc, const Vec3& p_WC, double radius_m) noexcept UNDERACT_REAL_TIME {
  return {p_WC, p_WC + radius_m * arc.p_WPo, p_WC + radius_m * arc.p_WPp, arc.axis_W, arc.turn_rad, arc.share};
}

Around around(const Vec3& axis_W, const Influence& influence, const Vec3& tip_W, bool on_axis, const Vec3& stylus_W,
              InfluenceState& state) noexcept UNDERACT_REAL_TIME {
  const Vec3 turned_W = perpendicularPart(axis_W, influence.stylus_sign * stylus_W);
  const double turned = turned_W.norm();
  const double weight = weightOf(influence, turned, stylus_W.dot(axis_W));
  Around result;
  if (on_axis && weight <= 0.0) {
    state.begun = false;
    return result;
  }
  const Vec3 u_W = referencePerpendicular(axis_W), v_W = axis_W.cross(u_W);
  const auto angleOf = [&](const Vec3& n_W) { return atan2Of(n_W.dot(v_W), n_W.dot(u_W)); };
  const Vec3 stylus_n_W = turned > kNoDirection ? Vec3(turned_W / turned) : Vec3::Zero();
  result.is_unique = true;
  result.arc.axis_W = axis_W;
  if (turned > kNoDirection) {
    result.angles.alpha_rad = angleOf(stylus_n_W);
    result.arc.p_WPo = stylus_n_W;
  }
  if (!on_axis) {
    result.angles.beta_rad = angleOf(tip_W);
    result.arc.p_WPp = tip_W;
  }
  if (on_axis) {
    result.n_W = stylus_n_W;
    state.begun = false;
  } else if (weight <= 0.0) {
    result.n_W = tip_W;
    state.begun = false;
  } else {
    const double delta_rad = onTheSameSide(atan2Of(axis_W.dot(stylus_n_W.cross(tip_W)), stylus_n_W.dot(tip_W)), state);
    state.delta_rad = delta_rad;
    state.begun = true;
    // Measured from the tip, so that position alone is exact, and so is the end of the blend.
    const double back = weight * (1.0 - influence.t), back_rad = back * delta_rad;
    result.arc.turn_rad = delta_rad;
    result.arc.share = 1.0 - back;
    const SinCos turn = sinCos(-back_rad);
    result.n_W = turn.cos * tip_W + turn.sin * axis_W.cross(tip_W);
  }
  result.angles.theta_rad = angleOf(result.n_W);
  return result;
}

Influenced onCircle(const shape::Circle& circle, const Influence& influence, const Vec3& p_WT, const Vec3& stylus_W,
                    InfluenceState& state) noexcept UNDERACT_REAL_TIME {
  const Vec3 p_CT_W = p_WT - circle.p_WC, radial_W = perpendicularPart(circle.axis_W, p_CT_W);
  const double off_axis_m = radial_W.norm(), along_m = p_CT_W.dot(circle.axis_W);
  const bool on_axis = shape::isOnAxis(off_axis_m, circle.p_WC, p_WT);
  const Vec3 tip_W = on_axis ? Vec3::Zero() : Vec3(radial_W / off_axis_m);
  const Around at = around(circle.axis_W, influence, tip_W, on_axis, stylus_W, state);
  const double from_rim_m = off_axis_m - circle.radius_m;
  const double distance_m = std::sqrt(along_m * along_m + from_rim_m * from_rim_m);
  if (!at.is_unique) return {p_WT, at.angles, false, distance_m, {}};
  return {circle.p_WC + circle.radius_m * at.n_W, at.angles, true, distance_m,
          placed(at.arc, circle.p_WC, circle.radius_m)};
}

Influenced onCylinder(const shape::Cylinder& cylinder, const Influence& influence, const Vec3& p_WT,
                      const Vec3& stylus_W, InfluenceState& state) noexcept UNDERACT_REAL_TIME {
  const Vec3 p_CT_W = p_WT - cylinder.p_WC, radial_W = perpendicularPart(cylinder.axis_W, p_CT_W);
  const double off_axis_m = radial_W.norm();
  const bool on_axis = shape::isOnAxis(off_axis_m, cylinder.p_WC, p_WT);
  const Vec3 tip_W = on_axis ? Vec3::Zero() : Vec3(radial_W / off_axis_m);
  const Around at = around(cylinder.axis_W, influence, tip_W, on_axis, stylus_W, state);
  const double distance_m = std::abs(off_axis_m - cylinder.radius_m);
  if (!at.is_unique) return {p_WT, at.angles, false, distance_m, {}};
  const Vec3 p_WU = cylinder.p_WC + p_CT_W.dot(cylinder.axis_W) * cylinder.axis_W;
  return {p_WU + cylinder.radius_m * at.n_W, at.angles, true, distance_m, placed(at.arc, p_WU, cylinder.radius_m)};
}

/// The axis of the arc from the stylus's direction to the tip's. Near half a turn it is not determined within a tremor;
/// then the last determined axis is kept, and faded out as the directions leave the tie.
Vec3 arcAxis(const Vec3& from_W, const Vec3& to_W, double beta_rad, InfluenceState& state) noexcept UNDERACT_REAL_TIME {
  const Vec3 normal_W = from_W.cross(to_W);
  const double sine = normal_W.norm();
  const double known = sine > kNoDirection ? smooth((kPi - beta_rad) / kTie_rad) : 0.0;
  Vec3 about_W = known > 0.0 ? Vec3((known / sine) * normal_W) : Vec3::Zero();
  if (known < 1.0) {
    const Vec3 last_W = state.begun ? perpendicularPart(to_W, state.about_W) : Vec3::Zero();
    const double length = last_W.norm();
    if (length > 0.5) {
      about_W += ((1.0 - known) / length) * last_W;
    } else if (known > 0.0) {
      about_W = normal_W / sine;
    } else {
      about_W = referencePerpendicular(to_W);
    }
  }
  const double length = about_W.norm();
  if (!(length > kNoDirection)) return referencePerpendicular(to_W);
  if (known >= 1.0 || !state.begun) state.about_W = about_W / length;
  return about_W / length;
}

Influenced onSphere(const shape::Sphere& sphere, const Influence& influence, const Vec3& p_WT, const Vec3& stylus_W,
                    InfluenceState& state) noexcept UNDERACT_REAL_TIME {
  const Vec3 p_CT_W = p_WT - sphere.p_WC, from_W = influence.stylus_sign * stylus_W;
  const double off_m = p_CT_W.norm(), distance_m = std::abs(off_m - sphere.radius_m);
  if (shape::isOnAxis(off_m, sphere.p_WC, p_WT)) {  // the centre: orientation alone
    state.begun = false;
    Arc point;
    point.p_WPo = from_W;
    const Vec3 p_WP = sphere.p_WC + sphere.radius_m * from_W;
    return {p_WP, {0.0, kNotANumber, 0.0}, true, distance_m, placed(point, sphere.p_WC, sphere.radius_m)};
  }
  const Vec3 to_W = p_CT_W / off_m;
  const double beta_rad = atan2Of(from_W.cross(to_W).norm(), from_W.dot(to_W));
  const Vec3 about_W = arcAxis(from_W, to_W, beta_rad, state);
  state.delta_rad = beta_rad;
  state.begun = true;
  const SinCos back = sinCos(-(1.0 - influence.t) * beta_rad);
  const Vec3 n_W = back.cos * to_W + back.sin * about_W.cross(to_W);
  const Arc arc = placed({Vec3::Zero(), from_W, to_W, about_W, beta_rad, influence.t}, sphere.p_WC, sphere.radius_m);
  return {sphere.p_WC + sphere.radius_m * n_W, {0.0, beta_rad, influence.t * beta_rad}, true, distance_m, arc};
}

Influenced unslewed(const shape::Shape& shape, const Influence& influence, const Vec3& p_WT, const Vec3& stylus_W,
                    InfluenceState& state) noexcept UNDERACT_REAL_TIME {
  if (const auto* circle = std::get_if<shape::Circle>(&shape)) {
    return onCircle(*circle, influence, p_WT, stylus_W, state);
  }
  if (const auto* cylinder = std::get_if<shape::Cylinder>(&shape)) {
    return onCylinder(*cylinder, influence, p_WT, stylus_W, state);
  }
  if (const auto* sphere = std::get_if<shape::Sphere>(&shape)) {
    return onSphere(*sphere, influence, p_WT, stylus_W, state);
  }
  return {p_WT, {}, false, 0.0, {}};
}

/// last_W rotated towards to_W by at most max_rad; near half a turn the rotation is about about_W.
Vec3 turnedTowards(const Vec3& last_W, const Vec3& to_W, const Vec3& about_W,
                   double max_rad) noexcept UNDERACT_REAL_TIME {
  const Vec3 normal_W = last_W.cross(to_W);
  const double sine = normal_W.norm();
  if (atan2Of(sine, last_W.dot(to_W)) <= max_rad) return to_W;
  Vec3 axis_W = sine > kNoDirection ? Vec3(normal_W / sine) : perpendicularPart(last_W, about_W);
  const double length = axis_W.norm();
  axis_W = length > 0.5 ? Vec3(axis_W / length) : referencePerpendicular(last_W);
  const SinCos turn = sinCos(max_rad);
  const Vec3 n_W = turn.cos * last_W + turn.sin * axis_W.cross(last_W);
  return n_W / n_W.norm();
}

/// Limits the target to the arc that dt_s allows from the last one, and gives its angle there.
void slew(const shape::Shape& shape, const Influence& influence, const Vec3& stylus_W, double dt_s,
          InfluenceState& state, Influenced& found) noexcept UNDERACT_REAL_TIME {
  const Vec3 p_CP_W = found.p_WP - found.arc.p_WC;
  const double radius_m = p_CP_W.norm();
  if (!(radius_m > 0.0)) {  // lost in the rounding of a far position: there is no arc
    state.aims = false;
    return;
  }
  const Vec3 n_W = p_CP_W / radius_m;
  const bool limited = state.aims && dt_s > 0.0;
  const double max_rad = manipulator::kSlew_m_per_s * dt_s / radius_m;
  const Vec3 now_W = limited && max_rad < kPi ? turnedTowards(state.n_W, n_W, found.arc.axis_W, max_rad) : n_W;
  state.n_W = now_W;
  state.aims = true;
  if (now_W == n_W) return;
  found.p_WP = found.arc.p_WC + radius_m * now_W;
  const Vec3 from_W = influence.stylus_sign * stylus_W;
  found.angles.theta_rad = std::holds_alternative<shape::Sphere>(shape)
                               ? atan2Of(from_W.cross(now_W).norm(), from_W.dot(now_W))
                               : angleAround(found.arc.axis_W, now_W);
}

}  // namespace

Influenced influencedTarget(const shape::Shape& shape, const Influence& influence, const Vec3& p_WT,
                            const Vec3& stylus_W, double dt_s, InfluenceState& state) noexcept {
  Influenced found = unslewed(shape, influence, p_WT, stylus_W, state);
  if (found.is_unique) {
    slew(shape, influence, stylus_W, dt_s, state, found);
  } else {
    state.aims = false;
  }
  return found;
}

}  // namespace underact::target
