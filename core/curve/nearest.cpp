#include "core/curve/nearest.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "core/base/norms.h"
#include "core/curve/along.h"
#include "core/curve/on_piece.h"

namespace underact::curve {
namespace {

/// The rounding of a distance, relative to the largest coordinate, in the tree's boxes and the parts of cubics too.
constexpr double kRounding = 0x1p-43;

/// A node, or below the bottom level a piece, that is still to be looked at.
struct Waiting {
  double squared = 0.0;  // nothing in it is nearer
  std::int32_t level = 0;
  std::int32_t index = 0;
};

constexpr std::size_t kMaxWaiting = 3 * Boxes::kMaxLevels + 4;

/// Puts the children of a node on the stack, the nearest on top.
void pushChildren(const Boxes& boxes, const Waiting& node, const Vec3& q_O, double limit,
                  std::array<Waiting, kMaxWaiting>& stack, std::size_t& count) noexcept UNDERACT_REAL_TIME {
  const auto level = static_cast<std::size_t>(node.level);
  const Node& boxed = boxes.nodes[static_cast<std::size_t>(boxes.begins[level] + node.index)];
  const std::array<double, 4> squares = squaredDistances(boxed, q_O);
  const std::size_t bottom = count;
  const std::int32_t children = std::min(4, boxes.counts[level + 1] - 4 * node.index);
  for (std::int32_t i = 0; i < children; ++i) {
    const double squared = squares[static_cast<std::size_t>(i)];
    if (squared > limit) continue;
    std::size_t at = count++;
    for (; at > bottom && stack[at - 1].squared < squared; --at) stack[at] = stack[at - 1];
    stack[at] = {squared, node.level + 1, 4 * node.index + i};
  }
}

/// The pieces seen by a walk: so many ahead of its first one, and behind it.
struct Walked {
  std::int32_t from = -1;
  std::int32_t ahead = 0;
  std::int32_t behind = 0;
};

bool isIn(const Walked& walked, std::int32_t piece, const Curve& curve) noexcept UNDERACT_REAL_TIME {
  if (walked.from < 0) return false;
  const std::int32_t on = piece - walked.from, pieces = curve.is_closed ? pieceCount(curve) : 0;
  const std::int32_t round = on < 0 ? on + pieces : on - pieces;  // the other way to it, of a closed curve
  const auto isSeen = [&](std::int32_t offset) { return offset >= -walked.behind && offset <= walked.ahead; };
  return isSeen(on) || (curve.is_closed && isSeen(round));
}

void seekInTree(const Curve& curve, const Vec3& q_W, const Walked& walked, Found& found) noexcept UNDERACT_REAL_TIME {
  const Vec3 q_O = q_W - curve.boxes.p_WO;
  std::array<Waiting, kMaxWaiting> stack;
  std::size_t count = 1;
  stack[0] = {};
  while (count > 0) {
    const Waiting next = stack[--count];
    if (next.squared > found.limit) continue;
    if (next.level == curve.boxes.levels) {
      if (!isIn(walked, next.index, curve)) seekOnPiece(curve, next.index, q_W, found);
    } else if (visit(found)) {
      pushChildren(curve.boxes, next, q_O, found.limit, stack, count);
    }
    if (found.is_cut) return;
  }
}

/// The next piece along the curve, or the one before (by -1); -1: there is none.
std::int32_t neighbourOf(const Curve& curve, std::int32_t piece, std::int32_t by) noexcept UNDERACT_REAL_TIME {
  const std::int32_t pieces = pieceCount(curve), next = piece + by;
  if (next >= 0 && next < pieces) return next;
  return curve.is_closed ? (next < 0 ? pieces - 1 : 0) : -1;
}

/// Walks from a piece in both directions while the distance decreases. Its neighbours are looked at even where the foot
/// is inside it: behind a sharp corner it stays inside when the hand has gone round.
Walked walk(const Curve& curve, std::int32_t from, int max, const Vec3& q_W, Found& found) noexcept UNDERACT_REAL_TIME {
  Walked walked{from, 0, 0};
  seekOnPiece(curve, from, q_W, found);
  for (const std::int32_t by : {1, -1}) {
    std::int32_t piece = from;
    for (int step = 0; step < max; ++step) {
      piece = neighbourOf(curve, piece, by);
      if (piece < 0) break;
      const double before = found.best.squared;
      seekOnPiece(curve, piece, q_W, found);
      ++(by > 0 ? walked.ahead : walked.behind);
      if (!(found.best.squared < before)) break;
    }
  }
  return walked;
}

/// The length of a vector without overflow of its square; the largest double where the length itself overflows.
double lengthOfAny(const Vec3& v) noexcept UNDERACT_REAL_TIME {
  const double largest = largestOf(v);
  if (!(largest > 0.0)) return 0.0;
  return std::min(largest * (v / largest).norm(), std::numeric_limits<double>::max());
}

Nearest described(const Curve& curve, const Found& found, const Vec3& p_WT) noexcept UNDERACT_REAL_TIME {
  const Candidate& best = found.best;
  Nearest nearest;
  nearest.p_WP = best.p_W;
  nearest.tangent_W = tangentOn(curve, best.piece, best.u);
  nearest.s_m = arcLengthAt(curve, best.piece, best.u);
  nearest.distance_m = lengthOfAny(0.5 * p_WT - 0.5 * best.p_W);
  nearest.distance_m = std::min(2.0 * nearest.distance_m, std::numeric_limits<double>::max());
  nearest.piece = best.piece;
  nearest.u = best.u;
  nearest.is_unique = !(found.rival.squared <= found.limit);
  nearest.visits = found.visits;
  return nearest;
}

}  // namespace

Nearest nearestPoint(const Curve& curve, Search search, const Vec3& p_WT, SearchState& state) noexcept {
  if (!p_WT.allFinite()) {
    Nearest none;
    none.p_WP = pointOn(curve, 0, 0.0);
    none.tangent_W = tangentOn(curve, 0, 0.0);
    none.piece = 0;
    return none;
  }
  const double farthest_m = largestOf(p_WT);
  const Vec3 q_W = farthest_m > kFarthestTip_m ? Vec3(p_WT / farthest_m * kFarthestTip_m) : p_WT;
  Found found;
  found.tie_m = kRounding * std::max(std::min(farthest_m, kFarthestTip_m), curve.largest_m);
  const bool is_warm = state.piece >= 0 && state.piece < pieceCount(curve);
  const bool walks = is_warm && search != Search::Global, is_local = is_warm && search == Search::Local;
  Walked walked;
  if (walks) walked = walk(curve, state.piece, is_local ? kLongestWalk : kHybridWalk, q_W, found);
  if (!is_local) seekInTree(curve, q_W, walked, found);
  Nearest nearest = described(curve, found, p_WT);
  nearest.is_proved = !is_local && !found.is_cut;
  state.piece = nearest.piece;
  return nearest;
}

}  // namespace underact::curve
