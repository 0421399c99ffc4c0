#include "core/mesh/cut.h"

#include <algorithm>

#include "core/mesh/box_bounds.h"

namespace underact::mesh {
namespace {

using Level = std::array<std::int32_t, Cut::kMax + kChildren>;

/// The children of the cut's nodes that are within its reach; gives their number. 0: they are faces, or too many.
std::size_t levelBelow(const Surface& surface, const Cut& cut, Level& level, int& visits) noexcept UNDERACT_REAL_TIME {
  std::size_t size = 0;
  for (std::size_t place = 0; place < cut.size; ++place) {
    const Node& node = surface.nodes[static_cast<std::size_t>(cut.nodes[place])];
    if (node.children[0] < 0) return 0;
    size += addChildren(node, boundsOf(node, cut.q_M, cut.reach * cut.reach).nearer, &level[size]);
    ++visits;
    if (size > Cut::kMax) return 0;
  }
  return size;
}

/// Whether the cut is of this surface: a state may come from a recording, which may be damaged.
bool isOf(const Cut& cut, const Surface& surface) noexcept UNDERACT_REAL_TIME {
  // The highest bit of one of these is set where a node is below 0 or above the last: four at once.
  const auto last = static_cast<std::uint32_t>(surface.nodes.size() - 1);
  std::uint32_t beyond = 0;
  for (const std::int32_t node : cut.nodes)
    beyond |= static_cast<std::uint32_t>(node) | (last - static_cast<std::uint32_t>(node));
  return beyond >> 31U == 0 && cut.size >= 1 && cut.size <= Cut::kMax && cut.surface == surface.mark;
}

}  // namespace

bool holds(const Cut& cut, const Surface& surface, const Vec3& q_M, double distance) noexcept {
  constexpr double kRounding = 1.0 + 1e-14;  // of two roots and a sum
  return isOf(cut, surface) && kRounding * ((q_M - cut.q_M).norm() + distance) <= cut.reach;
}

Cut makeCut(const Surface& surface, const Vec3& q_M, double reach, int& visits) noexcept {
  Cut cut{q_M, reach, surface.mark, 0, 1, {}};
  Level level;  // not initialised
  while (const std::size_t size = levelBelow(surface, cut, level, visits)) {
    std::copy_n(level.begin(), size, cut.nodes.begin());
    cut.size = static_cast<std::uint32_t>(size);
  }
  return cut;
}

Cut nextCut(const Cut& cut, const Surface& surface, const Vec3& q_M, double distance, int& visits) noexcept {
  // With fewer, cuts are renewed too often; with more, they have too many nodes: of 3 to 8 all were within 5 % along a
  // hand's path.
  constexpr double kSearches = 5.0;
  const double step = cut.served > 0 ? (q_M - cut.q_M).norm() / cut.served : 0.0;
  return makeCut(surface, q_M, distance + kSearches * step, visits);
}

}  // namespace underact::mesh
