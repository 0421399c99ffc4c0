#pragma once
#include <cmath>
#include <cstdint>
#include <utility>

#include "core/base/real_time.h"
#include "core/base/types.h"

namespace underact::curve {

/// Nodes of the tree and parts of pieces that one search looks at, at most: it bounds the time where very many are
/// nearly equally near (the centre of a circle).
inline constexpr int kMaxVisits = 2000;

/// Two points are far apart where their directions from the tip differ by more than this, rad.
inline constexpr double kFarApart = 1e-3;

/// A point of the curve as a search found it, m; piece -1: none.
struct Candidate {
  double squared = kInfinity;  // of its distance
  Vec3 p_W = Vec3::Zero();
  std::int32_t piece = -1;
  double u = 0.0;
};

/// What a search has found so far.
struct Found {
  double tie_m = 0.0;  // distances that differ by less are equal within rounding
  Candidate best;
  Candidate rival;           // the nearest one that is far apart from the best
  double limit = kInfinity;  // the squared distance beyond which nothing matters
  int visits = 0;
  bool is_cut = false;  // something nearer may have been left out
};

/// Whether they are further apart than kFarApart times the greater of their distances from the tip.
inline bool areFarApart(const Candidate& a, const Candidate& b) noexcept UNDERACT_REAL_TIME {
  return (a.p_W - b.p_W).squaredNorm() > kFarApart * kFarApart * (a.squared < b.squared ? b.squared : a.squared);
}

/// Takes a candidate into account; of equals the first stays. The former best is nearer than any rival, so it becomes
/// the rival; unless it is close to the new best, and then the rival is as far apart as before.
inline void offer(Candidate candidate, Found& found) noexcept UNDERACT_REAL_TIME {
  if (candidate.squared < found.best.squared) {
    std::swap(candidate, found.best);
    const double distance_m = std::sqrt(found.best.squared) + found.tie_m;
    found.limit = distance_m * distance_m;
  }
  if (candidate.piece < 0 || !(candidate.squared < found.rival.squared)) return;
  if (areFarApart(candidate, found.best)) found.rival = candidate;
}

/// Counts a visit. false: the maximum is reached.
inline bool visit(Found& found) noexcept UNDERACT_REAL_TIME {
  if (found.visits >= kMaxVisits) {
    found.is_cut = true;
    return false;
  }
  ++found.visits;
  return true;
}

}  // namespace underact::curve
