#pragma once
#include <cstdint>

#include "core/base/real_time.h"
#include "core/base/search.h"
#include "core/curve/curve.h"
#include "core/curve/found.h"

namespace underact::curve {

/// See core/base/search.h.
using underact::Search;

/// What a search remembers from tick to tick.
struct SearchState {
  std::int32_t piece = -1;  // the nearest one of the last tick; -1: none yet
};

/// The point P of the curve nearest to a tip T.
struct Nearest {
  Vec3 p_WP = Vec3::Zero();
  Vec3 tangent_W = Vec3::Zero();  // of the curve there, unit; at a corner, that of the piece
  double s_m = 0.0;               // arc length from the curve's begin
  double distance_m = 0.0;
  std::int32_t piece = -1;
  double u = 0.0;          // on the piece, in [0, 1]
  bool is_proved = false;  // proved to be the global minimum
  bool is_unique = false;  // false: another point, far apart (kFarApart), is as near within rounding
  int visits = 0;          // nodes and parts of pieces looked at; kMaxVisits at most
};

/// The greatest number of pieces that a walk goes each way along the curve: for Local a bound, so that a faster tip is
/// caught up with in the next ticks; for Hybrid enough for a first bound of the tree.
inline constexpr int kLongestWalk = 256;
inline constexpr int kHybridWalk = 8;

/// A tip beyond this is replaced by the point at this distance in its direction: from there the whole curve is one
/// direction.
inline constexpr double kFarthestTip_m = 1e6;

/// The point of the curve nearest to p_WT, m, any finite point. Where is_proved its distance is the least within 2^-43
/// of the largest coordinate (tip or curve) and 1e-13 of itself, of a polyline within 2^-49 of the largest coordinate.
/// Local: to the same precision no farther than the last piece, nor than those beside its own. Of equals the one from
/// the last piece stays, so that a tremor about a tie makes no jump. The first local search is a global one. A tip that
/// is not finite: the curve's begin, not proved, not unique; the state stays. Cost: bounded by kMaxVisits; past it the
/// best point so far counts, and is_proved is false.
Nearest nearestPoint(const Curve& curve, Search search, const Vec3& p_WT,
                     SearchState& state) noexcept UNDERACT_REAL_TIME;

}  // namespace underact::curve
