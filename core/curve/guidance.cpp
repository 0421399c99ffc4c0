#include "core/curve/guidance.h"

#include <algorithm>
#include <cmath>

#include "core/curve/along.h"

namespace underact::curve {
namespace {

/// The lead of the guide after this tick, m, in its direction.
double aheadOf(const Curve& curve, const Guidance& guide, double hand_s_m, double dt_s,
               const GuidanceState& state) noexcept UNDERACT_REAL_TIME {
  const double max_m = curve.is_closed ? std::min(guide.lead_m, kMaxLeadShare * lengthOf(curve)) : guide.lead_m;
  if (!state.begun) return 0.0;
  const double sign = guide.speed_m_per_s < 0.0 ? -1.0 : 1.0;
  const double ahead_m = sign * arcLengthBetween(curve, hand_s_m, state.s_m) + std::abs(guide.speed_m_per_s) * dt_s;
  return std::clamp(ahead_m, 0.0, max_m);
}

/// Moves from the last target to the new one, no farther than a tick allows.
void slew(const Vec3& p_WT, double dt_s, const GuidanceState& state, GuidedTarget& guided) noexcept UNDERACT_REAL_TIME {
  if (!state.begun || !(dt_s > 0.0)) return;
  const double reach_m = kSlew_m_per_s * dt_s + (p_WT - state.p_WT).norm();
  const Vec3 gap_W = guided.p_WP - state.p_WP;
  const double gap_m = gap_W.norm();
  if (!(gap_m > reach_m)) return;
  guided.p_WP = state.p_WP + (reach_m / gap_m) * gap_W;
  guided.is_slewing = true;
}

}  // namespace

GuidedTarget guidedTarget(const Curve& curve, const Guidance& guide, const Nearest& nearest, const Vec3& p_WT,
                          double dt_s, GuidanceState& state) noexcept {
  if (!p_WT.allFinite()) return {state.begun ? state.p_WP : nearest.p_WP, state.s_m, state.s_m, false};
  const double time_s = dt_s > 0.0 && std::isfinite(dt_s) ? dt_s : 0.0;
  GuidedTarget guided{nearest.p_WP, nearest.s_m, nearest.s_m, false};
  if (guide.speed_m_per_s != 0.0) {
    const double sign = guide.speed_m_per_s < 0.0 ? -1.0 : 1.0;
    const double ahead_m = aheadOf(curve, guide, nearest.s_m, time_s, state);
    guided.guide_s_m = wrappedArcLength(curve, nearest.s_m + sign * ahead_m);
    const double share_m = (1.0 - guide.t) * arcLengthBetween(curve, nearest.s_m, guided.guide_s_m);
    if (share_m != 0.0) {  // otherwise exactly the nearest point
      guided.s_m = wrappedArcLength(curve, nearest.s_m + share_m);
      guided.p_WP = pointAt(curve, guided.s_m);
    }
  }
  slew(p_WT, time_s, state, guided);
  state = {guided.guide_s_m, p_WT, guided.p_WP, true};
  return guided;
}

}  // namespace underact::curve
