#pragma once
#include "core/base/real_time.h"
#include "core/curve/curve.h"
#include "core/curve/nearest.h"

namespace underact::curve {

/// How a hand is led along a curve. A guide point runs along it ahead of the hand's own nearest point; the target is
/// between the two by t, as the influence's is between orientation and position.
struct Guide {
  double t = 1.0;              // 1: the hand's own nearest point alone, 0: the guide's alone
  double speed_m_per_s = 0.0;  // a hint: how fast the guide runs, and (its sign) which way; 0: there is no guide
  double lead_m = 0.01;        // how far ahead of the hand the guide may be, along the curve: it waits there
};

/// As fast as the target may move by itself: a faster guide would never be caught up with.
inline constexpr double kFastestGuide_m_per_s = 2.0;
/// The target moves no faster than this beyond what the hand itself moves, so that a change of branch, or of t, is no
/// blow: at 0.5 N/mm the force grows by 1 N/ms at most. The same as for influence and virtual manipulators.
inline constexpr double kSlew_m_per_s = 2.0;
/// Of a closed curve's length that the guide may be ahead, whatever lead_m says: farther round, ahead would be behind.
inline constexpr double kMostLeadShare = 0.25;

/// All memory.
struct GuideState {
  double s_m = 0.0;          // of the guide, arc length
  Vec3 p_WT = Vec3::Zero();  // the last tip
  Vec3 p_WP = Vec3::Zero();  // the last target
  bool begun = false;
};

/// Where guidedTarget() draws the hand.
struct Guided {
  Vec3 p_WP = Vec3::Zero();  // the target: on the curve, or on a straight way there
  double s_m = 0.0;          // arc length of the point it is at, or on its way to
  double guide_s_m = 0.0;    // of the guide; the hand's own where there is none
  bool is_slewing = false;   // it is on its way
};

/// Where the hand is drawn to this tick. nearest: of the tip p_WT; dt_s: since the last tick, 0: unknown, then the
/// target is there at once and the guide stands. The guide starts at the hand's own place; runs on by speed dt; is
/// never behind the hand (so that it holds nobody back who is faster) and never more than lead_m ahead (so that the
/// pull along the curve is bounded by (1 - t) lead_m times the stiffness, and it waits for a hand that rests); and
/// stops at an open end. p_WT not finite: the last target, and the state stays. Cost: that of pointAt().
Guided guidedTarget(const Curve& curve, const Guide& guide, const Nearest& nearest, const Vec3& p_WT, double dt_s,
                    GuideState& state) noexcept UNDERACT_REAL_TIME;

}  // namespace underact::curve
