#pragma once
#include "core/base/real_time.h"
#include "core/base/valid_bytes.h"
#include "core/shape/shape.h"

namespace underact::target {

/// How position and orientation of the stylus are weighed in the target on a circle, a cylinder or a sphere.
struct Influence {
  double t = 1.0;            // 0: the orientation-nearest point alone, 1: the position-nearest point alone
  double stylus_sign = 1.0;  // the stylus's direction is +z of frame 6, or -z
  double blend_rad = 0.0;    // within this of the shape's axis the stylus's direction fades out
};

/// The angles of figure 5.7 about the shape's axis, rad, from the reference direction referencePerpendicular(); for a
/// sphere alpha is 0, beta the angle from the stylus's direction to the tip's, theta the target's between them. NaN:
/// undefined.
struct Angles {
  double alpha_rad = kNotANumber;  // of the stylus
  double beta_rad = kNotANumber;   // of the tip
  double theta_rad = kNotANumber;  // of the target
};

/// The arc that the target is on (figure 5.8): of the circle, of the cylinder at the tip's height, of a sphere's great
/// circle.
struct Arc {
  Vec3 p_WC = Vec3::Zero();                  // its centre
  Vec3 p_WPo = Vec3::Constant(kNotANumber);  // the orientation-nearest point; not a number where there is none
  Vec3 p_WPp = Vec3::Constant(kNotANumber);  // the position-nearest point
  Vec3 axis_W = Vec3::Zero();                // unit; zero where there is no arc
  double turn_rad = 0.0;  // about it, from p_WPo to p_WPp, as the target goes; 0 where one is missing
  double share = 0.0;     // of the turn, that the target has from p_WPo on: t, or more in the blend
};

/// The state between ticks: the sense of the last arc, and the last target.
struct InfluenceState {
  double delta_rad = 0.0;       // from alpha to beta, unwrapped by up to kTie_rad
  Vec3 about_W = Vec3::Zero();  // of a sphere: the axis of the last arc that was no tie
  bool begun = false;
  Vec3 n_W = Vec3::Zero();  // from the arc's centre to the last target, unit
  bool aims = false;        // there was a target
};

/// For bytes from a file: whether the state can be used.
inline bool isValid(const InfluenceState& state) noexcept {
  return isFlag(state.begun) && isFlag(state.aims);
}

/// The hysteresis about half a turn, by which the target stays on its arc, so that a tremor does not throw it to the
/// other side.
inline constexpr double kTie_rad = 0.2;

/// What influencedTarget() gives.
struct Influenced {
  Vec3 p_WP = Vec3::Zero();
  Angles angles;
  bool is_unique = false;   // false: neither tip nor stylus determines it; p_WP is the tip
  double distance_m = 0.0;  // of the tip from the shape
  Arc arc;
};

/// The target between orientation-nearest and position-nearest point, along the shorter arc: theta = alpha + t
/// wrap(beta - alpha). p_WT: m, finite; stylus_W: z of frame 6, unit. A stylus along the axis has no direction, so the
/// target goes over to position smoothly within blend_rad; with the tip on the axis, orientation alone counts; both:
/// not unique. Any other shape: not unique. dt_s: since the last tick; the target moves along the arc no faster than
/// manipulator::kSlew_m_per_s, so that a change of sides is no jolt; 0: at once. Within 64 ulp of the largest
/// coordinate, and of R over the distance of tip and stylus from the axis. Cost: constant. Source: Beckman 2007, eq.
/// 5.1-5.4 (errata 5.3, 5.4; 3-D form of errata section 4).
Influenced influencedTarget(const shape::Shape& shape, const Influence& influence, const Vec3& p_WT,
                            const Vec3& stylus_W, double dt_s, InfluenceState& state) noexcept UNDERACT_REAL_TIME;

}  // namespace underact::target
