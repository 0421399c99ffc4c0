#pragma once
#include "core/base/real_time.h"
#include "core/curve/curve.h"
#include "core/curve/nearest.h"

namespace underact::curve {

/// Guidance along a curve. A guide point moves along it ahead of the point nearest to the hand; the target is between
/// the two by t, as with the influence factor between orientation and position.
struct Guidance {
  double t = 1.0;              // 1: the hand's own nearest point alone, 0: the guide's alone
  double speed_m_per_s = 0.0;  // speed of the guide, its sign the direction; 0: no guidance
  double lead_m = 0.01;        // the greatest lead of the guide along the curve, where it waits
};

/// The speed of the target itself: it could not keep up with a faster guide.
inline constexpr double kFastestGuidance_m_per_s = 2.0;
/// The target moves no faster than this beyond the motion of the hand itself, so that a change of branch, or of t, is
/// no jolt: at 0.5 N/mm the force grows by at most 1 N/ms. As for influence and virtual robots.
inline constexpr double kSlew_m_per_s = 2.0;
/// The greatest lead as a share of a closed curve's length, whatever lead_m says: further round, ahead would be behind.
inline constexpr double kMaxLeadShare = 0.25;

/// The state between ticks.
struct GuidanceState {
  double s_m = 0.0;          // of the guide, arc length
  Vec3 p_WT = Vec3::Zero();  // the last tip
  Vec3 p_WP = Vec3::Zero();  // the last target
  bool begun = false;
};

/// The result of guidedTarget().
struct GuidedTarget {
  Vec3 p_WP = Vec3::Zero();  // the target: on the curve, or on a straight line to it
  double s_m = 0.0;          // arc length of the point it is at, or moving to
  double guide_s_m = 0.0;    // of the guide; the hand's own where there is none
  bool is_slewing = false;   // it is moving to the curve
};

/// The target in this tick. nearest: of the tip p_WT; dt_s: since the last tick, 0: unknown, then the target is there
/// at once and the guide stays. The guide starts at the point nearest to the hand and advances by speed dt; it is never
/// behind the hand (so that it does not hold back a faster one) and never more than lead_m ahead (so that the force
/// along the curve is bounded by (1 - t) lead_m times the stiffness, and it waits for a resting hand); it stops at an
/// open end. p_WT not finite: the last target, and the state stays. Cost: that of pointAt().
GuidedTarget guidedTarget(const Curve& curve, const Guidance& guide, const Nearest& nearest, const Vec3& p_WT,
                          double dt_s, GuidanceState& state) noexcept UNDERACT_REAL_TIME;

}  // namespace underact::curve
