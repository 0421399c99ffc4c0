#include "core/mesh_union/keep.h"

#include <algorithm>
#include <numeric>
#include <tuple>

#include "core/mesh_union/winding.h"

namespace underact::mesh_union {
namespace {

constexpr std::size_t kRaysBetweenLooks = 256;  // for cancellation

/// Pieces that are connected across edges of two pieces: the winding number in front of them is the same.
class Patches {
 public:
  explicit Patches(std::size_t pieces) : of_(pieces) { std::iota(of_.begin(), of_.end(), 0); }
  std::int32_t lead(std::int32_t piece) {
    while (of_[static_cast<std::size_t>(piece)] != piece) {
      std::int32_t& next = of_[static_cast<std::size_t>(piece)];
      next = of_[static_cast<std::size_t>(next)];
      piece = next;
    }
    return piece;
  }
  void join(std::int32_t a, std::int32_t b) {
    a = lead(a), b = lead(b);
    of_[static_cast<std::size_t>(std::max(a, b))] = std::min(a, b);
  }

 private:
  std::vector<std::int32_t> of_;
};

Vec3 areaOf(const Points& points, const Piece& piece) {
  const Vec3& a = points.near(piece.corners[0]);
  return (points.near(piece.corners[1]) - a).cross(points.near(piece.corners[2]) - a);
}

}  // namespace

std::vector<PieceSide> sidesOf(const std::vector<Piece>& pieces) {
  std::vector<PieceSide> sides;
  sides.reserve(3 * pieces.size());
  for (std::size_t piece = 0; piece < pieces.size(); ++piece) {
    for (std::size_t k = 0; k < 3; ++k) {
      const std::int32_t from = pieces[piece].corners[k], to = pieces[piece].corners[(k + 1) % 3];
      sides.push_back({std::min(from, to), std::max(from, to), static_cast<std::int32_t>(piece),
                       static_cast<std::int8_t>(k), from < to});
    }
  }
  std::sort(sides.begin(), sides.end(), [](const PieceSide& a, const PieceSide& b) {
    return std::tie(a.low, a.high, a.piece) < std::tie(b.low, b.high, b.piece);
  });
  return sides;
}

std::optional<Kept> keep(const Grid& grid, const std::vector<mesh::Face>& faces, const Boxes& boxes,
                         const Points& points, const Arrangement& arrangement, const TaskMonitor& monitor) {
  const std::vector<Piece>& pieces = arrangement.pieces;
  Patches patches(pieces.size());
  bool closes = true;
  eachEdge(sidesOf(pieces), [&](const PieceSide* first, const PieceSide* last) {
    std::int32_t sum = 0;
    for (const PieceSide* side = first; side != last; ++side) {
      const std::int32_t times = pieces[static_cast<std::size_t>(side->piece)].times;
      sum += side->forward ? times : -times;
    }
    closes = closes && sum == 0;
    if (last - first == 2) patches.join(first[0].piece, first[1].piece);
  });
  if (!closes) return {};
  // Each patch is judged at its largest piece.
  std::vector<std::int32_t> largest(pieces.size(), -1), before(pieces.size(), 0);
  std::vector<double> sizes(pieces.size(), -1.0);
  for (std::size_t piece = 0; piece < pieces.size(); ++piece) {
    const auto lead = static_cast<std::size_t>(patches.lead(static_cast<std::int32_t>(piece)));
    const double size = areaOf(points, pieces[piece]).norm();
    if (!(size > sizes[lead])) continue;
    sizes[lead] = size;
    largest[lead] = static_cast<std::int32_t>(piece);
  }
  const Winding winding(grid, faces, boxes, arrangement.plane_of);
  std::size_t rays = 0;
  for (std::size_t lead = 0; lead < pieces.size(); ++lead) {
    if (largest[lead] < 0) continue;
    if (++rays % kRaysBetweenLooks == 0 && monitor.isCancelled()) return {};
    const Piece& piece = pieces[static_cast<std::size_t>(largest[lead])];
    const Vec3 middle =
        (points.near(piece.corners[0]) + points.near(piece.corners[1]) + points.near(piece.corners[2])) / 3.0;
    before[lead] = winding.before(middle, areaOf(points, piece).stableNormalized(),
                                  arrangement.plane_of[static_cast<std::size_t>(piece.face)], piece.times);
  }
  Kept kept;
  std::vector<std::uint8_t> is_there(faces.size(), 0);
  for (std::size_t index = 0; index < pieces.size(); ++index) {
    const Piece& piece = pieces[index];
    const std::int32_t front = before[static_cast<std::size_t>(patches.lead(static_cast<std::int32_t>(index)))];
    const bool is_kept = front <= 0 && front + piece.times > 0;
    kept.is_all = kept.is_all && is_kept;
    if (!is_kept) continue;
    is_there[static_cast<std::size_t>(piece.face)] = 1;
    kept.pieces.push_back(piece);
  }
  for (std::size_t face = 0; face < faces.size(); ++face) {
    const std::int32_t plane = arrangement.plane_of[face];
    const bool is_alone = plane == static_cast<std::int32_t>(face);
    kept.dropped += is_alone && is_there[face] == 0 ? 1 : 0;
    kept.is_all = kept.is_all && (is_alone || plane < 0);
  }
  return kept;
}

}  // namespace underact::mesh_union
